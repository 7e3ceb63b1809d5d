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

namespace pcl::kernels {

/** \brief visit(i, pointAt(i)) for i in [begin, end), where points are far apart in
 * memory: they are asked for some steps before they are needed. */
template <typename PointAt, typename Visit>
void
forEachPoint(std::size_t begin,
             std::size_t end,
             const PointAt& pointAt,
             const Visit& visit)
{
  constexpr std::size_t steps_ahead = 24;
  for (std::size_t i = begin; i < end; ++i) {
    if (i + steps_ahead < end) {
      __builtin_prefetch(pointAt(i + steps_ahead));
    }
    visit(i, pointAt(i));
  }
}

} // namespace pcl::kernels
