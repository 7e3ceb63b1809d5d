/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#if defined(PCL_SHAPE_SIMD_NEAREST_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PCL_SHAPE_SIMD_NEAREST_INL_H_
#undef PCL_SHAPE_SIMD_NEAREST_INL_H_
#else
#define PCL_SHAPE_SIMD_NEAREST_INL_H_
#endif

#include "simd_candidates-inl.h"

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

HWY_INLINE auto
squaredDistances(const SweepBlock& block,
                 std::size_t i,
                 const Candidates& candidates,
                 std::size_t c)
{
  const Floats d;
  const auto dx = hn::Sub(hn::LoadU(d, candidates.x() + c), hn::Set(d, block.qx[i]));
  const auto dy = hn::Sub(hn::LoadU(d, candidates.y() + c), hn::Set(d, block.qy[i]));
  const auto dz = hn::Sub(hn::LoadU(d, candidates.z() + c), hn::Set(d, block.qz[i]));
  return squaredLength(dx, dy, dz);
}

inline void
count(const SweepBlock& block, std::uint32_t* results)
{
  const Floats d;
  Candidates& candidates = simdScratch().candidates;
  CandidatePacker packer(block, candidates);
  std::fill_n(results, block.size, 0);
  while (!packer.isDone()) {
    packer.next<false>();
    for (std::size_t i = 0; i < block.size; ++i) {
      for (std::size_t c = 0; c < candidates.size; c += lanes) {
        const auto d2 = squaredDistances(block, i, candidates, c);
        const auto mask = packer.hasTies()
                              ? neighborMask<true>(block, i, candidates, c, d2)
                              : neighborMask<false>(block, i, candidates, c, d2);
        results[i] += static_cast<std::uint32_t>(hn::CountTrue(d, mask));
      }
    }
  }
  for (std::size_t i = 0; i < block.size; ++i) {
    const bool has_own = block.queries_on_surface || isAtSurfacePoint(block, i);
    results[i] -= results[i] > 0 && has_own ? 1 : 0;
  }
}

/** \brief How many of the distances are below a bound. The padding is infinite. */
HWY_INLINE std::size_t
countBelow(const float* d2, std::size_t count, float bound)
{
  const Floats d;
  std::size_t below = 0;
  for (std::size_t c = 0; c < count; c += lanes) {
    below += hn::CountTrue(d, hn::Lt(hn::LoadU(d, d2 + c), hn::Set(d, bound)));
  }
  return below;
}

/** \brief Distances of a query's candidates below r2, packed and padded with infinity.
 */
HWY_INLINE std::size_t
collectDistances(const SweepBlock& block,
                 std::size_t i,
                 const Candidates& candidates,
                 float* d2)
{
  const Floats d;
  std::size_t count = 0;
  for (std::size_t c = 0; c < candidates.size; c += lanes) {
    const auto v = squaredDistances(block, i, candidates, c);
    count += packStore(d, v, hn::Lt(v, hn::Set(d, block.r2[i])), d2 + count);
  }
  hn::StoreU(hn::Set(d, std::numeric_limits<float>::infinity()), d, d2 + count);
  return count;
}

/** \brief The k-th smallest of the distances, k at most their number, and how many are
 * not greater. Moves the distances.
 *
 * On a surface the number of points within d grows like d^2: interpolating between
 * bounds finds the k-th in a few counts; halving between them, now and then, bounds
 * their number.
 */
HWY_INLINE float
kthSmallest(
    float* d2, std::size_t count, std::size_t k, float most, std::size_t& not_greater)
{
  const Floats d;
  float low = 0.0f, high = most;
  std::size_t below_low = 0, below_high = count;
  constexpr std::size_t few = 32;
  for (int step = 0; below_high - below_low > few; ++step) {
    const double share = step % 4 == 3
                             ? 0.5
                             : (static_cast<double>(k - below_low) - 0.5) /
                                   static_cast<double>(below_high - below_low);
    const auto middle =
        static_cast<float>(low + share * (static_cast<double>(high) - low));
    if (!(middle > low && middle < high)) {
      break;
    }
    const std::size_t below = countBelow(d2, count, middle);
    (below >= k ? high : low) = middle;
    (below >= k ? below_high : below_low) = below;
  }
  std::size_t kept = 0;
  for (std::size_t c = 0; c < count; c += lanes) {
    const auto v = hn::LoadU(d, d2 + c);
    const auto inside =
        hn::AndNot(hn::Lt(v, hn::Set(d, low)), hn::Lt(v, hn::Set(d, high)));
    kept += packStore(d, v, inside, d2 + kept);
  }
  float* kth = d2 + (k - below_low - 1);
  std::nth_element(d2, kth, d2 + kept);
  not_greater = k + static_cast<std::size_t>(std::count(kth + 1, d2 + kept, *kth));
  return *kth;
}

/** \brief The k nearest of one query; false if it has fewer neighbors. */
HWY_INLINE bool
narrow(SweepBlock& block,
       std::size_t i,
       std::size_t k,
       const Candidates& candidates,
       float* d2)
{
  const std::size_t count = collectDistances(block, i, candidates, d2);
  if (count < k) {
    block.kth_d2[i] = std::numeric_limits<float>::quiet_NaN();
    return false;
  }
  std::size_t before = 0;
  const float kth = kthSmallest(d2, count, k, block.r2[i], before);
  const float next = std::nextafter(kth, std::numeric_limits<float>::infinity());
  if (before != k) {
    return narrowToNearest(block, i, k);
  }
  block.kth_d2[i] = kth;
  block.r2[i] = next;
  return true;
}

inline bool
nearest(SweepBlock& block, std::size_t k)
{
  SimdScratch& scratch = simdScratch();
  CandidatePacker packer(block, scratch.candidates);
  packer.next<false>();
  if (!packer.isDone()) {
    return portableKernels().nearest(block, k);
  }
  float* d2 = scratch.values.atLeast(scratch.candidates.size + lanes);
  bool all = true;
  for (std::size_t i = 0; i < block.size; ++i) {
    all = narrow(block, i, k, scratch.candidates, d2) && all;
  }
  return all;
}

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
