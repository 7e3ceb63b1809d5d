// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Points chosen by where they are, whatever their order in the cloud.

#pragma once

#include <pcl/features/xyz_view.h>

#include <array>
#include <cstdint>
#include <tuple>
#include <vector>

namespace pcl::segmentation {

/** \brief Whether a point comes before another one: by x, y and z, then by index. */
inline bool
isBefore(const XYZView& points, std::uint32_t a, std::uint32_t b)
{
  const float *p = points[a], *q = points[b];
  return std::tie(p[0], p[1], p[2], a) < std::tie(q[0], q[1], q[2], b);
}

/** \brief Sort indices by the x, y and z of their points; points at the same place by
 * their indices. */
void sortByPosition(const XYZView& points, std::vector<std::uint32_t>& indices);

/** \brief The cell of space that a place is in, numbered along each axis. */
std::array<float, 3> cellAt(const float* place, float cell);

/** \brief Of the candidates in each cell of space the one nearest to the middle of the
 * cell, the first of several as near. Cells are in the order of their coordinates. */
std::vector<std::uint32_t> centralPoints(const XYZView& points,
                                         const std::vector<std::uint32_t>& candidates,
                                         float cell,
                                         unsigned threads = 1);

} // namespace pcl::segmentation
