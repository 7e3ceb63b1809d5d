/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#if defined(PCL_SHAPE_SIMD_SPREAD_OF_ANGLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PCL_SHAPE_SIMD_SPREAD_OF_ANGLES_INL_H_
#undef PCL_SHAPE_SIMD_SPREAD_OF_ANGLES_INL_H_
#else
#define PCL_SHAPE_SIMD_SPREAD_OF_ANGLES_INL_H_
#endif

#include "angle_sums.h"
#include "simd_common-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

/** \brief Sums over the angles of each query of a block, in units (angle.h). */
struct BlockSums {
  std::uint64_t count[block_size];
  std::uint64_t sum[block_size];
  std::uint64_t squares[block_size];
};

/** \brief Means and standard deviations of a block's queries. */
struct BlockSpreads {
  double mean[block_size];
  double sd[block_size];
};

/** \brief Ranges of angles, [least, least + width]. */
struct BlockRanges {
  std::uint32_t least[block_size] = {};
  std::uint32_t width[block_size] = {};
};

/** \brief As BlockSums, of however many angles. */
struct ManySums {
  std::uint64_t count[block_size] = {};
  std::uint64_t sum[block_size] = {};
  Wide squares[block_size] = {};

  void
  add(const BlockSums& part)
  {
    for (std::size_t i = 0; i < block_size; ++i) {
      count[i] += part.count[i];
      sum[i] += part.sum[i];
      squares[i] += part.squares[i];
    }
  }
};

/** \brief From sums over at most most_for_64_bits angles. */
HWY_INLINE void
spreadsOf(const BlockSums& sums, BlockSpreads& spreads)
{
  const Doubles d;
  for (std::size_t i = 0; i < block_size; i += double_lanes) {
    const auto n = hn::Max(hn::Set(d, 1.0), toDoubles(sums.count + i));
    const auto inverse = hn::Div(hn::Set(d, 1.0), n);
    const auto sum = toDoubles(sums.sum + i);
    const auto mean = hn::Div(sum, n);
    // What the squares' 2^47 lose in 53 bits is less than a unit^2.
    const auto variance =
        hn::Mul(hn::Sub(toDoubles(sums.squares + i), hn::Mul(mean, sum)), inverse);
    hn::StoreU(mean, d, spreads.mean + i);
    hn::StoreU(hn::Sqrt(hn::Max(hn::Zero(d), variance)), d, spreads.sd + i);
  }
}

/** \brief As of few angles, if they are few: the same angles give the same result. */
inline void
spreadsOf(const ManySums& sums, BlockSpreads& spreads)
{
  BlockSums few{};
  for (std::size_t i = 0; i < block_size; ++i) {
    if (sums.count[i] <= most_for_64_bits) {
      few.count[i] = sums.count[i];
      few.sum[i] = sums.sum[i];
      few.squares[i] = static_cast<std::uint64_t>(sums.squares[i]);
    }
  }
  spreadsOf(few, spreads);
  for (std::size_t i = 0; i < block_size; ++i) {
    if (sums.count[i] > most_for_64_bits) {
      const Spread spread =
          AngleSums{sums.count[i], sums.sum[i], sums.squares[i]}.spread();
      spreads.mean[i] = spread.mean;
      spreads.sd[i] = spread.sd;
    }
  }
}

/** \brief As keptRange(). */
HWY_INLINE BlockRanges
keptRanges(const BlockSpreads& spreads, double outlier_rate)
{
  BlockRanges ranges;
  const Doubles d;
  const hn::Rebind<std::int32_t, Doubles> ints;
  const auto most = hn::Set(d, std::numeric_limits<std::int32_t>::max());
  for (std::size_t i = 0; i < block_size; i += double_lanes) {
    const auto mean = hn::LoadU(d, spreads.mean + i);
    const auto sd = hn::LoadU(d, spreads.sd + i);
    const auto width = hn::Mul(sd, hn::Set(d, outlier_rate * (1.0 + 1e-5)));
    // The product may be infinite: with no deviation it would not be a number.
    const auto all =
        hn::Or(hn::Eq(sd, hn::Zero(d)), hn::Eq(hn::Set(d, outlier_rate), hn::Zero(d)));
    const auto first = hn::IfThenZeroElse(
        all, hn::Ceil(hn::Min(most, hn::Max(hn::Zero(d), hn::Sub(mean, width)))));
    const auto last =
        hn::IfThenElse(all, most, hn::Floor(hn::Min(most, hn::Add(mean, width))));
    const auto store = [&](auto values, std::uint32_t* to) {
      hn::StoreU(hn::DemoteTo(ints, values), ints, reinterpret_cast<std::int32_t*>(to));
    };
    // Nothing is in an empty range: angles are less than the largest number.
    const auto is_empty = hn::Lt(last, first);
    store(hn::IfThenElse(is_empty, most, first), ranges.least + i);
    store(hn::IfThenZeroElse(is_empty, hn::Sub(last, first)), ranges.width + i);
  }
  return ranges;
}

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
