// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Reads clouds with truth and selects what is evaluated.

#include "labeled_cloud.h"

#include "evaluation/evaluation_tasks.h"
#include "io/errors.h"
#include "io/pcd.h"

#include <pcl/common/point_tests.h>
#include <pcl/segmentation/extract_clusters.h>

#include <algorithm>
#include <filesystem>
#include <numeric>

namespace peers {
namespace {

/** What pcl_shape_evaluate selects, of predictions that are the points' own numbers. */
Truth
truthOf(const pcl::app::CloudFile& file, const std::string& task)
{
  std::vector<std::uint32_t> numbers(file.size());
  std::iota(numbers.begin(), numbers.end(), 0u);
  pcl::app::CloudFile numbered = file; // at the same points
  pcl::app::setField(numbered, task == "edge" ? "edge" : "surface", numbers);
  const auto selected =
      pcl::app::selectPoints(task, pcl::app::Convention::strict, numbered, file);
  Truth truth;
  truth.classes = selected.classes;
  for (const pcl::app::LabelPair& pair : selected.points)
    truth.points.push_back({pair.truth, pair.predicted});
  return truth;
}

/** Clouds of other depth cameras say only where their table is: planar and no edge. */
Truth
truthOfTable(const pcl::app::CloudFile& file, Task task)
{
  const std::vector<std::uint32_t> table = pcl::app::labelsOf(file, "table");
  Truth truth;
  if (task == Task::edges)
    truth.classes = {{"edge", 1, {}}};
  else
    truth.classes = {{"curved", 2, {}}, {"planar", 1, {}}};
  const std::uint32_t label = task == Task::edges ? 0 : 1;
  for (std::size_t i = 0; i < table.size(); ++i)
    if (table[i] == 1)
      truth.points.push_back({label, i});
  return truth;
}

/** Leaves out what one may call either way on machined parts: thin walls, and curves
 * too sharp or too wide for the spacing. */
void
leaveOutDoubtful(const pcl::app::CloudFile& file, Task task, Truth& truth)
{
  // In spacings, as in doc/evaluation.md.
  constexpr float thin = 4.0f, beside_crease = 3.0f, sharp = 10.0f, wide = 40.0f;
  constexpr std::uint32_t curved = 2;
  const std::vector<float> thickness = pcl::app::floatsOf(file, "thin_s"),
                           radius = pcl::app::floatsOf(file, "radius_s"),
                           distance = pcl::app::floatsOf(file, "crease_s");
  const auto isDoubtful = [&](const Truth::Point& point) {
    const std::size_t i = point.index;
    if (thickness[i] <= thin)
      return true;
    if (task == Task::edges)
      return radius[i] < sharp && distance[i] > beside_crease;
    return point.label == curved && (radius[i] < sharp || radius[i] > wide);
  };
  truth.points.erase(
      std::remove_if(truth.points.begin(), truth.points.end(), isDoubtful),
      truth.points.end());
}

Truth
truthFor(const pcl::app::CloudFile& file, Task task)
{
  using pcl::app::findField;
  if (findField(file, "table") && !findField(file, "edge"))
    return truthOfTable(file, task);
  Truth truth = truthOf(file, task == Task::edges ? "edge" : "curved");
  if (findField(file, "thin_s"))
    leaveOutDoubtful(file, task, truth);
  return truth;
}

/** Only the points that are finite, also in the truth. */
void
keepFinite(LabeledCloud& cloud)
{
  const auto finite = pcl::make_shared<Cloud>();
  std::vector<std::size_t> places;
  for (const pcl::PointXYZ& point : *cloud.points) {
    places.push_back(finite->size());
    if (pcl::isXYZFinite(point))
      finite->push_back(point);
  }
  for (Truth* truth : {&cloud.edges, &cloud.surfaces}) {
    std::vector<Truth::Point> kept;
    for (const Truth::Point& point : truth->points)
      if (pcl::isXYZFinite((*cloud.points)[point.index]))
        kept.push_back({point.label, places[point.index]});
    truth->points = std::move(kept);
  }
  cloud.points = finite;
}

} // namespace

bool
Truth::hasAny() const
{
  return std::any_of(points.begin(), points.end(), [this](const Point& point) {
    return point.label == classes.front().label;
  });
}

LabeledCloud
readLabeledCloud(const std::string& path, const std::vector<Task>& tasks)
{
  const pcl::app::CloudFile file = pcl::app::readCloud(path);
  LabeledCloud cloud;
  cloud.name = std::filesystem::path(path).stem().string();
  cloud.points = pcl::app::pointsOf(file);
  for (const Task task : tasks)
    (task == Task::edges ? cloud.edges : cloud.surfaces) = truthFor(file, task);
  keepFinite(cloud);
  return cloud;
}

std::size_t
countCurvedParts(const LabeledCloud& cloud)
{
  constexpr double gap = 0.010;
  constexpr int least = 100;
  const auto curved = pcl::make_shared<Cloud>();
  for (const Truth::Point& point : cloud.surfaces.points)
    if (point.label == cloud.surfaces.classes.front().label)
      curved->push_back((*cloud.points)[point.index]);
  if (curved->empty())
    return 0;
  pcl::EuclideanClusterExtraction<pcl::PointXYZ> clustering;
  clustering.setInputCloud(curved);
  clustering.setClusterTolerance(gap);
  clustering.setMinClusterSize(least);
  std::vector<pcl::PointIndices> parts;
  clustering.extract(parts);
  return parts.size();
}

} // namespace peers
