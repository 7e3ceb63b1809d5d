/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include <pcl/common/io.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/shape_labeling.h>

#include <iostream>
#include <string>
#include <vector>

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/** The points as PointXYZL; void points are 0. */
pcl::PointCloud<pcl::PointXYZL>
labeled(const Cloud& cloud, const pcl::PointLabels& labels)
{
  // [copy]
  pcl::PointCloud<pcl::PointXYZL> result;
  pcl::copyPointCloud(cloud, result);
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i].label = labels.labels[i];
  // [copy]
  return result;
}

// Usage: label_a_data_set in.pcd ...
int
main(int argc, char** argv)
{
  // [labeling]
  pcl::ShapeLabeling<pcl::PointXYZ> labeling;
  labeling.setConfidence(0.95);
  std::vector<std::string> names{"void"};
  for (const std::string& name : labeling.getClasses())
    names.push_back(name); // planar, curved, edge
  // [labeling]

  for (int file = 1; file < argc; ++file) {
    const auto cloud = pcl::make_shared<Cloud>();
    if (pcl::io::loadPCDFile(argv[file], *cloud) != 0)
      return 1;
    // [label]
    labeling.setInputCloud(cloud);
    pcl::PointLabels labels;
    labeling.label(labels);
    if (labels.labels.empty())
      return 1; // the reason was printed
    // [label]

    std::vector<std::size_t> counts(names.size(), 0);
    double confidence = 0.0;
    for (std::size_t i = 0; i < labels.labels.size(); ++i) {
      ++counts[labels.labels[i]];
      confidence += static_cast<double>(labels.confidence[i]);
    }
    std::cout << argv[file] << ':';
    for (std::size_t label = 0; label < names.size(); ++label)
      std::cout << ' ' << counts[label] << ' ' << names[label] << ',';
    std::cout << " mean confidence " << confidence / static_cast<double>(cloud->size())
              << '\n';
    const std::string output = "labeled_" + std::to_string(file) + ".pcd";
    pcl::io::savePCDFileBinaryCompressed(output, labeled(*cloud, labels));
  }
  return argc > 1 ? 0 : 1;
}
