/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "portable_index.h"

#include "row_index.h"

#include <algorithm>

namespace pcl::kernels {

void
cellsOfCoordinates(const float* coordinates,
                   std::size_t count,
                   double cells_a_metre,
                   std::int32_t* out)
{
  std::transform(coordinates, coordinates + count, out, [=](float coordinate) {
    return cellOf(coordinate, cells_a_metre);
  });
}

std::uint32_t
countLess(const float* values, std::size_t count, float bound)
{
  return static_cast<std::uint32_t>(
      std::count_if(values, values + count, [bound](float v) { return v < bound; }));
}

} // namespace pcl::kernels
