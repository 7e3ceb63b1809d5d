/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#if defined(PCL_SHAPE_SIMD_SELECT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PCL_SHAPE_SIMD_SELECT_INL_H_
#undef PCL_SHAPE_SIMD_SELECT_INL_H_
#else
#define PCL_SHAPE_SIMD_SELECT_INL_H_
#endif

#include "simd_common-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

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

/** \brief A value, and how many of a list are less, and not greater. */
struct Ranked {
  float value;
  std::size_t less, not_greater;
};

/** \brief The n-th smallest of a few values, padded with infinity: the one of that
 * rank. Sorting would take a branch for each comparison. */
HWY_INLINE Ranked
nthOfFew(const float* values, std::size_t count, std::size_t n)
{
  const Floats d;
  Ranked found{values[0], 0, 0};
  for (std::size_t i = 0; i < count; ++i) {
    const auto value = hn::Set(d, values[i]);
    std::size_t less = 0, not_greater = 0;
    for (std::size_t c = 0; c < count; c += lanes) {
      const auto others = hn::LoadU(d, values + c);
      less += hn::CountTrue(d, hn::Lt(others, value));
      not_greater += hn::CountTrue(d, hn::Le(others, value));
    }
    const bool is_nth = less < n && n <= not_greater;
    found = is_nth ? Ranked{values[i], less, not_greater} : found;
  }
  return found;
}

/** \brief The same of however many. Moves them. */
inline Ranked
nthOfMany(float* values, std::size_t count, std::size_t n)
{
  float* nth = values + (n - 1);
  std::nth_element(values, nth, values + count);
  const auto is_less = [nth](float v) { return v < *nth; };
  return {*nth,
          static_cast<std::size_t>(std::count_if(values, nth, is_less)),
          n + static_cast<std::size_t>(std::count(nth + 1, values + count, *nth))};
}

/** \brief The k-th smallest of squared distances in [low, high), k at most their
 * number. Moves them.
 *
 * On a surface the number of points within d grows like d^2: interpolating between
 * bounds finds the k-th in a few counts; halving between them, now and then, bounds
 * their number.
 */
HWY_INLINE Ranked
kthSmallest(float* d2, std::size_t count, std::size_t k, float low, float high)
{
  const Floats d;
  std::size_t below_low = 0, below_high = count;
  constexpr std::size_t few = 16;
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
  hn::StoreU(hn::Set(d, std::numeric_limits<float>::infinity()), d, d2 + kept);
  Ranked kth = kept <= few ? nthOfFew(d2, kept, k - below_low)
                           : nthOfMany(d2, kept, k - below_low);
  kth.less += below_low;
  kth.not_greater += below_low;
  return kth;
}

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
