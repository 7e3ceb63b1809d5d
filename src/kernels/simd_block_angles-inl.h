/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#if defined(PCL_SHAPE_SIMD_BLOCK_ANGLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PCL_SHAPE_SIMD_BLOCK_ANGLES_INL_H_
#undef PCL_SHAPE_SIMD_BLOCK_ANGLES_INL_H_
#else
#define PCL_SHAPE_SIMD_BLOCK_ANGLES_INL_H_
#endif

#include "simd_inad_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

constexpr std::size_t long_lanes = lanes / 2;

/** \brief What the angles of each query of a block add up to: a vector of each at
 * first, whose lanes are added up several queries at once. */
class BlockTotals {
public:
  /** \param[in] size how many queries will be set: the others' sums are 0 */
  HWY_INLINE explicit BlockTotals(std::size_t size)
  {
    const auto nothing = hn::Zero(Longs());
    for (std::size_t i = size; i < block_size; ++i) {
      hn::Store(nothing, Longs(), parts_[i]);
      hn::Store(nothing, Longs(), squares_[i]);
    }
  }

  HWY_INLINE void
  set(std::size_t i, const AngleAdder& adder)
  {
    hn::Store(adder.parts(), Longs(), parts_[i]);
    hn::Store(adder.partsOfSquares(), Longs(), squares_[i]);
  }

  HWY_INLINE void
  store(std::uint64_t* sums, std::uint64_t* squares) const
  {
    for (std::size_t i = 0; i < block_size; i += long_lanes) {
      hn::StoreU(totals(parts_ + i), Longs(), sums + i);
      hn::StoreU(totals(squares_ + i), Longs(), squares + i);
    }
  }

private:
  using Row = std::uint64_t[long_lanes];

  HWY_INLINE static hn::VFromD<Longs>
  totals(const Row* rows)
  {
    const Longs l;
    hn::VFromD<Longs> sums[long_lanes];
    for (std::size_t k = 0; k < long_lanes; ++k) {
      sums[k] = hn::Load(l, rows[k]);
    }
    for (std::size_t n = long_lanes / 2; n > 0; n /= 2) {
      for (std::size_t k = 0; k < n; ++k) {
        const auto low = sums[2 * k], high = sums[2 * k + 1];
        sums[k] = hn::Add(hn::ConcatEven(l, high, low), hn::ConcatOdd(l, high, low));
      }
    }
    return sums[0];
  }

  HWY_ALIGN Row parts_[block_size];
  HWY_ALIGN Row squares_[block_size];
};

/** \brief The angles between the normals of a block's queries and candidates. */
class BlockAngles {
public:
  BlockAngles(const SweepBlock& block, const OwnPoints& own, const INADSlots& slots)
  : block_(block)
  , own_(own)
  , slots_(slots)
  , stride_(((slots.total() + block_size - 1) / block_size + 1) * block_size)
  , angles_(simdScratch().angles.atLeast(block_size * stride_))
  {}

  void
  find(bool has_ties, bool is_smooth, BlockSums& sums)
  {
    if (has_ties) {
      is_smooth ? find<true, true>(sums) : find<true, false>(sums);
    }
    else {
      is_smooth ? find<false, true>(sums) : find<false, false>(sums);
    }
  }

  /** \brief All less the rejected ones, which are few: sums are exact. Moves angles. */
  BlockSums
  sumKept(const BlockRanges& ranges, const BlockSums& all)
  {
    std::size_t rejected[block_size] = {};
    // One after the other, what is packed would be read before it is there.
    for (std::size_t i = 0; i < block_.size; ++i) {
      rejected[i] =
          packRejected(angles(i), all.count[i], ranges.least[i], ranges.width[i]);
    }
    BlockTotals totals(block_.size);
    for (std::size_t i = 0; i < block_.size; ++i) {
      AngleAdder adder;
      addAngles(angles(i), rejected[i], adder);
      totals.set(i, adder);
    }
    BlockSums kept;
    totals.store(kept.sum, kept.squares);
    for (std::size_t i = 0; i < block_size; ++i) {
      kept.count[i] = all.count[i] - rejected[i];
      kept.sum[i] = all.sum[i] - kept.sum[i];
      kept.squares[i] = all.squares[i] - kept.squares[i];
    }
    return kept;
  }

private:
  /** \brief Of query i: whole vectors, and one more for what ends them. */
  std::uint32_t*
  angles(std::size_t i) const
  {
    return angles_ + i * stride_;
  }

  template <bool with_ties, bool is_smooth>
  void
  find(BlockSums& sums)
  {
    std::fill(sums.count + block_.size, sums.count + block_size, 0);
    BlockTotals totals(block_.size);
    float* const chords = simdScratch().values.atLeast(2 * stride_);
    const auto chordsOf = [&](std::size_t i) { return chords + (i % 2) * stride_; };
    const auto setAngles = [&](std::size_t i) {
      AngleAdder adder;
      chordsToAngles(chordsOf(i), sums.count[i], angles(i), adder);
      totals.set(i, adder);
    };
    // One query late: what was just packed cannot be read before it is in the cache.
    for (std::size_t i = 0; i < block_.size; ++i) {
      sums.count[i] =
          collectChords<with_ties, is_smooth>(block_, own_, i, slots_, chordsOf(i));
      if (i > 0) {
        setAngles(i - 1);
      }
    }
    setAngles(block_.size - 1);
    totals.store(sums.sum, sums.squares);
  }

  const SweepBlock& block_;
  const OwnPoints& own_;
  const INADSlots slots_;
  const std::size_t stride_;
  std::uint32_t* const angles_;
};

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
