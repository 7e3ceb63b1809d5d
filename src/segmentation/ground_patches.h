/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include "ground_cells.h"

#include <pcl/segmentation/ground_detection.h>

#include <array>
#include <cstdint>
#include <vector>

namespace pcl::segmentation {

constexpr std::int32_t no_patch = -1;

/** \brief A surface may continue as far away as its own range: 16 cells of 4 % around a
 * laser. */
constexpr std::uint32_t most_bins_apart = 16;

/** \brief Patches on lines beside each other are neighbors if they are so near. */
constexpr std::uint32_t most_bins_beside = 4;

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

/** \brief The nearest patches: before and behind in the line, on the lines beside it.
 */
using PatchNeighbors = std::array<std::int32_t, 4>;

enum PatchSide : std::size_t { Inner = 0, Outer = 1, Right = 2, Left = 3 };

struct GroundPatches {
  std::vector<GroundPatch> patches; ///< one a cell; not planar where there is none
  std::vector<PatchNeighbors> neighbors;
};

/** \brief The planarity of the lowest surface, cell by cell. \param[in] feet see
 * feetOf() */
GroundPatches groundPatches(const GroundCells& cells,
                            const std::vector<char>& feet,
                            const GroundParameters& parameters,
                            unsigned threads);

/** \brief Fit the plane of a patch to the middles of its own and other points.
 * \param[in] prior_weight of the slopes that the patch has, against the points, metres
 * squared \return false if the points lie on a line */
bool fitPlane(GroundPatch& patch,
              const GroundPatch* const* others,
              std::size_t count,
              float prior_weight);

} // namespace pcl::segmentation
