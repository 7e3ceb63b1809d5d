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

#include <array>
#include <cstdint>
#include <vector>

namespace pcl::segmentation {

constexpr std::int32_t no_patch = -1;

/** \brief The nearest patches: before and behind in the line, on the lines beside it.
 */
using PatchNeighbors = std::array<std::int32_t, 4>;

enum PatchSide : std::size_t { Inner = 0, Outer = 1, Right = 2, Left = 3 };

/** \brief Cell by cell, whether or not it has a surface itself. */
std::vector<PatchNeighbors> patchNeighbors(const GroundCells& cells,
                                           const std::vector<char>& has_surface,
                                           unsigned threads);

/** \brief The nearest patch on a side that is marked; what is between may be anything.
 * \param[in] most patches to go */
std::int32_t nextMarked(const std::vector<PatchNeighbors>& neighbors,
                        const std::vector<char>& marks,
                        std::size_t from,
                        PatchSide side,
                        int most);

/** \brief The nearest marked patch on lines to one side.
 * \param[in] most lines to go */
std::int32_t markedAside(const GroundCells& cells,
                         const std::vector<char>& marks,
                         std::size_t line,
                         std::uint32_t bin,
                         bool to_left,
                         int most);

} // namespace pcl::segmentation
