// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include "grasps/target_surface.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace pcl::segmentation {

/** \brief Where a mean shift ended. */
struct Mode {
  Eigen::Vector3f position = Eigen::Vector3f::Zero();
  Eigen::Vector3f normal = Eigen::Vector3f::Zero(); ///< mean of the window, unit
  float density = 0.0f;   ///< of the likelihood there, to compare modes
  float bandwidth = 0.0f; ///< metres
  std::uint32_t starts = 1;
  std::uint32_t iterations = 0;
  bool converged = false;
};

/** \brief The modes of a likelihood over a surface, by an adaptive mean shift from
 * starts all over it; those nearer than half the least bandwidth are one. The densest
 * comes first. \param[in] weights one for each of surface.points(), 0 and more
 * \param[in] least bandwidth, metres */
std::vector<Mode> likelihoodModes(const TargetSurface& surface,
                                  const std::vector<float>& weights,
                                  float least,
                                  unsigned threads);

/** \brief A place on a surface. */
struct Place {
  Eigen::Vector3f position;
  Eigen::Vector3f normal; ///< unit
};

/** \brief For each place, the best one first, the one that stands for it: itself, or
 * the first better one that does so for itself, is nearer than the radius and faces the
 * same way to 45 degrees. */
std::vector<std::size_t> representativesOf(const std::vector<Place>& places,
                                           float radius);

} // namespace pcl::segmentation
