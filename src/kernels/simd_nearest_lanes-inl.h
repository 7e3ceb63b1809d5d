/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#if defined(PCL_SHAPE_SIMD_NEAREST_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PCL_SHAPE_SIMD_NEAREST_LANES_INL_H_
#undef PCL_SHAPE_SIMD_NEAREST_LANES_INL_H_
#else
#define PCL_SHAPE_SIMD_NEAREST_LANES_INL_H_
#endif

#include "simd_few_nearest-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

/** \brief One more where the mask is set. Whole numbers: adding floats takes four times
 * as long. */
template <class M>
HWY_INLINE hn::VFromD<Ints>
countWhere(M mask, hn::VFromD<Ints> count)
{
  const Ints w;
#if HWY_TARGET <= HWY_AVX3
  return hn::VFromD<Ints>{
      _mm512_mask_add_epi32(count.raw, mask.raw, count.raw, hn::Set(w, 1).raw)};
#else
  // A mask's lanes are -1.
  return hn::Sub(count, hn::VecFromMask(w, hn::RebindMask(w, mask)));
#endif
}

/** \brief The k-th smallest squared distances of as many queries as there are lanes, by
 * closing in on all at once.
 *
 * On a surface the number of points within d grows like d^2: interpolating between
 * bounds finds the k-th in a few counts; halving between them, now and then, bounds
 * their number. NaN where bounds cannot part the k-th from others: equal distances.
 */
HWY_INLINE hn::VFromD<Floats>
kthSmallestOfLanes(const float* d2,
                   std::size_t size,
                   std::size_t k,
                   hn::VFromD<Floats> most)
{
  const Floats d;
  const auto one = hn::Set(d, 1.0f);
  const auto countBelow = [&](auto bound) {
    auto even = hn::Zero(Ints()), odd = even;
    std::size_t c = 0;
    for (; c + 1 < size; c += 2) {
      even = countWhere(hn::Lt(hn::Load(d, d2 + c * lanes), bound), even);
      odd = countWhere(hn::Lt(hn::Load(d, d2 + (c + 1) * lanes), bound), odd);
    }
    if (c < size) {
      even = countWhere(hn::Lt(hn::Load(d, d2 + c * lanes), bound), even);
    }
    return hn::ConvertTo(d, hn::Add(even, odd));
  };
  const auto wanted = hn::Set(d, static_cast<float>(k));
  auto low = hn::Zero(d), high = most;
  auto below_low = hn::Zero(d), below_high = countBelow(high);
  const auto has_enough = hn::Ge(below_high, wanted);
  constexpr int most_steps = 24;
  for (int step = 0; step < most_steps; ++step) {
    const auto open = hn::Gt(hn::Sub(below_high, below_low), one);
    if (hn::AllFalse(d, hn::And(open, has_enough))) {
      break;
    }
    const auto share =
        step % 4 == 3 ? hn::Set(d, 0.5f)
                      : hn::Div(hn::Sub(hn::Sub(wanted, below_low), hn::Set(d, 0.5f)),
                                hn::Sub(below_high, below_low));
    const auto middle = hn::MulAdd(share, hn::Sub(high, low), low);
    const auto below = countBelow(middle);
    const auto is_high = hn::And(open, hn::Ge(below, wanted));
    const auto is_low = hn::AndNot(is_high, open);
    high = hn::IfThenElse(is_high, middle, high);
    below_high = hn::IfThenElse(is_high, below, below_high);
    low = hn::IfThenElse(is_low, middle, low);
    below_low = hn::IfThenElse(is_low, below, below_low);
  }
  auto kth = most;
  for (std::size_t c = 0; c < size; ++c) {
    const auto v = hn::Load(d, d2 + c * lanes);
    kth = hn::IfThenElse(hn::And(hn::Ge(v, low), hn::Lt(v, kth)), v, kth);
  }
  const auto is_alone = hn::Eq(hn::Sub(below_high, below_low), one);
  const auto is_kth = hn::And(is_alone, hn::Eq(below_high, wanted));
  return hn::IfThenElse(hn::And(has_enough, is_kth),
                        kth,
                        hn::Set(d, std::numeric_limits<float>::quiet_NaN()));
}

/** \brief The k nearest of all queries; those found get their kth_d2, the others NaN.
 */
HWY_INLINE void
narrowLanes(SweepBlock& block, std::size_t k, const PackedPoints& candidates, float* d2)
{
  const Floats d;
  for (std::size_t first = 0; first < block.size; first += lanes) {
    const LanesOfQueries queries(block, first);
    for (std::size_t c = 0; c < candidates.size; ++c) {
      hn::Store(queries.squaredDistances(candidates, c), d, d2 + c * lanes);
    }
    const auto r2 = hn::LoadU(d, block.r2 + first);
    hn::StoreU(kthSmallestOfLanes(d2, candidates.size, k, r2), d, block.kth_d2 + first);
  }
}

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
