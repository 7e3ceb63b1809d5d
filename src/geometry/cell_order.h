// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Points in the order of the cells that they are in.

#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace pcl::segmentation {

/** \brief The numbers of a cell along three axes. */
using Cell = std::array<std::int32_t, 3>;

/** \brief A point, and the cell that it is in. */
struct CellPoint {
  Cell cell;
  std::uint32_t point;
};

/** \brief Sorts by cells, their first numbers first. Points of one cell keep their
 * order. */
void sortByCell(std::vector<CellPoint>& points, unsigned threads);

/** \brief use(begin, end) for the points of each cell, cell by cell. */
template <typename Use>
void
forEachCell(std::vector<CellPoint>& sorted, const Use& use)
{
  for (auto begin = sorted.begin(), end = begin; begin != sorted.end(); begin = end) {
    end = std::find_if(
        begin, sorted.end(), [&](const CellPoint& p) { return p.cell != begin->cell; });
    use(begin, end);
  }
}

} // namespace pcl::segmentation
