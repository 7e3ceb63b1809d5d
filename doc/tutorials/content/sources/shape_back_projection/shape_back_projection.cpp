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
#include <pcl/segmentation/shape_back_projection.h>
#include <pcl/segmentation/shape_field_estimation.h>

#include <cmath>
#include <iostream>

using Point = pcl::PointXYZ;

int
main(int argc, char** argv)
{
  const auto cloud = pcl::make_shared<pcl::PointCloud<Point>>();
  if (argc != 2 || pcl::io::loadPCDFile(argv[1], *cloud) != 0) {
    std::cerr << "usage: shape_back_projection in.pcd\n";
    return 1;
  }

  // [classify]
  pcl::ShapeFieldEstimation<Point> estimation;
  estimation.setInputCloud(cloud);
  const auto field = pcl::make_shared<pcl::ShapeField>();
  if (!estimation.compute(*field))
    return 1;

  pcl::ShapeBackProjection<Point> back_projection;
  back_projection.setInputCloud(cloud);
  back_projection.setShapeField(field);
  std::vector<std::vector<float>> likelihoods;
  back_projection.compute(likelihoods);
  // [classify]

  // [classes]
  const std::vector<std::string> names = back_projection.getClasses();
  const std::vector<pcl::PointIndices> classes = back_projection.classesOf(likelihoods);
  std::size_t unknown = 0;
  for (const float likelihood : likelihoods[0])
    unknown += std::isnan(likelihood);
  for (std::size_t c = 0; c < classes.size(); ++c)
    std::cout << names[c] << ": " << classes[c].indices.size() << " points\n";
  std::cout << "unknown: " << unknown << " points\n"
            << "noise: " << field->noise << " spacings\n";
  // [classes]

  // [extract]
  pcl::ExtractIndices<Point> extract;
  extract.setInputCloud(cloud);
  extract.setIndices(pcl::make_shared<const pcl::PointIndices>(classes[1]));
  pcl::PointCloud<Point> curved;
  extract.filter(curved);
  // [extract]
  if (curved.empty()) {
    std::cerr << "no curved point\n";
    return 1;
  }
  return pcl::io::savePCDFileBinaryCompressed("curved.pcd", curved) == 0 ? 0 : 1;
}
