// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Weights of the features of labels, made by scripts/calibrate_labels.sh.

#pragma once

#include <array>

namespace pcl::segmentation {

/** How probable it is that nothing speaks against a label in one respect:
 * 1 / (1 + exp(-(constant + features · weights))). The confidence is the product. */
struct LabelWeights {
  double constant;
  std::array<double, 5> features;
};

/** Of a surface: it is no edge; it is the likeliest of the surfaces. */
constexpr LabelWeights no_edge_weights{-0.0253, {0, 0.885, 4.05, 1.13, 0}};
constexpr LabelWeights class_weights{-4.44, {1.18, 0, 0, 1.26, 3.81}};
constexpr LabelWeights edge_weights{1.23, {0.431, 0.355, 1.73, 0.577, 0}};

} // namespace pcl::segmentation
