/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/suction_grasp_estimation.h>

#include <iostream>

// Where a suction cup holds in a scene. Usage: suction_grasps in.pcd
int
main(int argc, char** argv)
{
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  if (argc != 2 || pcl::io::loadPCDFile(argv[1], *cloud) != 0) {
    std::cerr << "usage: suction_grasps in.pcd\n";
    return 1;
  }

  // [grasps]
  pcl::SuctionGraspEstimation<pcl::PointXYZ> estimation;
  estimation.setInputCloud(cloud); // setIndices(): the object to grasp in it
  estimation.setCupRadius(0.01);   // metres
  std::vector<pcl::SuctionGrasp> grasps;
  estimation.compute(grasps); // the best first
  // [grasps]

  if (grasps.empty() || !grasps.front().seals())
    return 1;
  std::cout << grasps.size() << " places, the best at "
            << grasps.front().position.transpose() << " along "
            << grasps.front().approach.transpose() << '\n';
  return 0;
}
