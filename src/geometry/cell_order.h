// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Points in the order of the cells that they are in.

#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace pcl::segmentation {

/** \brief The numbers of a cell along three axes. */
using Cell = std::array<std::int32_t, 3>;

/** \brief As std::floor, which is a call, of what is not NaN and fits. */
template <typename Real>
std::int32_t
floorOf(Real value)
{
  const auto whole = static_cast<std::int32_t>(value);
  return static_cast<Real>(whole) > value ? whole - 1 : whole;
}

/** \brief The cell that a position is in; what lies far off shares the outermost ones.
 */
Cell cellOf(const float* position, float size);

/** \brief As ==, which calls memcmp. */
inline bool
areSame(const Cell& a, const Cell& b)
{
  return ((a[0] ^ b[0]) | (a[1] ^ b[1]) | (a[2] ^ b[2])) == 0;
}

/** \brief A point, and the cell that it is in. */
struct CellPoint {
  Cell cell;
  std::uint32_t point;
};

/** \brief Sorts by cells, their first numbers first. Points of one cell keep their
 * order. */
void sortByCell(std::vector<CellPoint>& points, unsigned threads);

/** \brief The first point of each cell, and the end. */
std::vector<std::size_t> beginsOfCells(const std::vector<CellPoint>& sorted,
                                       unsigned threads = 1);

} // namespace pcl::segmentation
