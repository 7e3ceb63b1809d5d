// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What a peer does with the setting and the threshold that suit it best.

#pragma once

#include "report.h"

#include <vector>

namespace peers {

/** \brief Which clouds a peer's setting and threshold are the best for. */
struct Tuning {
  /** These; none: the clouds of the contest. */
  const std::vector<LabeledCloud>* clouds = nullptr;
  bool is_held_out = false; ///< for each cloud of the contest, the other ones
};

/** \brief Run a peer on clouds, `jobs` at a time. \throws std::invalid_argument if one
 * cloud is to be held out and there is no other */
Result compete(const Peer& peer,
               const std::vector<LabeledCloud>& clouds,
               const Tuning& tuning,
               Task task,
               int jobs);

} // namespace peers
