// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Finite points sorted into rows of cells, in clusters: where neighbors are found.

#pragma once

#include "common/radix_sort.h"
#include "sweep/sweep_block.h"

#include <pcl/features/neighborhood_sweep.h>

#include <array>

namespace pcl::kernels {

/** \brief A tube of the grid along x that holds points: `iy * edge <= y < (iy+1) *
 * edge`, z likewise. */
struct Row {
  std::int32_t iz;
  std::int32_t iy;
  std::uint32_t begin;         ///< position of its first point
  std::uint32_t first_cluster; ///< the cluster that begins there
};

/** \brief Up to block_size consecutive points of a row, not far apart, and the box
 * around them: distance tests look at it first, and queries are taken by clusters. */
struct Clusters {
  std::vector<std::uint32_t> begin; ///< first point of each, and an end mark
  /** min x, y, z, then max x, y, z; padded with block_size more */
  std::array<std::vector<float>, 6> box;

  std::size_t
  size() const
  {
    return begin.empty() ? 0 : begin.size() - 1;
  }
};

/** \brief Finite points sorted by (row, x, y, z), as structure of arrays.
 *
 * The grid is anchored at the origin, and only rows that hold points are stored: a far
 * outlier costs one row.
 */
struct RowIndex {
  double edge = 0.0;
  RawVector<float> x, y, z;       ///< resizePadded()
  RawVector<std::uint32_t> order; ///< index of each among those given; likewise
  std::vector<Row> rows;          ///< sorted by (iz, iy), and an end mark
  Clusters clusters;              ///< of the points, in order

  std::size_t
  size() const
  {
    return rows.empty() ? 0 : rows.back().begin;
  }

  double
  cellsPerMeter() const
  {
    return 1.0 / edge;
  }

  std::size_t
  rowCount() const
  {
    return rows.size() - 1;
  }
};

/** \brief Sort the finite ones among points[indices[0 .. count)], or among all points
 * if indices is null. order then holds positions in `indices`. */
RowIndex buildRowIndex(const XYZView& points,
                       const std::int32_t* indices,
                       std::size_t count,
                       double edge,
                       unsigned threads);

/** \brief Room for `size` values that are still to be set, and a block of 0 behind
 * them: kernels read whole vectors. */
template <typename T>
void
resizePadded(RawVector<T>& values, std::size_t size)
{
  values.resize(size + block_size);
  std::fill_n(values.begin() + static_cast<std::ptrdiff_t>(size), block_size, T{});
}

/** Cells are numbered by 32 bits, with room to step beyond the last one. */
constexpr std::int32_t max_cell = 1 << 30;

/** \brief The cell of a coordinate, clamped to +-max_cell.
 * \param[in] cells_per_meter 1 / edge of the cells */
inline std::int32_t
cellOf(double coordinate, double cells_per_meter)
{
  constexpr double limit = max_cell;
  const double cell = std::min(limit, std::max(-limit, coordinate * cells_per_meter));
  const auto truncated = static_cast<std::int32_t>(cell);
  return truncated - (static_cast<double>(truncated) > cell ? 1 : 0);
}

/** \brief visit(i, pointAt(i)) for i in [begin, end), where points are far apart in
 * memory: they are asked for some steps before they are needed. */
template <typename PointAt, typename Visit>
void
forEachPoint(std::size_t begin,
             std::size_t end,
             const PointAt& pointAt,
             const Visit& visit)
{
  constexpr std::size_t steps_ahead = 24; // about the time that memory takes
  for (std::size_t i = begin; i < end; ++i) {
    if (i + steps_ahead < end)
      __builtin_prefetch(pointAt(i + steps_ahead));
    visit(i, pointAt(i));
  }
}

} // namespace pcl::kernels
