/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include "ground_neighbors.h"

#include <cstddef>
#include <vector>

namespace pcl::segmentation {

/** \brief The lowest surface in a cell, and a plane through it and its neighbors. */
struct GroundPatch {
  float x = 0.0f, y = 0.0f, low = 0.0f; ///< the middle of its own points
  float z = 0.0f;                       ///< of the plane there
  float slope_x = 0.0f, slope_y = 0.0f;
  float planar = 0.0f; ///< likelihood; 0 unknown

  /** \brief How high above the plane a point is. */
  float
  above(float px, float py, float pz) const
  {
    return pz - (z + slope_x * (px - x) + slope_y * (py - y));
  }
};

/** \brief How much higher or lower than expected ground may be, from patch to patch. */
float mostRise(const GroundPatch& a, const GroundPatch& b, float max_step);

/** \brief Whether the second patch continues the plane of the first, or is a step
 * beside it. */
bool continues(const GroundPatch& a, const GroundPatch& b, float max_step);

/** \brief Of slopes that are known before: the height of a patch is known to 1 cm,
 * ground turns by 3 degrees, (0.01 / 0.05)^2. */
constexpr float prior_weight = 0.04f;

/** \brief Fit the plane of a patch to the middles of its own and other points.
 * \param[in] prior_weight of the slopes that the patch has, against the points, metres
 * squared \return false if the points lie on a line */
bool fitPlane(GroundPatch& patch,
              const GroundPatch* const* others,
              std::size_t count,
              float prior_weight);

/** \brief A plane through the patch and a neighbor in each of both directions, then one
 * that fits to all neighbors that it passes nearby. Where one line of points is all
 * there is, the ground is as level across it as in the large.
 * \return false if there is none */
bool fitRobustly(const std::vector<GroundPatch>& low,
                 const PatchNeighbors& neighbors,
                 float near,
                 GroundPatch& patch);

} // namespace pcl::segmentation
