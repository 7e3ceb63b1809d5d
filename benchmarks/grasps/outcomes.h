// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What became of each target.

#pragma once

#include <pcl/segmentation/suction_grasp_estimation.h>

#include <nlohmann/json.hpp>

#include <cstdint>
#include <vector>

namespace grasps {

using Json = nlohmann::ordered_json;

/** What became of one target. */
struct Outcome {
  bool has_face = false; ///< of twice the cup
  bool is_curved = false;
  bool seals = false;
  bool is_on_one_face = false;
  bool is_centroid_on_one_face = false;
};

struct Counts {
  std::uint64_t targets = 0, sealed = 0, on_one_face = 0, centroid_on_one_face = 0;
  std::uint64_t sealed_on_one_face = 0;

  void
  add(const Outcome& of)
  {
    ++targets;
    sealed += of.seals ? 1 : 0;
    on_one_face += of.is_on_one_face ? 1 : 0;
    sealed_on_one_face += of.seals && of.is_on_one_face ? 1 : 0;
    centroid_on_one_face += of.is_centroid_on_one_face ? 1 : 0;
  }
};

Json toJson(const Counts& counts);

/** A line about one target, with the measures of the grasp ranked first. */
void describe(std::uint64_t seed,
              std::size_t target,
              const char* shape,
              std::size_t points,
              const Outcome& outcome,
              const std::vector<pcl::SuctionGrasp>& grasps);

} // namespace grasps
