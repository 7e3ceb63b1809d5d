// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Scores of the ground in generated streets.

#pragma once

#include <pcl/segmentation/shape_ground_segmentation.h>

#include <cstdint>
#include <vector>

/** What the tests of ground share. */
namespace pcl::test {

using Cloud = PointCloud<PointXYZ>;
using Ground = ShapeGroundSegmentation<PointXYZ>;

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
