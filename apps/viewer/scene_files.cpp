// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "viewer/scene_files.h"

#include "cli/errors.h"
#include "io/pcd.h"

#include <Eigen/Core>

#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>

namespace pcl::app {

JsonValue
JsonValue::read(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream.is_open() || stream.bad())
    throw InputError(path + ": cannot be read: allowed is a JSON file");
  auto value = nlohmann::json::parse(text, nullptr, false);
  if (!value.is_object())
    throw InputError(path + ": is no JSON object: allowed is a file that one of the "
                            "applications wrote");
  return {path, "", std::move(value)};
}

void
JsonValue::fail(const std::string& allowed) const
{
  using Handler = nlohmann::json::error_handler_t;
  throw InputError(path_ + ": '" + place_ + "' is " +
                   app::quoted(value_.dump(-1, ' ', true, Handler::replace)) +
                   ": allowed is " + allowed);
}

bool
JsonValue::has(const std::string& member) const
{
  return value_.is_object() && value_.contains(member);
}

JsonValue
JsonValue::at(const std::string& member) const
{
  if (!has(member))
    throw InputError(path_ + ": '" + (place_.empty() ? "" : place_ + '.') + member +
                     "' is missing");
  return {path_, place_.empty() ? member : place_ + '.' + member, value_[member]};
}

std::vector<JsonValue>
JsonValue::array() const
{
  if (!value_.is_array())
    fail("an array");
  std::vector<JsonValue> values;
  values.reserve(value_.size());
  for (std::size_t i = 0; i < value_.size(); ++i)
    values.push_back({path_, place_ + '[' + std::to_string(i) + ']', value_[i]});
  return values;
}

std::string
JsonValue::text() const
{
  if (!value_.is_string())
    fail("a text");
  return value_.get<std::string>();
}

bool
JsonValue::flag() const
{
  if (!value_.is_boolean())
    fail("true or false");
  return value_.get<bool>();
}

float
JsonValue::number() const
{
  const bool is_number = value_.is_number();
  if (!is_number || !std::isfinite(value_.get<float>()))
    fail("a finite number");
  return value_.get<float>();
}

std::uint32_t
JsonValue::count() const
{
  if (!value_.is_number_unsigned() ||
      value_.get<std::uint64_t>() > std::numeric_limits<std::uint32_t>::max())
    fail("a whole number from 0 to 4294967295");
  return value_.get<std::uint32_t>();
}

std::array<float, 3>
JsonValue::vector() const
{
  if (!value_.is_array() || value_.size() != 3)
    fail("three finite numbers");
  const std::vector<JsonValue> values = array();
  return {values[0].number(), values[1].number(), values[2].number()};
}

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
