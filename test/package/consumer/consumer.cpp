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
#include <pcl/features/shape_model.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/shape_back_projection.h>
#include <pcl/segmentation/shape_edge_detection.h>

#include <algorithm>
#include <iostream>

// Every class of the installed package, on two walls that meet at a right angle.
namespace {

pcl::PointCloud<pcl::PointXYZ>::Ptr
twoWalls()
{
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (int i = -50; i < 50; ++i) {
    for (int j = 0; j < 100; ++j) {
      cloud->emplace_back(0.002f * static_cast<float>(std::max(0, i)),
                          0.002f * static_cast<float>(j),
                          1.0f + 0.002f * static_cast<float>(std::min(0, i)));
    }
  }
  return cloud;
}

} // namespace

int
main(int argc, char** argv)
{
  if (argc != 2) {
    return 2;
  }
  const auto cloud = twoWalls();
  const auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  pcl::NormalEstimationSweep<pcl::PointXYZ, pcl::Normal> normal_estimation;
  normal_estimation.setInputCloud(cloud);
  normal_estimation.setRadiusSearch(0.025);
  normal_estimation.compute(*normals);

  pcl::PointCloud<pcl::INAD> inad;
  pcl::INADEstimation<pcl::PointXYZ, pcl::Normal> inad_estimation;
  inad_estimation.setInputCloud(cloud);
  inad_estimation.setInputNormals(normals);
  inad_estimation.setRadiusSearch(0.025);
  inad_estimation.compute(inad);

  pcl::ShapeModel::idealPlane().save(argv[1]);
  pcl::ShapeBackProjection<pcl::PointXYZ> surfaces;
  surfaces.setModel(pcl::ShapeModel::load(argv[1]));
  surfaces.setInputCloud(cloud);
  std::vector<pcl::PointIndices> classes;
  surfaces.segment(classes);

  pcl::PointIndices edges;
  pcl::ShapeEdgeDetection<pcl::PointXYZ> edge_detection;
  edge_detection.setInputCloud(cloud);
  edge_detection.segment(edges);

  const bool is_right = inad.size() == cloud->size() && classes.size() == 2 &&
                        classes[0].indices.size() > cloud->size() / 2 &&
                        !edges.indices.empty() &&
                        edges.indices.size() < cloud->size() / 5;
  std::cout << edges.indices.size() << " edge points of " << cloud->size() << '\n';
  return is_right ? 0 : 1;
}
