// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Suction grasps: what they are looked for on.

#pragma once

#include <pcl/segmentation/suction_grasp_estimation.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::detail {

/** \brief An object, or a whole scene, and what is known of its surface. One entry for
 * each point of the target. */
struct GraspTarget {
  XYZView cloud;                      ///< everything that may be in the way
  std::vector<std::uint32_t> points;  ///< the target's, positions in the cloud
  std::vector<float> normals;         ///< three each, outwards; NaN unknown
  std::vector<float> edge_likelihood; ///< NaN unknown
  std::vector<float> spacings;        ///< meters
  double noise = 0.0;                 ///< in spacings
};

/** \brief One class of surface: 1 planar, 2 curved, and how likely it is at each point
 * of the target; NaN unknown. */
struct GraspSurface {
  std::uint32_t surface = 0;
  std::vector<float> likelihood;
};

/** \brief What is wrong with a cup; empty if nothing is. */
std::string problemOfCup(const SuctionCup& cup);

/** \brief What is wrong with it for this target; empty if nothing is. */
std::string problemOfCup(const SuctionCup& cup, const GraspTarget& target);

/** \brief Places for a cup, the best first. See doc/grasps.md for the steps. */
std::vector<SuctionGrasp> findGrasps(const GraspTarget& target,
                                     const std::vector<GraspSurface>& surfaces,
                                     const SuctionCup& cup,
                                     unsigned threads);

} // namespace pcl::detail
