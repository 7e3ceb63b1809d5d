// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What the tests of ground share: likelihoods and F1.

#pragma once

#include "scene/sensors/lidar.h"

#include <pcl/segmentation/shape_ground_segmentation.h>

#include <cstdint>
#include <vector>

/** What the tests of ground share. */
namespace pcl::test {

using Cloud = PointCloud<PointXYZ>;
using Ground = ShapeGroundSegmentation<PointXYZ>;

inline Cloud::Ptr
cloudOf(const scene::LidarScan& scan)
{
  const auto cloud = make_shared<Cloud>();
  for (std::size_t i = 0; i < scan.xyz.size(); i += 3)
    cloud->emplace_back(scan.xyz[i], scan.xyz[i + 1], scan.xyz[i + 2]);
  return cloud;
}

inline std::vector<float>
likelihoodsOf(const Cloud::ConstPtr& cloud, unsigned threads = 0)
{
  Ground ground;
  ground.setInputCloud(cloud);
  ground.setNumberOfThreads(threads);
  std::vector<float> likelihoods;
  ground.compute(likelihoods);
  return likelihoods;
}

/** \brief F1 where the truth is 0 or 1. */
inline double
f1(const std::vector<float>& likelihoods, const std::vector<std::uint32_t>& truth)
{
  double right = 0.0, wrong = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (truth[i] <= 1) {
      const bool is_found = likelihoods.at(i) >= 0.5f;
      right += is_found && truth[i] == 1;
      wrong += is_found != (truth[i] == 1);
    }
  }
  return 2.0 * right / (2.0 * right + wrong);
}

} // namespace pcl::test
