/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include "clusters.h"
#include "raw_vector.h"

#include <pcl/features/neighborhood_sweep.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::kernels {

/** \brief A tube of the grid along x that holds points: `iy * edge <= y < (iy+1) *
 * edge`, z likewise. */
struct Row {
  std::int32_t iz;
  std::int32_t iy;
  std::uint32_t begin;         ///< position of its first point
  std::uint32_t first_cluster; ///< the cluster that begins there
};

/** \brief Kernels read whole vectors: this many floats behind the last point may be
 * read. */
constexpr std::size_t row_padding = 16;

/** \brief Room for `size` values that are still to be set, and padding that is 0. */
template <typename T>
void
resizePadded(RawVector<T>& values, std::size_t size)
{
  values.resize(size + row_padding);
  std::fill_n(values.begin() + static_cast<std::ptrdiff_t>(size), row_padding, T{});
}

/** \brief Finite points sorted by (row, x, y, z), as structure of arrays.
 *
 * The grid is anchored at the origin, and only rows that hold points are stored: a far
 * outlier costs one row.
 */
struct RowIndex {
  double edge = 0.0;
  RawVector<float> x, y, z;       ///< and row_padding more, which are 0
  RawVector<std::uint32_t> order; ///< index of each among those given; likewise
  std::vector<Row> rows;          ///< sorted by (iz, iy), and an end mark
  Clusters clusters;              ///< of the points, in order

  std::size_t
  size() const
  {
    return rows.empty() ? 0 : rows.back().begin;
  }

  double
  cellsAMetre() const
  {
    return 1.0 / edge;
  }

  std::size_t
  rowCount() const
  {
    return rows.size() - 1;
  }
};

constexpr std::int32_t most_cell = 1 << 30;

/** \brief The cell of a coordinate, clamped to +-most_cell.
 * \param[in] cells_a_metre 1 / edge of the cells */
inline std::int32_t
cellOf(double coordinate, double cells_a_metre)
{
  constexpr double limit = most_cell;
  const double cell = std::min(limit, std::max(-limit, coordinate * cells_a_metre));
  const auto truncated = static_cast<std::int32_t>(cell);
  return truncated - (static_cast<double>(truncated) > cell ? 1 : 0);
}

/** \brief Sort the finite ones among points[indices[0 .. count)], or among all points
 * if indices is null. order then holds positions in `indices`. */
RowIndex buildRowIndex(const XYZView& points,
                       const std::int32_t* indices,
                       std::size_t count,
                       double edge,
                       unsigned threads);

} // namespace pcl::kernels
