/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include <pcl/features/normal_3d_sweep.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <cmath>
#include <iostream>

// Surface normals without a search tree. Usage: normal_estimation in.pcd
int
main(int argc, char** argv)
{
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  if (argc != 2 || pcl::io::loadPCDFile(argv[1], *cloud) != 0) {
    std::cerr << "usage: normal_estimation in.pcd\n";
    return 1;
  }

  // [normals]
  pcl::NormalEstimationSweep<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setInputCloud(cloud);
  estimation.setRadiusSearch(0.015); // metres; or setKSearch(30)
  estimation.setNumberOfThreads(2);  // 0, the default: all cores
  estimation.setViewPoint(0, 0, 0);  // normals point to here
  pcl::PointCloud<pcl::Normal> normals;
  estimation.compute(normals);
  // [normals]

  std::size_t known = 0;
  for (const pcl::Normal& normal : normals)
    known += std::isfinite(normal.normal_x);
  std::cout << known << " of " << normals.size() << " points have a normal\n";
  return known == 0 ? 1 : 0;
}
