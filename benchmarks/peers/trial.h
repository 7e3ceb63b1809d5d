// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// One setting of a method on one cloud.

#pragma once

#include "peer.h"

#include <vector>

namespace peers {

/** \brief What a setting gave on one cloud: the scores of the points of its truth. */
struct Trial {
  const LabeledCloud* cloud = nullptr;
  const Truth* truth = nullptr;
  std::vector<float> scores; ///< of truth->points
  double seconds = 0.0;      ///< processor time
};

/** \brief Run a setting on a cloud. \throws std::runtime_error if it does not give a
 * score for each point */
Trial run(const Setting& setting, const LabeledCloud& cloud, Task task);

/** \brief How well the class looked for and the others were found if points belong to
 * it from a threshold on. */
pcl::app::Evaluation evaluate(const Trial& trial, float threshold);

/** \brief Mean F1 of the class looked for, over the clouds that have it. */
double meanF1(const std::vector<const Trial*>& trials, float threshold);

/** \brief The threshold with the largest meanF1(), out of 200 quantiles of the scores
 * of that class. */
float bestThreshold(const std::vector<const Trial*>& trials);

} // namespace peers
