// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Weights of the features of labels, provisional: run scripts/calibrate_labels.sh.

#pragma once

#include <array>

namespace pcl::segmentation {

/** How probable it is that nothing speaks against a label in one respect:
 * 1 / (1 + exp(-(constant + features · weights))). The confidence is the product. */
struct LabelWeights {
  double constant;
  std::array<double, 7> features;
};

/** Of a surface: it is no edge; it is the likeliest of the surfaces. */
constexpr LabelWeights no_edge_weights{1.63, {0, 0, 0.529, 0.06, 4.03, 0.936, 0}};
constexpr LabelWeights class_weights{-2.56, {1.11, 0, 0, 0, 0, 0.41, 2.99}};
constexpr LabelWeights edge_weights{0.474, {1.15, 0.295, 2.13, 0, 0, 0, 0}};

} // namespace pcl::segmentation
