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
#include <pcl/segmentation/shape_back_projection.h>
#include <pcl/segmentation/shape_edge_detection.h>
#include <pcl/segmentation/shape_field_estimation.h>

#include <iostream>

// From a cloud to planar, curved and edge points. Usage: shape_pipeline in.pcd
int
main(int argc, char** argv)
{
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  if (argc != 2 || pcl::io::loadPCDFile(argv[1], *cloud) != 0) {
    std::cerr << "usage: shape_pipeline in.pcd\n";
    return 1;
  }

  // [pipeline]
  pcl::ShapeFieldEstimation<pcl::PointXYZ> estimation;
  estimation.setInputCloud(cloud); // no radius: neighborhoods follow density and noise
  const auto field = pcl::make_shared<pcl::ShapeField>();
  estimation.compute(*field); // once, for every task

  pcl::ShapeBackProjection<pcl::PointXYZ> surfaces;
  surfaces.setInputCloud(cloud);
  surfaces.setShapeField(field);
  std::vector<pcl::PointIndices> classes;
  surfaces.segment(classes); // planar, curved

  pcl::ShapeEdgeDetection<pcl::PointXYZ> edge_detection;
  edge_detection.setInputCloud(cloud);
  edge_detection.setShapeField(field); // without one, it makes its own
  pcl::PointIndices edges;
  edge_detection.segment(edges);
  // [pipeline]

  if (classes.size() != 2)
    return 1;
  std::cout << classes[0].indices.size() << " planar, " << classes[1].indices.size()
            << " curved, " << edges.indices.size() << " edge points of "
            << cloud->size() << '\n';
  return edges.indices.empty() ? 1 : 0;
}
