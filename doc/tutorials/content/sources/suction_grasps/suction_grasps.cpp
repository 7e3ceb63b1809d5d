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
#include <pcl/segmentation/suction_grasp_estimation.h>

#include <cstdlib>
#include <iostream>

using Cloud = pcl::PointCloud<pcl::PointXYZL>;

/** The points of one object; the field `label` says which object a point is of. */
pcl::IndicesPtr
pointsOf(const Cloud& cloud, std::uint32_t object)
{
  const auto points = pcl::make_shared<pcl::Indices>();
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (cloud[i].label == object)
      points->push_back(static_cast<pcl::index_t>(i));
  return points;
}

int
main(int argc, char** argv)
{
  // Load the scene; "instance" is how the scene generator names the objects.
  pcl::PCLPointCloud2 file;
  if (argc != 3 || pcl::io::loadPCDFile(argv[1], file) != 0) {
    std::cerr << "usage: suction_grasps scene.pcd object\n";
    return 1;
  }
  for (auto& field : file.fields)
    if (field.name == "instance")
      field.name = "label";
  const auto cloud = pcl::make_shared<Cloud>();
  pcl::fromPCLPointCloud2(file, *cloud);

  // The object to grasp, in the scene around it
  pcl::SuctionGraspEstimation<pcl::PointXYZL> estimation;
  estimation.setInputCloud(cloud);
  estimation.setIndices(
      pointsOf(*cloud, static_cast<std::uint32_t>(std::atoi(argv[2]))));

  // The cup
  estimation.setCupRadius(0.01);
  estimation.setCompliance(0.2);
  estimation.setMaximumGrasps(5);

  // Places for it, the best first
  std::vector<pcl::SuctionGrasp> grasps;
  if (!estimation.compute(grasps))
    return 1;
  for (const pcl::SuctionGrasp& grasp : grasps) {
    std::cout << "score " << grasp.score << " at " << grasp.position.transpose()
              << ", approach " << grasp.approach.transpose()
              << (grasp.seals() ? ": seals" : ": leaks");
    for (const pcl::SealProblem problem : grasp.problems)
      std::cout << ' ' << pcl::nameOf(problem);
    std::cout << '\n';
  }
  return 0;
}
