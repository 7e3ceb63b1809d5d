// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Counts and lines about targets that were grasped.

#include "outcomes.h"

#include <iostream>

namespace grasps {

Json
toJson(const Counts& counts)
{
  return {{"targets", counts.targets},
          {"with_a_sealing_grasp", counts.sealed},
          {"first_ranked_on_one_face", counts.on_one_face},
          {"centroid_on_one_face", counts.centroid_on_one_face}};
}

void
describe(std::uint64_t seed,
         std::size_t target,
         const char* shape,
         std::size_t points,
         const Outcome& outcome,
         const std::vector<pcl::SuctionGrasp>& grasps)
{
  std::cerr << "seed " << seed << " target " << target << ' ' << shape << ' ' << points
            << " points, face " << outcome.has_face << " seals " << outcome.seals
            << " one face " << outcome.is_on_one_face << " centroid "
            << outcome.is_centroid_on_one_face << ", " << grasps.size() << " grasps";
  if (!grasps.empty()) {
    const pcl::SuctionGrasp& first = grasps[0];
    std::cerr << "; score " << first.score << " border " << first.border_distance
              << " edge " << first.edge_distance << " obstacle "
              << first.obstacle_distance << " margin " << first.margin << " sag "
              << first.sag << " residual " << first.residual << " of "
              << first.residual_allowed << " likelihood " << first.likelihood;
  }
  std::cerr << '\n';
}

} // namespace grasps
