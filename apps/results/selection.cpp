// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Selects points by a label and a box.

#include "results/selection.h"

#include "io/errors.h"
#include "results/points_by_object.h"

#include <pcl/common/point_tests.h>

#include <array>
#include <optional>

namespace pcl::app {
namespace {

constexpr std::uint64_t max_label = 0xffffffff;

struct Box {
  std::array<double, 3> low{}, high{};

  bool
  contains(const pcl::PointXYZ& point) const
  {
    for (std::size_t c = 0; c < 3; ++c)
      if (!(point.data[c] >= low[c] && point.data[c] <= high[c]))
        return false;
    return true;
  }
};

std::optional<Box>
boxOf(const Arguments& arguments)
{
  const std::string expected =
      "six numbers of meters, X1,Y1,Z1,X2,Y2,Z2, the first three below the others";
  const auto numbers = arguments.numbers("box", 6, expected);
  if (!numbers)
    return std::nullopt;
  Box box;
  for (std::size_t c = 0; c < 3; ++c) {
    box.low[c] = (*numbers)[c];
    box.high[c] = (*numbers)[c + 3];
    if (!(box.low[c] < box.high[c]))
      arguments.fail("box", expected);
  }
  return box;
}

std::uint32_t
partsOf(const Arguments& arguments)
{
  return static_cast<std::uint32_t>(
      arguments.integer("parts", 1, max_label).value_or(1));
}

} // namespace

void
addSelectionOptions(CommandLine& command_line)
{
  command_line.option("field", "F", "only the points where the field F ...")
      .option("value", "V", "... has the value V")
      .option("box", "X1,Y1,Z1,X2,Y2,Z2", "only the points in this box, meters");
}

void
addEachOptions(CommandLine& command_line)
{
  command_line.option("each", "F", "each object of the field F (1 and up), on its own")
      .option("parts", "N", "of -each: values of F are N * object + part (1)");
}

void
checkSelection(const Arguments& arguments)
{
  for (const char* other : {"field", "box"})
    arguments.exclude("each", other);
  if (arguments.has("parts") && !arguments.has("each"))
    throw UsageError("-parts '" + arguments.text("parts") +
                     "' without -each; expected -each and the field of the objects");
  partsOf(arguments);
  arguments.hasBoth("field", "value");
  arguments.integer("value", 0, max_label);
  boxOf(arguments);
}

void
reportSelection(const Arguments& arguments, Report& report)
{
  if (arguments.has("field")) {
    report.setText("parameters", "field", arguments.text("field"));
    report.setCount("parameters", "value", *arguments.integer("value", 0, max_label));
  }
  if (arguments.has("box"))
    report.setText("parameters", "box", arguments.text("box"));
  if (arguments.has("each")) {
    report.setText("parameters", "each", arguments.text("each"));
    report.setCount("parameters", "parts", partsOf(arguments));
  }
}

pcl::IndicesPtr
selectedPoints(const CloudFile& file,
               const pcl::PointCloud<pcl::PointXYZ>& points,
               const Arguments& arguments)
{
  std::vector<std::uint32_t> labels;
  std::uint64_t label = 0;
  if (arguments.has("field")) {
    labels = labelsOf(file, arguments.text("field"));
    label = *arguments.integer("value", 0, max_label);
  }
  std::optional<Box> box = boxOf(arguments);
  for (std::size_t c = 0; box && c < 3; ++c) { // of the file's coordinates
    box->low[c] -= file.offset[c];
    box->high[c] -= file.offset[c];
  }
  auto selected = pcl::make_shared<pcl::Indices>();
  for (std::size_t i = 0; i < points.size(); ++i)
    if (pcl::isFinite(points[i]) && (labels.empty() || labels[i] == label) &&
        (!box || box->contains(points[i])))
      selected->push_back(static_cast<pcl::index_t>(i));
  if (selected->empty())
    throw InputError(file.path + ": no finite point is selected by -field '" +
                     arguments.text("field") + "' -value '" + arguments.text("value") +
                     "' -box '" + arguments.text("box") + "'; expected at least one");
  return selected;
}

std::map<std::uint32_t, pcl::IndicesPtr>
selectedObjects(const CloudFile& file,
                const pcl::PointCloud<pcl::PointXYZ>& points,
                const Arguments& arguments)
{
  const std::vector<std::uint32_t> labels = labelsOf(file, arguments.text("each"));
  const std::uint32_t parts = partsOf(arguments);
  auto objects = pointsByObject(points, labels, parts);
  if (objects.empty())
    throw InputError(file.path + ": no finite point is of an object by -each '" +
                     arguments.text("each") + "' -parts " + std::to_string(parts) +
                     "; expected at least one");
  return objects;
}

} // namespace pcl::app
