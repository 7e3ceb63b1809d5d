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

constexpr LabelWeights planar_weights{-1.149, {0.5816, 1.486, 0.4877, 1.749, 0.1644}};
constexpr LabelWeights curved_weights{0.9056, {0.6163, 1.054, 0, 4.817, 0.1101}};
constexpr LabelWeights edge_weights{-7.229, {0.8824, 1.607, 2.842, 2.911, 1.218}};

} // namespace pcl::segmentation
