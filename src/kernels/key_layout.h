/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include "row_index.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace pcl::kernels {

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
    for (std::int64_t span = std::int64_t{last} - first; span > 0; span >>= 1) {
      ++bits;
    }
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

} // namespace pcl::kernels
