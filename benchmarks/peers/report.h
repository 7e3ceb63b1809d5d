// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The results of a comparison, cloud by cloud and in the mean.

#pragma once

#include "trial.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace peers {

/** \brief The best that a peer did. */
struct Result {
  std::string peer, setting;
  bool is_tuned = false; ///< the threshold was chosen for these clouds
  float threshold = 0.0f;
  std::vector<Trial> trials;
};

/** \brief The clouds: names and sizes. */
nlohmann::ordered_json describe(const std::vector<LabeledCloud>& clouds);

/** \brief A result: cloud by cloud, and means over the clouds for which a number
 * exists. */
nlohmann::ordered_json toJson(const Result& result);

} // namespace peers
