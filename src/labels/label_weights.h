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

constexpr LabelWeights planar_weights{-1.11, {0.594, 1.44, 0.4828, 1.769, 0.1914}};
constexpr LabelWeights curved_weights{0.7913, {0.65, 1.044, 0, 4.616, 0.05914}};
constexpr LabelWeights edge_weights{-7.072, {0.9283, 1.576, 3.113, 2.915, 1.419}};

} // namespace pcl::segmentation
