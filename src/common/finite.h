// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Whether points are finite.

#pragma once

#include <pcl/features/xyz_view.h>

#include <cstddef>

namespace pcl::kernels {

/** \brief Whether three floats are finite: the difference of a float with itself is 0,
 * unless it is not finite. */
inline bool
isFinite(const float* p)
{
  return (p[0] - p[0]) + (p[1] - p[1]) + (p[2] - p[2]) == 0.0f;
}

inline std::size_t
countFinite(const XYZView& points)
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.size; ++i)
    count += isFinite(points[i]) ? 1 : 0;
  return count;
}

} // namespace pcl::kernels
