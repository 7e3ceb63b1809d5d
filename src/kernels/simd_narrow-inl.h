/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#if defined(PCL_SHAPE_SIMD_NARROW_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PCL_SHAPE_SIMD_NARROW_INL_H_
#undef PCL_SHAPE_SIMD_NARROW_INL_H_
#else
#define PCL_SHAPE_SIMD_NARROW_INL_H_
#endif

#include "simd_packed_points-inl.h"
#include "simd_select-inl.h"

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

/** \brief Squared distances of a query to candidates from c on. */
HWY_INLINE hn::VFromD<Floats>
squaredDistances(const SweepBlock& block,
                 std::size_t i,
                 const PackedPoints& candidates,
                 std::size_t c)
{
  const Floats d;
  return squaredLength(
      hn::Sub(hn::LoadU(d, candidates.x + c), hn::Set(d, block.qx[i])),
      hn::Sub(hn::LoadU(d, candidates.y + c), hn::Set(d, block.qy[i])),
      hn::Sub(hn::LoadU(d, candidates.z + c), hn::Set(d, block.qz[i])));
}

/** \brief How many values are below a range, and how many in it. */
struct Ring {
  std::size_t below, inside;
};

/** \brief Squared distances of a query's candidates in [low, high), packed and padded
 * with infinity. */
HWY_INLINE Ring
collectRing(const SweepBlock& block,
            std::size_t i,
            const PackedPoints& candidates,
            float low,
            float high,
            float* d2)
{
  const Floats d;
  const auto least = hn::Set(d, low), most = hn::Set(d, high);
  Ring ring{0, 0};
  for (std::size_t c = 0; c < candidates.size; c += lanes) {
    const auto v = squaredDistances(block, i, candidates, c);
    const auto is_below = hn::Lt(v, least);
    const auto is_inside = hn::AndNot(is_below, hn::Lt(v, most));
    ring.below += hn::CountTrue(d, is_below);
    ring.inside += packStore(d, v, is_inside, d2 + ring.inside);
  }
  hn::StoreU(hn::Set(d, std::numeric_limits<float>::infinity()), d, d2 + ring.inside);
  return ring;
}

/** \brief Of the candidates at this squared distance, the index of the n-th in order.
 */
HWY_INLINE std::uint32_t
nthIndexAt(const SweepBlock& block,
           std::size_t i,
           const PackedPoints& candidates,
           float d2,
           std::size_t n)
{
  const Floats d;
  const Words w;
  std::uint32_t* indices = simdScratch().masks.atLeast(candidates.size + lanes);
  std::size_t count = 0;
  for (std::size_t c = 0; c < candidates.size; c += lanes) {
    const auto equal =
        hn::Eq(squaredDistances(block, i, candidates, c), hn::Set(d, d2));
    count += packStore(w,
                       hn::LoadU(w, candidates.order + c),
                       hn::RebindMask(w, equal),
                       indices + count);
  }
  std::nth_element(indices, indices + (n - 1), indices + count);
  return indices[n - 1];
}

/** \brief The next larger float of one that is not negative and finite. */
HWY_INLINE float
nextLarger(float value)
{
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof(bits));
  ++bits;
  std::memcpy(&value, &bits, sizeof(bits));
  return value;
}

/** \brief The points up to this squared distance are the query's neighbors. */
HWY_INLINE void
setRadiusTo(SweepBlock& block, std::size_t i, float d2)
{
  block.r2[i] = nextLarger(d2);
}

/** \brief Of the points at this squared distance, which is the k-th, those of the
 * smallest indices are neighbors, too. */
HWY_INLINE void
setTieAt(SweepBlock& block,
         std::size_t i,
         const PackedPoints& candidates,
         float d2,
         std::size_t wanted)
{
  block.r2[i] = block.tie_d2[i] = d2;
  block.tie_index[i] = nthIndexAt(block, i, candidates, d2, wanted);
}

/** \brief Sets a query's neighbors to the k nearest candidates. */
HWY_INLINE void
setNearest(SweepBlock& block,
           std::size_t i,
           std::size_t k,
           const PackedPoints& candidates,
           const Ranked& kth)
{
  block.kth_d2[i] = kth.value;
  if (kth.not_greater == k) {
    setRadiusTo(block, i, kth.value);
  }
  else {
    setTieAt(block, i, candidates, kth.value, k - kth.less);
  }
}

/** \brief The k nearest of one query, if its k-th is about as far as that of a query
 * close by, k at least 16; most distances then need not be kept.
 *
 * The number of points within a distance varies by sqrt(k) where they are random, by
 * less where they are regular; the k-th squared distance varies likewise, by
 * 1 / sqrt(k) of itself. 1.2 times that, on both sides, seldom misses the k-th. If the
 * distance close by is unknown (NaN), nothing is in the ring. */
HWY_INLINE bool
narrowNear(SweepBlock& block,
           std::size_t i,
           std::size_t k,
           const PackedPoints& candidates,
           float kth_nearby,
           float* d2)
{
  const float width = 1.2f / std::sqrt(static_cast<float>(k));
  const float low = kth_nearby * (1.0f - width);
  const float wide = kth_nearby * (1.0f + width);
  const float high = wide > block.r2[i] ? block.r2[i] : wide;
  const Ring ring = collectRing(block, i, candidates, low, high, d2);
  if (k <= ring.below || k > ring.below + ring.inside) {
    return false;
  }
  Ranked kth = kthSmallest(d2, ring.inside, k - ring.below, low, high);
  kth.less += ring.below;
  kth.not_greater += ring.below;
  setNearest(block, i, k, candidates, kth);
  return true;
}

/** \brief The k nearest of one query; false if it has fewer neighbors. */
HWY_INLINE bool
narrow(SweepBlock& block,
       std::size_t i,
       std::size_t k,
       const PackedPoints& candidates,
       float* d2)
{
  const std::size_t count =
      collectRing(block, i, candidates, 0.0f, block.r2[i], d2).inside;
  if (count < k) {
    block.kth_d2[i] = std::numeric_limits<float>::quiet_NaN();
    return false;
  }
  setNearest(block, i, k, candidates, kthSmallest(d2, count, k, 0.0f, block.r2[i]));
  return true;
}

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
