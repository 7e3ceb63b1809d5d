/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include "ground_patches.h"

namespace pcl::segmentation {

/** \brief Which patches are ground: level enough, planar, and connected over steps that
 * ground may have; and the others like them that are as low and several.
 *
 * The planes of those are fitted again, to ground only. */
std::vector<char> connectedGround(const GroundCells& cells,
                                  const GroundParameters& parameters,
                                  unsigned threads,
                                  GroundPatches& all);

/** \brief The surfaces of the ground near a cell. */
struct NearGround {
  static constexpr std::size_t most = 5;
  std::array<std::int32_t, most> patches{};
  std::size_t count = 0;
};

/** \brief The cell's own patch and the nearest ones on its sides, if they are ground.
 */
NearGround
nearGround(const GroundPatches& all, const std::vector<char>& ground, std::size_t cell);

} // namespace pcl::segmentation
