/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include "finite.h"
#include "key_layout.h"

#include <pcl/features/neighborhood_sweep.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace pcl::kernels {

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
      for (std::size_t axis = 0; axis < 3; ++axis) {
        at_[axis][count_] = p[axis];
      }
      count_ += isFinite(p) ? 1 : 0;
    }
    for (auto& coordinates : at_) {
      std::fill(coordinates + count_, coordinates + padded(), coordinates[0]);
    }
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
  for (; begin < end; begin += PointChunk::most) {
    visit(PointChunk(points, begin, std::min(end, begin + PointChunk::most)));
  }
}

} // namespace pcl::kernels
