/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include <pcl/filters/extract_indices.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/extract_clusters.h>
#include <pcl/segmentation/shape_ground_segmentation.h>

#include <iostream>

int
main(int argc, char** argv)
{
  if (argc != 2) {
    std::cerr << "usage: " << argv[0] << " street.pcd\n";
    return 1;
  }
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  if (pcl::io::loadPCDFile(argv[1], *cloud) != 0)
    return 1;

  // Find the ground.
  pcl::ShapeGroundSegmentation<pcl::PointXYZ> segmentation;
  segmentation.setInputCloud(cloud);
  const auto ground = pcl::make_shared<pcl::PointIndices>();
  segmentation.segment(*ground);
  std::cout << ground->indices.size() << " of " << cloud->size()
            << " points are ground\n";
  if (ground->indices.empty())
    return 1;

  // Take it away.
  const auto things = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  pcl::ExtractIndices<pcl::PointXYZ> extract;
  extract.setInputCloud(cloud);
  extract.setIndices(ground);
  extract.setNegative(true);
  extract.filter(*things);

  // What stands on it falls apart.
  pcl::EuclideanClusterExtraction<pcl::PointXYZ> clustering;
  clustering.setInputCloud(things);
  clustering.setClusterTolerance(0.5);
  clustering.setMinClusterSize(100);
  std::vector<pcl::PointIndices> clusters;
  clustering.extract(clusters);
  std::cout << clusters.size() << " things of 100 points or more stand on it\n";
  return 0;
}
