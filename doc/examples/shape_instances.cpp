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
#include <pcl/segmentation/shape_instance_segmentation.h>

#include <iostream>

// Whole objects on a table, sorted by shape. Usage: shape_instances in.pcd
int
main(int argc, char** argv)
{
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  if (argc != 2 || pcl::io::loadPCDFile(argv[1], *cloud) != 0) {
    std::cerr << "usage: shape_instances in.pcd\n";
    return 1;
  }

  // [instances]
  pcl::ShapeInstanceSegmentation<pcl::PointXYZ> segmentation;
  segmentation.setInputCloud(cloud);
  segmentation.setClass("object"); // or planar, curved
  std::vector<pcl::ShapeInstance> objects;
  segmentation.segment(objects); // how many is not said
  for (const pcl::ShapeInstance& object : objects) {
    const float planar = object.shares[0];
    std::cout << object.indices.size() << " points at " << object.centroid.transpose()
              << ": " << (planar > 0.5f ? "flat" : "round") << " sides\n";
  }
  // [instances]
  return objects.empty() ? 1 : 0;
}
