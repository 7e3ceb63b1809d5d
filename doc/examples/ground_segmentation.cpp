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
#include <pcl/segmentation/shape_ground_segmentation.h>

#include <iostream>

// The ground in a laser scan. Usage: ground_segmentation street.pcd
int
main(int argc, char** argv)
{
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  if (argc != 2 || pcl::io::loadPCDFile(argv[1], *cloud) != 0) {
    std::cerr << "usage: ground_segmentation street.pcd\n";
    return 1;
  }

  pcl::ShapeGroundSegmentation<pcl::PointXYZ> segmentation;
  segmentation.setInputCloud(cloud); // the scanner is at its sensor_origin_, up is z
  pcl::PointIndices ground;
  segmentation.segment(ground);

  std::cout << ground.indices.size() << " of " << cloud->size()
            << " points are ground\n";
  return ground.indices.empty() ? 1 : 0;
}
