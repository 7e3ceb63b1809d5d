/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#if defined(PCL_SHAPE_SIMD_FEW_NEAREST_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PCL_SHAPE_SIMD_FEW_NEAREST_INL_H_
#undef PCL_SHAPE_SIMD_FEW_NEAREST_INL_H_
#else
#define PCL_SHAPE_SIMD_FEW_NEAREST_INL_H_
#endif

#include "simd_packed_points-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

/** \brief As many queries as there are lanes. */
struct LanesOfQueries {
  hn::VFromD<Floats> x, y, z;

  HWY_INLINE
  LanesOfQueries(const SweepBlock& block, std::size_t first)
  : x(hn::LoadU(Floats(), block.qx + first))
  , y(hn::LoadU(Floats(), block.qy + first))
  , z(hn::LoadU(Floats(), block.qz + first))
  {}

  HWY_INLINE hn::VFromD<Floats>
  squaredDistances(const PackedPoints& candidates, std::size_t c) const
  {
    const Floats d;
    return squaredLength(hn::Sub(hn::Set(d, candidates.x[c]), x),
                         hn::Sub(hn::Set(d, candidates.y[c]), y),
                         hn::Sub(hn::Set(d, candidates.z[c]), z));
  }
};

/** \brief The smallest values so far, of as many queries as there are lanes, sorted. */
template <std::size_t size>
class SmallestOfLanes {
public:
  // A constructor that the compiler makes would not have the target's instructions.
  HWY_INLINE
  SmallestOfLanes()
  : least_(hn::Set(Floats(), std::numeric_limits<float>::infinity()))
  , others_()
  {}

  HWY_INLINE void
  insert(hn::VFromD<Floats> value)
  {
    others_.insert(hn::Max(least_, value));
    least_ = hn::Min(least_, value);
  }

  /** \param[out] values the least of each lane, the second of each, ... */
  HWY_INLINE void
  store(float* values) const
  {
    hn::StoreU(least_, Floats(), values);
    others_.store(values + lanes);
  }

private:
  hn::VFromD<Floats> least_;
  SmallestOfLanes<size - 1> others_;
};

template <>
class SmallestOfLanes<0> {
public:
  HWY_INLINE void
  insert(hn::VFromD<Floats>)
  {}

  HWY_INLINE void
  store(float*) const
  {}
};

/** As many and more, and keeping the smallest takes longer than counting. */
constexpr std::size_t most_kept = 16;

/** \brief What is known of the k-th nearest points besides kth_d2. */
struct KthOfQueries {
  bool has_tie[block_size];     ///< whether the next one is as far
  std::size_t less[block_size]; ///< with a tie: how many are nearer
};

/** \brief The k nearest of all queries; kth_d2 is NaN if a query has fewer than k
 * neighbors.
 * \tparam kept more than k */
template <std::size_t kept>
HWY_NOINLINE KthOfQueries
keepNearest(SweepBlock& block, std::size_t k, const PackedPoints& candidates)
{
  KthOfQueries kth;
  for (std::size_t first = 0; first < block.size; first += lanes) {
    const LanesOfQueries queries(block, first);
    SmallestOfLanes<kept> smallest;
    for (std::size_t c = 0; c < candidates.size; ++c) {
      smallest.insert(queries.squaredDistances(candidates, c));
    }
    HWY_ALIGN float values[kept * lanes];
    smallest.store(values);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const auto at = [&](std::size_t n) { return values[n * lanes + lane]; };
      const std::size_t i = first + lane;
      const bool has_enough = at(k - 1) < block.r2[i];
      block.kth_d2[i] =
          has_enough ? at(k - 1) : std::numeric_limits<float>::quiet_NaN();
      kth.has_tie[i] = has_enough && at(k) == at(k - 1);
      kth.less[i] = k - 1;
      while (kth.has_tie[i] && kth.less[i] > 0 && at(kth.less[i] - 1) == at(k - 1)) {
        --kth.less[i];
      }
    }
  }
  return kth;
}

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
