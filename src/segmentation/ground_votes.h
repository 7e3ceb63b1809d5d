/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include "coarse_ground.h"
#include "ground_patches.h"

#include <cstddef>
#include <vector>

namespace pcl::segmentation {

constexpr std::size_t least_patches = 4; // of ground that stands alone

/** \brief A patch that is level and not ground, yet: where it is, in what set. */
struct Rest {
  std::size_t patch, line, set;
};

/** \brief Move the sets that are at the height of the ground nearest to them from the
 * rest to the ground, by vote.
 * \param[in] coarse tells heights along the ground; null: the planes of patches do
 * \return whether there were any */
bool addLowSets(const GroundCells& cells,
                const GroundPatches& all,
                const CoarseGround* coarse,
                float max_step,
                std::vector<Rest>& rest,
                std::vector<char>& ground);

} // namespace pcl::segmentation
