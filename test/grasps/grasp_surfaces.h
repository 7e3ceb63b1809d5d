// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Surfaces to grasp: points of plates, cylinders and the like.

#pragma once

#include "support/clouds.h"
#include "support/shapes.h"

#include <pcl/segmentation/suction_grasp_estimation.h>

#include <gtest/gtest.h>

#include <vector>

/** What the tests of grasps on single surfaces share. */
namespace pcl::test {

using Cloud = PointCloud<PointXYZ>;
using Grasps = std::vector<SuctionGrasp>;
using Estimation = SuctionGraspEstimation<PointXYZ>;

constexpr double cup = 0.01;
constexpr float cup_radius = 0.01f;

/** \brief Points of z = height in a rectangle, about 1.5 mm apart. */
inline Surface
sheet(Eigen::Vector3d corner, double width, double length, Random& random)
{
  const auto count = static_cast<std::size_t>(width * length / (0.0015 * 0.0015));
  return sampled(count, random, [=](Random& r) {
    const double x = r.uniform(0, width), y = r.uniform(0, length);
    return SurfacePoint{corner + Eigen::Vector3d(x, y, 0), {0, 0, 1}};
  });
}

inline Estimation
seenFromAbove(const Cloud::Ptr& cloud)
{
  Estimation estimation;
  estimation.setInputCloud(cloud);
  estimation.setCupRadius(cup);
  estimation.setViewPoint(0, 0, 5);
  return estimation;
}

inline Grasps
graspsOf(Estimation& estimation)
{
  Grasps grasps;
  EXPECT_TRUE(estimation.compute(grasps));
  return grasps;
}

inline Grasps
graspsOn(const Surface& surface)
{
  Estimation estimation = seenFromAbove(toCloud<PointXYZ>(surface));
  return graspsOf(estimation);
}

} // namespace pcl::test
