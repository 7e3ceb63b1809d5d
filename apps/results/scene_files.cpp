// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Reads lines, instances and grasps; errors name the place in the file.

#include "results/scene_files.h"

#include "io/errors.h"
#include "io/files.h"
#include "io/text.h"

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>
#include <optional>

namespace pcl::app {
namespace {

using Json = nlohmann::ordered_json;

/** A value of a file and its place there, such as lines[0].spacing. */
struct Value {
  const std::string& path;
  std::string place;
  const Json& json;

  [[noreturn]] void
  fail(const std::string& expected) const
  {
    throw InputError(
        path + ": '" + place + "' is " +
        inQuotes(json.dump(-1, ' ', true, Json::error_handler_t::replace)) +
        "; expected " + expected);
  }

  void
  require(bool condition, const std::string& expected) const
  {
    if (!condition)
      fail(expected);
  }

  bool
  has(const std::string& member) const
  {
    return json.is_object() && json.contains(member);
  }

  Value
  at(const std::string& member) const
  {
    const std::string inside = (place.empty() ? "" : place + '.') + member;
    if (!has(member))
      throw InputError(path + ": expected '" + inside + "', which is missing");
    return {path, inside, json[member]};
  }

  std::vector<Value>
  array() const
  {
    require(json.is_array(), "an array");
    std::vector<Value> values;
    for (std::size_t i = 0; i < json.size(); ++i)
      values.push_back({path, place + '[' + std::to_string(i) + ']', json[i]});
    return values;
  }

  std::string
  text() const
  {
    require(json.is_string(), "a text");
    return json.get<std::string>();
  }

  float
  number() const
  {
    require(json.is_number() && std::isfinite(json.get<float>()), "a finite number");
    return json.get<float>();
  }

  float
  length() const
  {
    require(number() > 0.0f, "a positive length");
    return number();
  }

  Vector
  vector() const
  {
    require(json.is_array() && json.size() == 3, "three finite numbers");
    const std::vector<Value> values = array();
    return {values[0].number(), values[1].number(), values[2].number()};
  }
};

Json
readJson(const std::string& path)
{
  Json json = Json::parse(readFile(path, "a JSON file"), nullptr, false);
  if (!json.is_object())
    throw InputError(path + ": is no JSON object; expected a file that one of the "
                            "applications wrote");
  return json;
}

Line
lineOf(const Value& value)
{
  Line line{{}, value.at("spacing").length()};
  for (const Value& point : value.at("points").array())
    line.points.push_back(point.vector());
  value.at("points").require(line.points.size() >= 2, "two points or more");
  return line;
}

std::uint32_t
numberOf(const Value& value, std::uint64_t min = 0)
{
  constexpr std::uint64_t max = std::numeric_limits<std::uint32_t>::max();
  value.require(value.json.is_number_unsigned() &&
                    value.json.get<std::uint64_t>() >= min &&
                    value.json.get<std::uint64_t>() <= max,
                "a whole number from " + std::to_string(min) + " to 4294967295");
  return value.json.get<std::uint32_t>();
}

Instance
instanceOf(const Value& value)
{
  std::string name = value.at("class").text();
  if (value.has("primitive") && value.at("primitive").has("type"))
    name += ", " + value.at("primitive").at("type").text();
  return {numberOf(value.at("id")), name, value.at("centroid").vector()};
}

Grasp
graspOf(const Value& value)
{
  const Value seals = value.at("seals");
  seals.require(seals.json.is_boolean(), "true or false");
  Grasp grasp{value.at("position").vector(),
              value.at("approach").vector(),
              seals.json.get<bool>()};
  const float length = Eigen::Map<const Eigen::Vector3f>(grasp.approach.data()).norm();
  value.at("approach").require(std::abs(length - 1.0f) < 0.01f, "a vector of length 1");
  if (value.has("problems"))
    for (const Value& problem : value.at("problems").array())
      grasp.problems.push_back(problem.text());
  return grasp;
}

/** The member of the file, or of its "parameters". */
std::optional<float>
cupRadiusOf(const Value& file)
{
  if (file.has("cup_radius"))
    return file.at("cup_radius").length();
  if (file.has("parameters") && file.at("parameters").has("cup_radius"))
    return file.at("parameters").at("cup_radius").length();
  return std::nullopt;
}

/** Without grasps. */
GraspsOfObjects
cupOf(const Value& parameters)
{
  GraspsOfObjects grasps{};
  grasps.parts = numberOf(parameters.at("parts"), 1);
  grasps.cup_radius = parameters.at("cup_radius").length();
  const Value compliance = parameters.at("compliance");
  compliance.require(compliance.number() >= 0.0f && compliance.number() <= 1.0f,
                     "a number from 0 to 1");
  grasps.compliance = compliance.json.get<double>();
  return grasps;
}

} // namespace

std::vector<Line>
readLines(const std::string& path)
{
  const Json json = readJson(path);
  const Value file{path, "", json};
  file.at("format").require(file.at("format").text() == "pcl_shape lines",
                            "'pcl_shape lines'");
  file.at("version").require(file.at("version").number() == 1.0f, "1");
  std::vector<Line> lines;
  for (const Value& line : file.at("lines").array())
    lines.push_back(lineOf(line));
  return lines;
}

std::vector<Instance>
readInstances(const std::string& path)
{
  const Json json = readJson(path);
  std::vector<Instance> instances;
  for (const Value& value : Value{path, "", json}.at("instances").array())
    instances.push_back(instanceOf(value));
  return instances;
}

Grasps
readGrasps(const std::string& path)
{
  const Json json = readJson(path);
  const Value file{path, "", json};
  constexpr float default_cup_radius = 0.01f; // meters, as pcl_shape_grasp's
  Grasps grasps{{}, cupRadiusOf(file).value_or(default_cup_radius)};
  for (const Value& grasp : file.at("grasps").array())
    grasps.grasps.push_back(graspOf(grasp));
  return grasps;
}

GraspsOfObjects
readGraspsOfObjects(const std::string& path)
{
  const Json json = readJson(path);
  const Value file{path, "", json};
  const std::vector<Value> values = file.at("grasps").array();
  if (!file.at("parameters").has("each"))
    throw InputError(path + ": 'parameters.each' is missing; expected what "
                            "pcl_shape_grasp -each wrote with -json");
  GraspsOfObjects grasps = cupOf(file.at("parameters"));
  grasps.field = file.at("parameters").at("each").text();
  for (const Value& value : values) {
    grasps.grasps.push_back(graspOf(value));
    grasps.grasps.back().object = numberOf(value.at("object"), 1);
  }
  return grasps;
}

} // namespace pcl::app
