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

#include <iostream>

// Planar and curved points the paper's way, with your own normals. Usage:
// own_normals in.pcd
int
main(int argc, char** argv)
{
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  if (argc != 2 || pcl::io::loadPCDFile(argv[1], *cloud) != 0) {
    std::cerr << "usage: own_normals in.pcd\n";
    return 1;
  }

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
  surfaces.setMode(surfaces.PAPER);
  surfaces.setInputINAD(inad);
  std::vector<pcl::PointIndices> classes;
  surfaces.segment(classes); // planar, curved

  if (classes.size() != 2)
    return 1;
  std::cout << classes[0].indices.size() << " planar and " << classes[1].indices.size()
            << " curved points of " << cloud->size() << '\n';
  return classes[0].indices.empty() ? 1 : 0;
}
