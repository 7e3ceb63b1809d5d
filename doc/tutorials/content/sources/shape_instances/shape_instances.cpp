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

int
main(int argc, char** argv)
{
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  if (argc != 2 || pcl::io::loadPCDFile(argv[1], *cloud) != 0) {
    std::cerr << "usage: shape_instances scene.pcd\n";
    return 1;
  }

  // [segment]
  pcl::ShapeInstanceSegmentation<pcl::PointXYZ> segmentation;
  segmentation.setInputCloud(cloud);
  segmentation.setClass("curved");
  segmentation.setPrimitive(pcl::PrimitiveType::Auto);

  std::vector<pcl::ShapeInstance> instances;
  segmentation.segment(instances);
  // [segment]

  // [cylinders]
  pcl::PointCloud<pcl::PointXYZL> cylinders;
  std::uint32_t count = 0;
  for (const pcl::ShapeInstance& instance : instances) {
    const pcl::ShapePrimitive& fit = instance.primitive;
    if (fit.type != pcl::PrimitiveType::Cylinder)
      continue;
    ++count;
    const Eigen::Vector3f axis(
        fit.coefficients[3], fit.coefficients[4], fit.coefficients[5]);
    const float radius = fit.coefficients[6];
    std::cout << "cylinder " << count << ": " << instance.indices.size()
              << " points, radius " << 1000.0f * radius << " mm, axis "
              << axis.transpose() << ", residual " << 1000.0f * fit.residual << " mm\n";
    for (const pcl::index_t index : instance.indices) {
      const pcl::PointXYZ& point = (*cloud)[index];
      cylinders.push_back({point.x, point.y, point.z, count});
    }
  }
  std::cout << count << " cylinders among " << instances.size()
            << " curved instances\n";
  // [cylinders]
  if (cylinders.empty())
    return 1;
  return pcl::io::savePCDFileBinaryCompressed("cylinders.pcd", cylinders) == 0 ? 0 : 1;
}
