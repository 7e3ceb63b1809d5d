/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <cstddef>
#include <cstdint>

namespace pcl::kernels {

// KernelTable (sweep_block.h) says what these are.

void cellsOfCoordinates(const float* coordinates,
                        std::size_t count,
                        double cells_a_metre,
                        std::int32_t* out);

std::uint32_t countLess(const float* values, std::size_t count, float bound);

} // namespace pcl::kernels
