/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include <pcl/common/geometry.h>
#include <pcl/features/normal_3d_omp.h>
#include <pcl/features/normal_3d_sweep.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>

using Point = pcl::PointXYZ;
using Normals = pcl::PointCloud<pcl::Normal>;

namespace {

template <typename Estimation>
Normals
estimate(Estimation& estimation, const char* name)
{
  const auto start = std::chrono::steady_clock::now();
  Normals normals;
  estimation.compute(normals);
  const std::chrono::duration<double, std::milli> time =
      std::chrono::steady_clock::now() - start;
  std::cout << name << ": " << time.count() << " ms\n";
  return normals;
}

/** The angles between two normals of a point, degrees, sorted. */
std::vector<double>
anglesBetween(const Normals& a, const Normals& b)
{
  constexpr double degrees_per_radian = 57.29577951308232;
  std::vector<double> angles;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Eigen::Vector3d left = a[i].getNormalVector3fMap().cast<double>();
    const Eigen::Vector3d right = b[i].getNormalVector3fMap().cast<double>();
    const double chord = (left - right).norm();
    if (std::isfinite(chord)) {
      angles.push_back(2.0 * std::asin(std::min(1.0, chord / 2.0)) *
                       degrees_per_radian);
    }
  }
  std::sort(angles.begin(), angles.end());
  return angles;
}

} // namespace

int
main(int argc, char** argv)
{
  const auto cloud = pcl::make_shared<pcl::PointCloud<Point>>();
  if (argc != 2 || pcl::io::loadPCDFile(argv[1], *cloud) != 0) {
    std::cerr << "usage: normal_estimation_sweep in.pcd\n";
    return 1;
  }
  std::cout << cloud->size() << " points\n";

  // [before]
  pcl::NormalEstimationOMP<Point, pcl::Normal> with_tree;
  with_tree.setInputCloud(cloud);
  with_tree.setRadiusSearch(0.025);
  const Normals expected = estimate(with_tree, "NormalEstimationOMP");
  // [before]

  // [after]
  pcl::NormalEstimationSweep<Point, pcl::Normal> with_sweep;
  with_sweep.setInputCloud(cloud);
  with_sweep.setRadiusSearch(0.025);
  const Normals normals = estimate(with_sweep, "NormalEstimationSweep");
  // [after]

  // [compare]
  const std::vector<double> angles = anglesBetween(expected, normals);
  if (angles.empty())
    return 1;
  std::cout << angles.size() << " points have both normals\n"
            << "angle between them, degrees: median " << angles[angles.size() / 2]
            << ", 99th percentile " << angles[angles.size() * 99 / 100] << '\n';
  // [compare]
  return angles[angles.size() * 99 / 100] < 0.01 ? 0 : 1;
}
