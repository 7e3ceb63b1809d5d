/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

// The classes are compiled for PCL's usual point types. For others, include the
// templates:
#define PCL_NO_PRECOMPILE
#include <pcl/register_point_struct.h>
#include <pcl/segmentation/shape_back_projection.h>
#include <pcl/segmentation/shape_edge_detection.h>

#include <iostream>

// [point]
struct ScanPoint {
  PCL_ADD_POINT4D;
  float time;
  PCL_MAKE_ALIGNED_OPERATOR_NEW
} EIGEN_ALIGN16;

POINT_CLOUD_REGISTER_POINT_STRUCT(
    ScanPoint, (float, x, x)(float, y, y)(float, z, z)(float, time, time))
// [point]

// Two walls that meet at a right angle.
int
main()
{
  const auto cloud = pcl::make_shared<pcl::PointCloud<ScanPoint>>();
  for (int i = 0; i < 150; ++i) {
    for (int j = 0; j < 150; ++j) {
      ScanPoint point;
      point.time = 0.0f;
      point.y = 0.002f * static_cast<float>(j);
      point.x = 0.002f * static_cast<float>(std::max(0, i - 75));
      point.z = 0.002f * static_cast<float>(std::max(0, 75 - i));
      cloud->push_back(point);
    }
  }

  pcl::ShapeEdgeDetection<ScanPoint> edge_detection;
  edge_detection.setInputCloud(cloud);
  pcl::PointIndices edges;
  edge_detection.segment(edges);

  pcl::ShapeBackProjection<ScanPoint> surfaces;
  surfaces.setInputCloud(cloud);
  pcl::PointCloud<pcl::Intensity> likelihood;
  surfaces.compute(likelihood); // of being planar

  std::cout << edges.indices.size() << " edge points of " << likelihood.size() << '\n';
  return edges.indices.empty() || edges.indices.size() > 3000 ? 1 : 0;
}
