// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Loops over the cells of points, on several threads.

#pragma once

#include "common/finite.h"
#include "common/parallel.h"
#include "geometry/cell_order.h"

#include <pcl/features/xyz_view.h>

#include <cstdint>
#include <vector>

namespace pcl::segmentation {

/** \brief use(begin, end, k) for the points of the k-th cell, of all cells in any
 * order. \param[in] begins see beginsOfCells() */
template <typename Points, typename Use>
void
forEachCell(Points& sorted,
            const std::vector<std::size_t>& begins,
            unsigned threads,
            const Use& use)
{
  kernels::parallelForEach(begins.size() - 1, threads, [&](std::size_t k) {
    const auto at = [&](std::size_t i) {
      return sorted.begin() + static_cast<std::ptrdiff_t>(i);
    };
    use(at(begins[k]), at(begins[k + 1]), k);
  });
}

/** \brief The finite points in the order of their cells; those of one cell keep theirs.
 * \param[in] cellOf the cell at x, y and z */
template <typename CellOf>
std::vector<CellPoint>
sortedByCell(const XYZView& points, unsigned threads, const CellOf& cellOf)
{
  auto sorted = kernels::collectForEach<CellPoint>(
      static_cast<std::uint32_t>(points.size),
      threads,
      [&](std::uint32_t i, std::vector<CellPoint>& of_part) {
        if (kernels::isFinite(points[i]))
          of_part.push_back({cellOf(points[i]), i});
      });
  sortByCell(sorted, threads);
  return sorted;
}

} // namespace pcl::segmentation
