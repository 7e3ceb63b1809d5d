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

/** \brief As many values as two vectors have are ranked by comparing all with all. */
constexpr std::size_t few_values = 2 * lanes;

/** \brief The n-th smallest of the values of some vectors: the largest of those that
 * fewer than n are less than. Without branches: none could be predicted. */
template <std::size_t vectors>
HWY_INLINE Ranked
nthOfVectors(const float* values, std::size_t n)
{
  const Floats d;
  hn::VFromD<Floats> v[vectors];
  hn::VFromD<Ints> less[vectors];
  for (std::size_t u = 0; u < vectors; ++u) {
    v[u] = hn::LoadU(d, values + u * lanes);
    less[u] = hn::Zero(Ints());
  }
  for (std::size_t i = 0; i < vectors * lanes; ++i) {
    const auto value = hn::Set(d, values[i]);
    for (std::size_t u = 0; u < vectors; ++u) {
      less[u] = countWhere(hn::Gt(v[u], value), less[u]);
    }
  }
  const auto rank = hn::Set(Ints(), static_cast<std::int32_t>(n));
  auto largest = hn::Zero(d);
  for (std::size_t u = 0; u < vectors; ++u) {
    const auto is_small = hn::RebindMask(d, hn::Lt(less[u], rank));
    largest = hn::Max(largest, hn::IfThenElseZero(is_small, v[u]));
  }
  const auto nth = hn::MaxOfLanes(d, largest);
  Ranked found{hn::GetLane(nth), 0, 0};
  for (std::size_t u = 0; u < vectors; ++u) {
    found.less += hn::CountTrue(d, hn::Lt(v[u], nth));
    found.not_greater += hn::CountTrue(d, hn::Le(v[u], nth));
  }
  return found;
}

/** \brief The n-th smallest of at most few_values values, none negative, which a vector
 * of infinity follows. */
HWY_INLINE Ranked
nthOfFew(const float* values, std::size_t count, std::size_t n)
{
  return count <= lanes ? nthOfVectors<1>(values, n) : nthOfVectors<2>(values, n);
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

/** \brief Packs the distances in [low, high), in place, and pads them with infinity.
 * \return how many they are */
HWY_INLINE std::size_t
keepInside(float* d2, std::size_t count, float low, float high)
{
  const Floats d;
  std::size_t kept = 0;
  for (std::size_t c = 0; c < count; c += lanes) {
    const auto v = hn::LoadU(d, d2 + c);
    const auto inside =
        hn::AndNot(hn::Lt(v, hn::Set(d, low)), hn::Lt(v, hn::Set(d, high)));
    kept += packStore(d, v, inside, d2 + kept);
  }
  hn::StoreU(hn::Set(d, std::numeric_limits<float>::infinity()), d, d2 + kept);
  return kept;
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
  std::size_t below_low = 0, below_high = count;
  for (int step = 0; below_high - below_low > few_values; ++step) {
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
  const std::size_t kept =
      below_high - below_low < count ? keepInside(d2, count, low, high) : count;
  Ranked kth = kept <= few_values ? nthOfFew(d2, kept, k - below_low)
                                  : nthOfMany(d2, kept, k - below_low);
  kth.less += below_low;
  kth.not_greater += below_low;
  return kth;
}

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
