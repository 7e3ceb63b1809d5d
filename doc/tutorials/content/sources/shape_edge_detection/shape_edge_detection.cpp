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
#include <pcl/segmentation/shape_edge_detection.h>

#include <algorithm>
#include <array>
#include <iostream>

using Point = pcl::PointXYZ;

int
main(int argc, char** argv)
{
  const auto cloud = pcl::make_shared<pcl::PointCloud<Point>>();
  if (argc != 2 || pcl::io::loadPCDFile(argv[1], *cloud) != 0) {
    std::cerr << "usage: shape_edge_detection in.pcd\n";
    return 1;
  }

  // [detect]
  pcl::ShapeEdgeDetection<Point> detection;
  detection.setInputCloud(cloud);
  pcl::Edges edges;
  detection.detect(edges);
  // [detect]
  if (edges.types.empty())
    return 1;

  // [count]
  const char* const names[] = {"no edge", "crease", "corner", "open boundary"};
  std::array<std::size_t, 4> counts{};
  for (const pcl::EdgeType type : edges.types)
    ++counts[static_cast<std::size_t>(type)];
  for (std::size_t t = 0; t < counts.size(); ++t)
    std::cout << names[t] << ": " << counts[t] << " points\n";
  // [count]

  // [lines]
  const std::vector<pcl::CreaseLine> lines = detection.linesOf(edges);
  constexpr float degrees_per_radian = 57.2957795f;
  std::cout << lines.size() << " lines; the longest:\n";
  for (std::size_t l = 0; l < std::min<std::size_t>(lines.size(), 5); ++l) {
    std::cout << "  " << lines[l].length << " m, turns by "
              << lines[l].angle * degrees_per_radian << " degrees\n";
  }
  // [lines]

  // [save]
  pcl::PointCloud<pcl::PointXYZL> labeled;
  pcl::copyPointCloud(*cloud, labeled);
  for (std::size_t i = 0; i < labeled.size(); ++i)
    labeled[i].label = static_cast<std::uint32_t>(edges.types[i]);
  return pcl::io::savePCDFileBinaryCompressed("edges.pcd", labeled) == 0 ? 0 : 1;
  // [save]
}
