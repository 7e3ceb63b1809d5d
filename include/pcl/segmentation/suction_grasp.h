/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/features/neighborhood_sweep.h>

#include <Eigen/Core>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl {

/** \brief A round suction cup with a soft lip. */
struct SuctionCup {
  double radius = 0.01;    ///< of the lip, metres
  double compliance = 0.2; ///< how far the lip may bend out of its plane, in radii
};

/** \brief Why a cup leaks. */
enum class SealProblem : std::uint8_t {
  Border,   ///< the surface ends, or has a hole, under the cup
  Edge,     ///< an edge is under the cup
  Obstacle, ///< something stands on the surface, or before it, in the cup's way
  Bent,     ///< the lip would have to bend further than it can
  Rough     ///< the surface is neither flat nor of one curvature
};

/** \brief A lower-case English word, e.g. "border". */
PCL_SHAPE_EXPORTS const char* nameOf(SealProblem problem);

/** \brief A place for a suction cup. Lengths in metres. \ingroup segmentation */
struct SuctionGrasp {
  Eigen::Vector3f position = Eigen::Vector3f::Zero(); ///< on the surface
  Eigen::Vector3f approach = Eigen::Vector3f::Zero(); ///< unit, into the surface
  float score = 0.0f;                ///< 0 to 1; above 0.5 if and only if it seals
  std::vector<SealProblem> problems; ///< none if it seals

  std::uint32_t surface = 0; ///< the class looked for: 1 planar, 2 curved
  float likelihood = 0.0f;   ///< of this class, mean under the cup
  float covered = 0.0f;      ///< share of the area under the cup, with its margin
  float border_distance =
      0.0f; ///< to where the surface ends; at most 2 cup radii + margin
  float edge_distance = 0.0f;     ///< to the nearest edge point, likewise
  float obstacle_distance = 0.0f; ///< across the approach, likewise
  float sag = 0.0f;               ///< by which the lip has to bend
  float sag_allowed = 0.0f;       ///< the cup's compliance, and what noise may add
  float residual = 0.0f;          ///< r.m.s. distance of the points from the surface
  float residual_allowed = 0.0f;
  float margin = 0.0f; ///< beside the cup that must be free as well

  std::uint32_t starts = 0;     ///< of the mean shift that ended here
  std::uint32_t iterations = 0; ///< of it
  bool converged = false;
  float bandwidth = 0.0f;
  float moved = 0.0f; ///< from the mode to where the cup fits

  bool
  seals() const
  {
    return problems.empty();
  }
};

namespace detail {

/** \brief An object, or a whole scene, and what is known of its surface. One entry for
 * each point of the target. */
struct GraspTarget {
  XYZView cloud;                      ///< everything that may be in the way
  std::vector<std::uint32_t> points;  ///< the target's, positions in the cloud
  std::vector<float> normals;         ///< three each, outwards; NaN unknown
  std::vector<float> edge_likelihood; ///< NaN unknown
  std::vector<float> spacings;        ///< metres
  double noise = 0.0;                 ///< in spacings
};

/** \brief One class of surface: 1 planar, 2 curved, and how likely it is at each point
 * of the target; NaN unknown. */
struct GraspSurface {
  std::uint32_t surface = 0;
  std::vector<float> likelihood;
};

/** \brief What is wrong with a cup; empty if nothing is. */
PCL_SHAPE_EXPORTS std::string problemOfCup(const SuctionCup& cup);

/** \brief What is wrong with it for this target; empty if nothing is. */
PCL_SHAPE_EXPORTS std::string problemOfCup(const SuctionCup& cup,
                                           const GraspTarget& target);

/** \brief Places for a cup, the best first. See doc/grasps.md for the steps. */
PCL_SHAPE_EXPORTS std::vector<SuctionGrasp>
findGrasps(const GraspTarget& target,
           const std::vector<GraspSurface>& surfaces,
           const SuctionCup& cup,
           unsigned threads);

} // namespace detail
} // namespace pcl
