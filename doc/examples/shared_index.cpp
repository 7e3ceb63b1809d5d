/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include <pcl/features/inad.h>
#include <pcl/features/normal_3d_sweep.h>
#include <pcl/features/sweep_index.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <iostream>

// Normals and INAD at two scales: the cloud is sorted once. Usage: shared_index in.pcd
int
main(int argc, char** argv)
{
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  if (argc != 2 || pcl::io::loadPCDFile(argv[1], *cloud) != 0) {
    std::cerr << "usage: shared_index in.pcd\n";
    return 1;
  }

  // [index]
  const auto index = std::make_shared<pcl::SweepIndex>();

  pcl::NormalEstimationSweep<pcl::PointXYZ, pcl::Normal> normal_estimation;
  normal_estimation.setSweepIndex(index);
  normal_estimation.setInputCloud(cloud);
  normal_estimation.setRadiusSearch(0.010); // meters
  const auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  normal_estimation.compute(*normals);

  pcl::INADEstimation<pcl::PointXYZ, pcl::Normal> inad_estimation;
  inad_estimation.setSweepIndex(index);
  inad_estimation.setInputCloud(cloud);
  inad_estimation.setInputNormals(normals);
  pcl::PointCloud<pcl::INAD> fine, coarse;
  inad_estimation.setRadiusSearch(0.006);
  inad_estimation.compute(fine);
  inad_estimation.setRadiusSearch(0.020);
  inad_estimation.compute(coarse);
  // [index]

  std::size_t sharper = 0;
  for (std::size_t i = 0; i < fine.size(); ++i)
    sharper += fine[i].mu > coarse[i].mu;
  std::cout << sharper << " of " << cloud->size()
            << " points are more curved at 6 mm than at 20 mm\n";
  return fine.empty() || coarse.empty() ? 1 : 0;
}
