// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Reads any cloud, and brings its coordinates within the reach of float.

#include "cli/input.h"

#include "io/any_cloud.h"

#include <pcl/features/coordinate_offset.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <type_traits>

namespace pcl::app {

std::optional<std::array<double, 3>>
givenOffset(const Arguments& arguments)
{
  const auto numbers = arguments.numbers("offset", 3, "three numbers of meters, X,Y,Z");
  if (!numbers)
    return std::nullopt;
  return std::array<double, 3>{(*numbers)[0], (*numbers)[1], (*numbers)[2]};
}

bool
exceedFloats(const CloudFile& cloud)
{
  for (const char* const name : {"x", "y", "z"})
    if (const pcl::PCLPointField* const field = findField(cloud, name);
        field && field->datatype != pcl::PCLPointField::FLOAT32 &&
        valueSize(field->datatype) >= sizeof(float))
      return true;
  return false;
}

namespace {

std::string
toText(const std::array<double, 3>& vector)
{
  std::string text;
  for (const double value : vector) {
    text += text.empty() ? "" : ",";
    char digits[400]; // 309 before the point, as 500000 is easier to read than 5e+05
    text.append(
        digits,
        std::to_chars(digits, std::end(digits), value, std::chars_format::fixed).ptr);
  }
  return text;
}

template <typename Value>
Value
valueAt(const CloudFile& cloud, std::size_t point, const pcl::PCLPointField& field)
{
  Value value;
  std::memcpy(&value, cloud.at(point, field), sizeof(value));
  return value;
}

bool
areFloats(const std::array<pcl::PCLPointField, 3>& fields)
{
  return std::all_of(fields.begin(), fields.end(), [](const auto& field) {
    return field.datatype == pcl::PCLPointField::FLOAT32;
  });
}

/** A coordinate of a point as it is before it becomes a float. */
double
beforeFloat(const CloudFile& cloud,
            std::size_t point,
            const pcl::PCLPointField& field,
            double offset)
{
  return visitType(field.datatype, [&](auto value) {
    constexpr bool is_float = std::is_same_v<decltype(value), float>;
    return static_cast<double>(valueAt<decltype(value)>(cloud, point, field)) -
           (is_float ? 0.0 : offset);
  });
}

void
warnOfRounding(const Arguments& arguments, const CloudFile& cloud, Report& report)
{
  const auto &x = *findField(cloud, "x"), &y = *findField(cloud, "y"),
             &z = *findField(cloud, "z");
  const auto pointAt = [&](std::size_t i) {
    return std::array<double, 3>{beforeFloat(cloud, i, x, cloud.offset[0]),
                                 beforeFloat(cloud, i, y, cloud.offset[1]),
                                 beforeFloat(cloud, i, z, cloud.offset[2])};
  };
  const auto floatsAt = [&](std::size_t i) {
    return std::array<double, 3>{valueAt<float>(cloud, i, x),
                                 valueAt<float>(cloud, i, y),
                                 valueAt<float>(cloud, i, z)};
  };
  const bool are_floats = areFloats({x, y, z});
  const double step = are_floats ? pcl::destructiveFloatSpacing(cloud.size(), floatsAt)
                                 : pcl::destructiveFloatSpacing(cloud.size(), pointAt);
  if (step == 0.0)
    return;
  report.setFlag("parameters", "rounded_coordinates", true);
  char text[128]; // two numbers of up to 12 characters
  std::snprintf(
      text,
      sizeof(text),
      "float holds them in steps of %.3g, while the points are about %.3g apart",
      step,
      pcl::coordinateScale(coordinatesOf(cloud)).spacing);
  // Doubles come here with -offset alone.
  const bool exceed_floats = exceedFloats(cloud);
  const std::string problem = exceed_floats
                                  ? "with -offset '" + arguments.text("offset") +
                                        "' the coordinates are too large for float: "
                                  : "the coordinates are too large for their type: ";
  logLine(arguments.app() + ": " + cloud.path + ": warning: " + problem + text +
          (exceed_floats ? "; expected an offset near the middle of the cloud"
                         : "; expected coordinates in double, or with an offset "
                           "subtracted before they became floats"));
}

} // namespace

void
addInputOptions(CommandLine& command_line)
{
  command_line
      .option("offset",
              "X,Y,Z",
              "subtracted in double from the coordinates, which the output keeps\n(for "
              "doubles too large for float: near the middle of the cloud)")
      .option("floats", "N", "of a point in a .bin file: 4 (KITTI) or 5 (nuScenes)");
}

void
checkInputOptions(const Arguments& arguments)
{
  givenOffset(arguments);
  floatsOfBin(arguments);
}

unsigned
floatsOfBin(const Arguments& arguments)
{
  return static_cast<unsigned>(arguments.integer("floats", 4, 5).value_or(0));
}

void
logOffset(const Arguments& arguments,
          const std::string& cloud,
          const std::array<double, 3>& offset)
{
  if (offset == std::array<double, 3>{})
    return;
  logLine(
      arguments.app() + ": " + cloud + ": offset " + toText(offset) +
      " is subtracted from the coordinates" +
      (givenOffset(arguments) ? "" : ", which are too large for float (see -offset)"));
}

void
chooseOffset(const Arguments& arguments, CloudFile& cloud, Report& report)
{
  if (!findField(cloud, "x") || !findField(cloud, "y") || !findField(cloud, "z"))
    return; // refused where the points are needed
  const auto given = givenOffset(arguments);
  const bool exceed_floats = exceedFloats(cloud);
  if (given)
    cloud.offset = *given;
  else if (exceed_floats)
    cloud.offset = pcl::coordinateOffset(coordinatesOf(cloud));
  const bool has_offset = cloud.offset != std::array<double, 3>{};
  if (has_offset && !given) {
    // No scanner reaches that far: a viewpoint at the origin means that it is unknown.
    const auto& v = cloud.viewpoint;
    cloud.is_view_known = v[0] != 0.0f || v[1] != 0.0f || v[2] != 0.0f;
  }
  logOffset(arguments, cloud.path, cloud.offset);
  if (given || exceed_floats)
    report.setJson("parameters", "offset", cloud.offset);
  if (!exceed_floats || given)
    warnOfRounding(arguments, cloud, report);
}

CloudFile
readInput(const Arguments& arguments, const std::string& path, Report& report)
{
  CloudFile cloud = readAnyCloud(path, floatsOfBin(arguments));
  chooseOffset(arguments, cloud, report);
  return cloud;
}

} // namespace pcl::app
