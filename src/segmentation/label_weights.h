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
  std::array<double, 5> features;
};

constexpr LabelWeights planar_weights{0.2008, {0.3361, 1.428, 0.1347, 2.491, 1.008}};
constexpr LabelWeights curved_weights{-1.223, {1.563, 0.08196, 0.02973, 2.791, 0}};
constexpr LabelWeights edge_weights{-4.027, {0.5143, 1.04, 2.048, 3.323, 0}};

} // namespace pcl::segmentation
