// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// How much of whole objects was found, by the measures of unseen object segmentation.

#pragma once

#include "evaluation/evaluation.h"

#include <cstdint>
#include <vector>

namespace pcl::app {

/** \brief What counts as one object of the truth. */
struct ObjectRules {
  std::uint32_t parts = 1;        ///< the truth has labels parts * object + part
  std::uint64_t min_points = 300; ///< smaller objects need not be found
};

/** \brief Instances matched with objects, each once, so that the sum of the F-measures
 * of the pairs is largest. Points that a pair shares are hits. */
struct ObjectEvaluation {
  Score overlap; ///< of points: misses of the objects, false alarms of all instances
  std::uint64_t objects = 0;   ///< with min_points or more
  std::uint64_t instances = 0; ///< predicted
  std::uint64_t found = 0;     ///< objects whose instance has an IoU of min_found_iou

  /** \brief Share of the objects that were found. NaN if there is none. */
  double foundShare() const;
};

constexpr double min_found_iou = 0.7; ///< an object so covered can be handled

ObjectEvaluation evaluateObjects(const std::vector<LabelPair>& points,
                                 const ObjectRules& rules);

} // namespace pcl::app
