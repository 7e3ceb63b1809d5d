/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "align.h"

#include <pcl/common/transforms.h>
#include <pcl/filters/filter.h>
#include <pcl/filters/uniform_sampling.h>
#include <pcl/io/pcd_io.h>
#include <pcl/segmentation/shape_edge_detection.h>

#include <algorithm>
#include <iostream>

namespace {

struct Creases {
  Cloud::Ptr points = pcl::make_shared<Cloud>();
  float spacing = 0.0f; ///< of the cloud, the median at its creases
};

// [creases]
Creases
creasesOf(const Cloud::ConstPtr& cloud)
{
  pcl::ShapeEdgeDetection<pcl::PointXYZ> detection;
  detection.setInputCloud(cloud);
  pcl::Edges edges;
  detection.detect(edges);

  Creases creases;
  std::vector<float> spacings;
  for (const pcl::CreasePoint& crease : edges.creases) {
    const auto& [x, y, z] = crease.position;
    creases.points->emplace_back(x, y, z);
    spacings.push_back(crease.spacing);
  }
  if (spacings.empty())
    return creases;
  const auto middle =
      spacings.begin() + static_cast<std::ptrdiff_t>(spacings.size() / 2);
  std::nth_element(spacings.begin(), middle, spacings.end());
  creases.spacing = *middle;
  return creases;
}
// [creases]

Cloud::Ptr
thinned(const Cloud::ConstPtr& cloud, float distance)
{
  const auto result = pcl::make_shared<Cloud>();
  pcl::UniformSampling<pcl::PointXYZ> sampling;
  sampling.setInputCloud(cloud);
  sampling.setRadiusSearch(distance);
  sampling.filter(*result);
  return result;
}

void
append(const Cloud& cloud, std::uint32_t label, pcl::PointCloud<pcl::PointXYZL>& all)
{
  for (const pcl::PointXYZ& point : cloud)
    all.emplace_back(point.x, point.y, point.z, label);
}

} // namespace

int
main(int argc, char** argv)
{
  if (argc != 4) {
    std::cerr << "usage: salient_points FROM.pcd TO.pcd BOTH.pcd\n";
    return 2;
  }
  View views[2];
  float spacing = 0.0f;
  // [keypoints]
  for (int v = 0; v < 2; ++v) {
    const auto cloud = pcl::make_shared<Cloud>();
    if (pcl::io::loadPCDFile(argv[1 + v], *cloud) != 0)
      return 1;
    pcl::Indices kept;
    pcl::removeNaNFromPointCloud(*cloud, *cloud, kept);
    const Creases creases = creasesOf(cloud);
    if (creases.points->empty()) {
      std::cerr << argv[1 + v] << ": no creases\n";
      return 1;
    }
    spacing = std::max(spacing, creases.spacing);
    views[v] = {cloud, thinned(creases.points, 4.0f * creases.spacing)};
    std::cout << argv[1 + v] << ": " << views[v].keypoints->size() << " keypoints\n";
  }
  // [keypoints]
  // [align]
  const Alignment alignment = align(views[0], views[1], spacing);
  std::cout << alignment.agreeing << " of " << alignment.matches
            << " matches agree on the pose\n"
            << alignment.pose << '\n';
  // [align]
  // [save]
  Cloud aligned;
  pcl::transformPointCloud(*views[0].cloud, aligned, alignment.pose);
  pcl::PointCloud<pcl::PointXYZL> both;
  append(aligned, 1, both);
  append(*views[1].cloud, 2, both);
  return pcl::io::savePCDFileBinaryCompressed(argv[3], both) == 0 ? 0 : 1;
  // [save]
}
