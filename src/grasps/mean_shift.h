// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The modes of a likelihood over a surface, by an adaptive mean shift.

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
  float bandwidth = 0.0f; ///< meters
  std::uint32_t starts = 1;
  std::uint32_t iterations = 0;
  bool converged = false;
};

/** \brief The modes of a likelihood over a surface, the densest first. The mean shift
 * starts all over the surface; modes nearer than half the smallest bandwidth are one.
 * \param[in] weights one for each of surface.points(), 0 and more
 * \param[in] min_bandwidth meters */
std::vector<Mode> likelihoodModes(const TargetSurface& surface,
                                  const std::vector<float>& weights,
                                  float min_bandwidth,
                                  unsigned threads);

/** \brief A place on a surface. */
struct Place {
  Eigen::Vector3f position;
  Eigen::Vector3f normal; ///< unit
};

/** \brief For each place, the best one first, the one that stands for it: itself, or
 * the first better one that does so for itself, is nearer than the radius and faces the
 * same way. */
std::vector<std::size_t> representativesOf(const std::vector<Place>& places,
                                           float radius);

} // namespace pcl::segmentation
