// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Which patches are ground: level, planar, and connected or at the ground's height.

#pragma once

#include "ground/ground_patches.h"

#include <array>
#include <vector>

namespace pcl::segmentation {

/** \brief Which patches are ground: level enough, planar, and connected over steps that
 * ground may have; and the others like them that are as low and several.
 *
 * The planes of those are fitted again, to ground only. */
std::vector<char> connectedGround(const GroundCells& cells,
                                  const GroundParameters& parameters,
                                  unsigned threads,
                                  GroundPatches& all);

/** \brief The cell's own patch and the nearest ones on its four sides, if they are
 * ground, else no_patch. */
std::array<std::uint32_t, 5>
nearGround(const GroundPatches& all, const std::vector<char>& ground, std::size_t cell);

} // namespace pcl::segmentation
