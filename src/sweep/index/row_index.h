// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include "common/finite.h"
#include "sweep/index/clusters.h"
#include "sweep/index/radix_sort.h"

#include <pcl/features/neighborhood_sweep.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
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

/** Points are first sorted by cells of this fraction of the edge along x. */
inline constexpr double x_cells_an_edge = 64.0;

/** More digits of x than these are left to the sort within the rows. */
inline constexpr int most_x_bits = 16;

/** \brief The cells that coordinates are in. */
struct CellRange {
  std::int32_t first = std::numeric_limits<std::int32_t>::max();
  std::int32_t last = std::numeric_limits<std::int32_t>::min();

  void
  add(std::int32_t cell)
  {
    first = std::min(first, cell);
    last = std::max(last, cell);
  }

  int
  bits() const
  {
    int bits = 0;
    for (std::int64_t span = std::int64_t{last} - first; span > 0; span >>= 1)
      ++bits;
    return bits;
  }
};

/** \brief The cells that finite points are in, along each axis. */
struct Cells {
  CellRange x, y, z;
  std::size_t count = 0; ///< of finite points

  void
  merge(const Cells& other)
  {
    count += other.count;
    if (other.count > 0) {
      x.add(other.x.first), x.add(other.x.last);
      y.add(other.y.first), y.add(other.y.last);
      z.add(other.z.first), z.add(other.z.last);
    }
  }
};

/** \brief How the bits of a key are shared by (z cell, y cell, x cell). */
class KeyLayout {
public:
  explicit KeyLayout(const Cells& all)
  : all_(all)
  , y_bits_(all.y.bits())
  , row_bits_(y_bits_ + all.z.bits())
  , x_bits_(std::min({all.x.bits(), most_x_bits, 64 - row_bits_}))
  , x_shift_(all.x.bits() - x_bits_)
  {
    // Half the bytes to move if there are bits enough.
    constexpr int least_x_bits = 12;
    if (row_bits_ + std::min(x_bits_, least_x_bits) <= 32) {
      x_bits_ = std::min(x_bits_, 32 - row_bits_);
      x_shift_ = all.x.bits() - x_bits_;
    }
  }

  int
  bits() const
  {
    return x_bits_ + row_bits_;
  }

  /** \brief The key of a point in these cells. */
  template <typename Key>
  Key
  keyOf(std::int32_t x_cell, std::int32_t y_cell, std::int32_t z_cell) const
  {
    const Key x = offset<Key>(x_cell, all_.x);
    const Key y = offset<Key>(y_cell, all_.y);
    const Key z = offset<Key>(z_cell, all_.z);
    return static_cast<Key>(((shifted(z, y_bits_) | y) << x_bits_) | (x >> x_shift_));
  }

  template <typename Key>
  Key
  rowOf(Key key) const
  {
    return static_cast<Key>(key >> x_bits_);
  }

  Row
  rowAt(std::uint64_t row, std::uint32_t begin) const
  {
    const std::uint64_t y = row & ((std::uint64_t{1} << y_bits_) - 1);
    return {static_cast<std::int32_t>(static_cast<std::int64_t>(row >> y_bits_) +
                                      all_.z.first),
            static_cast<std::int32_t>(static_cast<std::int64_t>(y) + all_.y.first),
            begin,
            0};
  }

private:
  template <typename Key>
  static Key
  offset(std::int32_t cell, const CellRange& range)
  {
    return static_cast<Key>(std::int64_t{cell} - range.first);
  }

  /** \brief A shift by all bits is not defined: there is nothing to shift then. */
  template <typename Key>
  static Key
  shifted(Key value, int bits)
  {
    return value == 0 ? value : static_cast<Key>(value << bits);
  }

  const Cells& all_;
  int y_bits_, row_bits_, x_bits_, x_shift_;
};

/** \brief The points to sort: some of those given, or all. */
struct Selection {
  const XYZView& points;
  const std::int32_t* indices;

  const float*
  operator[](std::size_t i) const
  {
    return points[indices ? static_cast<std::size_t>(indices[i]) : i];
  }
};

/** \brief The finite ones among a few points, as structure of arrays. */
class PointChunk {
public:
  static constexpr std::size_t most = 256;

  /** \brief Those of [begin, end), at most `most`. */
  PointChunk(const Selection& points, std::size_t begin, std::size_t end)
  {
    for (std::size_t i = begin; i < end; ++i) {
      const float* p = points[i];
      index_[count_] = static_cast<std::uint32_t>(i);
      for (std::size_t axis = 0; axis < 3; ++axis)
        at_[axis][count_] = p[axis];
      count_ += isFinite(p) ? 1 : 0;
    }
    for (auto& coordinates : at_)
      std::fill(coordinates + count_, coordinates + padded(), coordinates[0]);
  }

  std::size_t
  count() const
  {
    return count_;
  }

  /** \brief `count` rounded up to whole blocks; the first point fills them up. */
  std::size_t
  padded() const
  {
    return (count_ + block_size - 1) / block_size * block_size;
  }

  const float*
  coordinates(std::size_t axis) const
  {
    return at_[axis];
  }

  std::uint32_t
  index(std::size_t i) const
  {
    return index_[i];
  }

private:
  // One more: what is not finite is written, but not kept.
  float at_[3][most + block_size];
  std::uint32_t index_[most + block_size];
  std::size_t count_ = 0;
};

/** \brief visit(chunk) for the points [begin, end). */
template <typename Visit>
void
forEachChunk(const Selection& points,
             std::size_t begin,
             std::size_t end,
             const Visit& visit)
{
  for (; begin < end; begin += PointChunk::most)
    visit(PointChunk(points, begin, std::min(end, begin + PointChunk::most)));
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
  constexpr std::size_t steps_ahead = 24;
  for (std::size_t i = begin; i < end; ++i) {
    if (i + steps_ahead < end)
      __builtin_prefetch(pointAt(i + steps_ahead));
    visit(i, pointAt(i));
  }
}

/** \brief Sort the points of each row by x, y and z. They are sorted by cells of x. */
void finishRows(RowIndex& index, unsigned threads);

} // namespace pcl::kernels
