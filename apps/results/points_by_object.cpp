// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The points of each object of a labeled cloud.

#include "results/points_by_object.h"

#include <pcl/common/point_tests.h>

namespace pcl::app {

std::map<std::uint32_t, pcl::IndicesPtr>
pointsByObject(const pcl::PointCloud<pcl::PointXYZ>& cloud,
               const std::vector<std::uint32_t>& labels,
               std::uint32_t parts)
{
  std::map<std::uint32_t, pcl::IndicesPtr> objects;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const std::uint32_t object = labels[i] / parts;
    if (object == 0 || !pcl::isXYZFinite(cloud[i]))
      continue;
    pcl::IndicesPtr& indices = objects[object];
    if (!indices)
      indices = pcl::make_shared<pcl::Indices>();
    indices->push_back(static_cast<pcl::index_t>(i));
  }
  return objects;
}

} // namespace pcl::app
