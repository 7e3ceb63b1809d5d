// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Buffers and tables that the SIMD kernels of all targets share.

#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

namespace pcl::kernels {

/** \brief A buffer that only grows, aligned and padded for vectors of any target.
 * Growing forgets the contents. */
template <typename T>
class AlignedBuffer {
public:
  T*
  atLeast(std::size_t count)
  {
    constexpr std::size_t padding = 64;
    if (count + padding > capacity_) {
      const std::size_t capacity = 2 * (count + padding);
      lines_.reset();
      capacity_ = 0;
      lines_.reset(new Line[(capacity * sizeof(T) + sizeof(Line) - 1) / sizeof(Line)]);
      capacity_ = capacity;
    }
    return reinterpret_cast<T*>(lines_.get());
  }

private:
  struct alignas(64) Line { // of a cache, and the longest vector
    unsigned char bytes[64];
  };

  std::unique_ptr<Line[]> lines_;
  std::size_t capacity_ = 0;
};

/** \brief What a thread keeps from block to block. */
struct SimdScratch {
  AlignedBuffer<std::uint32_t> near;    ///< clusters near the block, and ends of runs
  AlignedBuffer<float> slots;           ///< their points
  AlignedBuffer<std::uint32_t> offsets; ///< of candidates in the slots, or the surface
  AlignedBuffer<std::uint32_t> angles;  ///< of a block's queries, or order of points
  AlignedBuffer<float> values;          ///< of one query
  AlignedBuffer<std::uint32_t> masks;
};

SimdScratch& simdScratch();

/** \brief For each mask of lanes, which lanes to take to move those of set bits to the
 * front. */
template <std::size_t lanes>
struct CompressLanes {
  std::uint32_t rows[std::size_t{1} << lanes][lanes];
};

extern const CompressLanes<4> compress_lanes_4;
extern const CompressLanes<8> compress_lanes_8;

} // namespace pcl::kernels
