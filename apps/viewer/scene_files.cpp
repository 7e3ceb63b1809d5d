/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "scene_files.h"

#include "json_value.h"

#include <Eigen/Core>

namespace pcl::app {
namespace {

constexpr float default_cup_radius = 0.02f; // metres

Line
lineOf(const JsonValue& value)
{
  Line line{{}, value.at("spacing").number()};
  for (const JsonValue& point : value.at("points").array())
    line.points.push_back(point.vector());
  if (line.points.size() < 2)
    value.at("points").fail("two points or more");
  if (!(line.spacing > 0.0f))
    value.at("spacing").fail("a positive length");
  return line;
}

std::string
nameOf(const JsonValue& instance)
{
  std::string name = instance.at("class").text();
  if (instance.has("primitive") && instance.at("primitive").has("type"))
    name += ", " + instance.at("primitive").at("type").text();
  return name;
}

Grasp
graspOf(const JsonValue& value)
{
  Grasp grasp{value.at("position").vector(),
              value.at("approach").vector(),
              value.at("seals").flag()};
  const float length = Eigen::Map<const Eigen::Vector3f>(grasp.approach.data()).norm();
  if (!(std::abs(length - 1.0f) < 0.01f))
    value.at("approach").fail("a vector of length 1");
  return grasp;
}

/** The member of the file, or of its "parameters". */
float
cupRadiusOf(const JsonValue& file)
{
  const JsonValue& parameters = file.has("parameters") ? file.at("parameters") : file;
  for (const JsonValue& place : {file, parameters})
    if (place.has("cup_radius")) {
      const float radius = place.at("cup_radius").number();
      if (!(radius > 0.0f))
        place.at("cup_radius").fail("a positive length");
      return radius;
    }
  return default_cup_radius;
}

} // namespace

std::vector<Line>
readLines(const std::string& path)
{
  const JsonValue file = JsonValue::read(path);
  if (file.at("format").text() != "pcl_shape lines")
    file.at("format").fail("'pcl_shape lines'");
  if (file.at("version").number() != 1.0f)
    file.at("version").fail("1");
  std::vector<Line> lines;
  for (const JsonValue& line : file.at("lines").array())
    lines.push_back(lineOf(line));
  return lines;
}

std::vector<Instance>
readInstances(const std::string& path)
{
  std::vector<Instance> instances;
  for (const JsonValue& value : JsonValue::read(path).at("instances").array())
    instances.push_back(
        {value.at("id").count(), nameOf(value), value.at("centroid").vector()});
  return instances;
}

Grasps
readGrasps(const std::string& path)
{
  const JsonValue file = JsonValue::read(path);
  Grasps grasps{{}, cupRadiusOf(file)};
  for (const JsonValue& grasp : file.at("grasps").array())
    grasps.grasps.push_back(graspOf(grasp));
  return grasps;
}

} // namespace pcl::app
