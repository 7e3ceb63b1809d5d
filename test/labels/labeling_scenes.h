// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Scenes to label, with their truth.

#pragma once

#include "segmentation/detection_scenes.h"

#include <pcl/segmentation/shape_labeling.h>

/** What the tests of labels share. */
namespace pcl::test {

constexpr std::uint32_t planar = 1, curved = 2, edge = 3;

inline PointLabels
labelsOf(const Cloud::ConstPtr& cloud, double confidence = -1.0, unsigned threads = 0)
{
  ShapeLabeling<PointXYZ> labeling;
  labeling.setInputCloud(cloud);
  labeling.setNumberOfThreads(threads);
  if (confidence >= 0.0)
    labeling.setConfidence(confidence);
  PointLabels labels;
  labeling.label(labels);
  return labels;
}

} // namespace pcl::test
