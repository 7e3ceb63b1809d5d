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
#include <pcl/segmentation/shape_back_projection.h>
#include <pcl/segmentation/shape_edge_detection.h>

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
  pcl::NormalEstimationOMP<pcl::PointXYZ, pcl::Normal> normal_estimation;
  normal_estimation.setInputCloud(cloud);
  normal_estimation.setRadiusSearch(0.025);
  const auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  normal_estimation.compute(*normals);

  pcl::INADEstimation<pcl::PointXYZ, pcl::Normal> inad_estimation;
  inad_estimation.setInputCloud(cloud);
  inad_estimation.setInputNormals(normals);
  inad_estimation.setRadiusSearch(0.025);
  const auto inad = pcl::make_shared<pcl::PointCloud<pcl::INAD>>();
  inad_estimation.compute(*inad);

  pcl::ShapeBackProjection<pcl::PointXYZ> surfaces;
  surfaces.setInputCloud(cloud);
  surfaces.setInputINAD(inad); // or nothing: it is estimated then
  std::vector<pcl::PointIndices> classes;
  surfaces.segment(classes); // planar, curved

  pcl::ShapeEdgeDetection<pcl::PointXYZ> edge_detection;
  edge_detection.setInputCloud(cloud); // no radius: it follows density and noise
  pcl::PointIndices edges;
  edge_detection.segment(edges);
  // [pipeline]

  if (classes.size() != 2) {
    return 1;
  }
  std::cout << classes[0].indices.size() << " planar, " << classes[1].indices.size()
            << " curved, " << edges.indices.size() << " edge points of "
            << cloud->size() << '\n';
  return edges.indices.empty() ? 1 : 0;
}
