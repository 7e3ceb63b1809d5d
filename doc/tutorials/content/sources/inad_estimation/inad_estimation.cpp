/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include <pcl/features/inad.h>
#include <pcl/features/normal_3d_omp.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <cmath>
#include <iostream>

using Point = pcl::PointXYZ;

int
main(int argc, char** argv)
{
  const auto cloud = pcl::make_shared<pcl::PointCloud<Point>>();
  if (argc != 2 || pcl::io::loadPCDFile(argv[1], *cloud) != 0) {
    std::cerr << "usage: inad_estimation in.pcd\n";
    return 1;
  }

  // [normals]
  const auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  pcl::NormalEstimationOMP<Point, pcl::Normal> normal_estimation;
  normal_estimation.setInputCloud(cloud);
  normal_estimation.setRadiusSearch(0.025);
  normal_estimation.compute(*normals);
  // [normals]

  // [inad]
  pcl::PointCloud<pcl::INAD> inad;
  pcl::INADEstimation<Point, pcl::Normal> estimation;
  estimation.setInputCloud(cloud);
  estimation.setInputNormals(normals);
  estimation.setRadiusSearch(0.025);
  estimation.compute(inad);
  // [inad]

  // [count]
  constexpr float five_degrees = 0.0873f;
  std::size_t flat = 0, bent = 0, unknown = 0;
  for (const pcl::INAD& pair : inad) {
    if (std::isnan(pair.mu))
      ++unknown;
    else if (pair.mu < five_degrees)
      ++flat;
    else
      ++bent;
  }
  std::cout << flat << " points on flat surfaces, " << bent
            << " on bent ones or at edges, " << unknown << " unknown\n";
  // [count]
  return flat > 0 && bent > 0 ? 0 : 1;
}
