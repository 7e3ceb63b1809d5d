/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

// Made by scripts/calibrate_labels.sh.

#include <array>

namespace pcl::segmentation {

/** The confidence of a label is 1 / (1 + exp(-(constant + features · weights))). */
struct LabelWeights {
  double constant;
  std::array<double, 4> features;
};

constexpr LabelWeights planar_weights{0.5573, {0.4652, 1.39, 0.08977, 2.386}};
constexpr LabelWeights curved_weights{-1.762, {1.492, 0.1903, 0.2262, 2.23}};
constexpr LabelWeights edge_weights{-0.2943, {0.4299, 0.9094, 3.658, 2.545}};

} // namespace pcl::segmentation
