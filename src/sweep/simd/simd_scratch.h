// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include "sweep/sweep_block.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>

namespace pcl::kernels {

/** \brief A buffer that only grows, aligned and padded for vectors of any target.
 * Growing forgets the contents. */
template <typename T>
class AlignedBuffer {
public:
  T*
  atLeast(std::size_t count)
  {
    if (count + padding > capacity_) {
      const std::size_t capacity = 2 * (count + padding);
      data_.reset();
      capacity_ = 0;
      data_.reset(static_cast<T*>(
          ::operator new(capacity * sizeof(T), std::align_val_t(alignment))));
      capacity_ = capacity;
    }
    return data_.get();
  }

  T*
  data() const
  {
    return data_.get();
  }

private:
  static constexpr std::size_t alignment = 64;
  static constexpr std::size_t padding = 64;

  struct Delete {
    void
    operator()(T* p) const
    {
      ::operator delete(p, std::align_val_t(alignment));
    }
  };

  std::unique_ptr<T, Delete> data_;
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

/** \brief Rows that move the lanes of set bits to the front, for 4 and 8 lanes. */
extern const std::uint32_t compress_lanes_4[16][4];
extern const std::uint32_t compress_lanes_8[256][8];

} // namespace pcl::kernels
