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
#include <pcl/segmentation/shape_labeling.h>

#include <algorithm>
#include <iostream>

// Labels to train others with. Usage: point_labels in.pcd
int
main(int argc, char** argv)
{
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  if (argc != 2 || pcl::io::loadPCDFile(argv[1], *cloud) != 0) {
    std::cerr << "usage: point_labels in.pcd\n";
    return 1;
  }

  // [labels]
  pcl::ShapeLabeling<pcl::PointXYZ> labeling;
  labeling.setInputCloud(cloud);
  labeling.setConfidence(0.95); // points that are less sure are void, 0
  pcl::PointLabels labels;
  labeling.label(labels);
  // [labels]

  std::uint32_t label = 0;
  for (const std::string name : {"void", "planar", "curved", "edge"}) {
    std::cout << std::count(labels.labels.begin(), labels.labels.end(), label++) << ' '
              << name << '\n';
  }
  return labels.labels.empty() ? 1 : 0;
}
