// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The weights of the features of labels. Made by scripts/calibrate_labels.sh.

#pragma once

#include <array>

namespace pcl::segmentation {

/** The confidence of a label is 1 / (1 + exp(-(constant + features · weights))). */
struct LabelWeights {
  double constant;
  std::array<double, 5> features;
};

constexpr LabelWeights planar_weights{0.1392, {0.3308, 1.487, 0.1223, 2.463, 0.988}};
constexpr LabelWeights curved_weights{-1.256, {1.567, 0.09238, 0.0297, 2.821, 0}};
constexpr LabelWeights edge_weights{-2.191, {0.7165, 0.5148, 3.479, 2.875, 2.393}};

} // namespace pcl::segmentation
