// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The results of a comparison, cloud by cloud and in the mean.

#pragma once

#include "trial.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace peers {

/** \brief The best that a peer did; settings, thresholds and trials of each cloud. */
struct Result {
  std::string peer;
  bool is_tuned = false; ///< thresholds were chosen, and are not the peer's own
  std::vector<std::string> settings;
  std::vector<float> thresholds;
  std::vector<Trial> trials;
};

/** \brief The clouds: names and sizes. */
nlohmann::ordered_json describe(const std::vector<LabeledCloud>& clouds);

/** \brief A result: cloud by cloud, and means over the clouds for which a number
 * exists. */
nlohmann::ordered_json toJson(const Result& result);

} // namespace peers
