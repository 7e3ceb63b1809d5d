// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Reads clouds with truth and selects what is evaluated.

#include "labeled_cloud.h"

#include "cli/errors.h"
#include "evaluation/evaluation_tasks.h"
#include "io/pcd.h"

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
  pcl::app::CloudFile numbered;
  numbered.path = file.path;
  numbered.blob.width = file.blob.width;
  numbered.blob.height = file.blob.height;
  pcl::app::setField(numbered, task == "edge" ? "edge" : "surface", numbers);
  const auto selected =
      pcl::app::selectPoints(task, pcl::app::Convention::strict, numbered, file);
  Truth truth;
  truth.classes = selected.classes;
  for (const pcl::app::LabelPair& pair : selected.points)
    truth.points.push_back({pair.truth, pair.predicted});
  return truth;
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
  if (!cloud.points->is_dense) {
    throw pcl::app::InputError(path + ": points that are not finite: expected an "
                                      "unorganized cloud without them");
  }
  for (const Task task : tasks) {
    (task == Task::edges ? cloud.edges : cloud.surfaces) =
        truthOf(file, task == Task::edges ? "edge" : "curved");
  }
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
