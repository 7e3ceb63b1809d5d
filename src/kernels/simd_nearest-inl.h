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

#include "simd_nearest_lanes-inl.h"
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

/** \brief Squared distances of a query's candidates below r2, packed and padded with
 * infinity. */
HWY_INLINE std::size_t
collectDistances(const SweepBlock& block,
                 std::size_t i,
                 const PackedPoints& candidates,
                 float* d2)
{
  const Floats d;
  const auto r2 = hn::Set(d, block.r2[i]);
  std::size_t count = 0;
  for (std::size_t c = 0; c < candidates.size; c += lanes) {
    const auto v = squaredDistances(block, i, candidates, c);
    count += packStore(d, v, hn::Lt(v, r2), d2 + count);
  }
  hn::StoreU(hn::Set(d, std::numeric_limits<float>::infinity()), d, d2 + count);
  return count;
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

/** \brief The points up to this squared distance are the query's neighbors. */
HWY_INLINE void
setRadiusTo(SweepBlock& block, std::size_t i, float d2)
{
  block.r2[i] = std::nextafter(d2, std::numeric_limits<float>::infinity());
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

/** \brief The k nearest of one query; false if it has fewer neighbors. */
HWY_INLINE bool
narrow(SweepBlock& block,
       std::size_t i,
       std::size_t k,
       const PackedPoints& candidates,
       float* d2)
{
  const std::size_t count = collectDistances(block, i, candidates, d2);
  if (count < k) {
    block.kth_d2[i] = std::numeric_limits<float>::quiet_NaN();
    return false;
  }
  const Ranked kth = kthSmallest(d2, count, k, block.r2[i]);
  block.kth_d2[i] = kth.value;
  if (kth.not_greater == k) {
    setRadiusTo(block, i, kth.value);
    return true;
  }
  setTieAt(block, i, candidates, kth.value, k - kth.less);
  return true;
}

/** \brief Few nearest: of all queries at once, the smallest distances are kept. */
HWY_INLINE bool
narrowToFew(SweepBlock& block, std::size_t k, const PackedPoints& candidates)
{
  constexpr std::size_t some = 12;
  const KthOfQueries kth = k < some ? keepNearest<some>(block, k, candidates)
                                    : keepNearest<most_kept>(block, k, candidates);
  bool all = true;
  for (std::size_t i = 0; i < block.size; ++i) {
    const float d2 = block.kth_d2[i];
    if (std::isnan(d2)) {
      all = false;
    }
    else if (kth.has_tie[i]) {
      setTieAt(block, i, candidates, d2, k - kth.less[i]);
    }
    else {
      setRadiusTo(block, i, d2);
    }
  }
  return all;
}

/** With more candidates than these, each query's own list of distances is faster. */
constexpr std::size_t most_in_lanes = 256;

inline bool
nearest(SweepBlock& block, std::size_t k)
{
  constexpr std::size_t most_clusters = 256;
  const NearClusters near(block);
  if (near.size() > most_clusters) {
    return portableKernels().nearest(block, k);
  }
  const PackedPoints candidates = packPoints<true>(block, near, 0, near.size());
  if (k < most_kept) {
    return narrowToFew(block, k, candidates);
  }
  const bool in_lanes = candidates.size <= most_in_lanes;
  float* d2 =
      simdScratch().values.atLeast(candidates.size * (in_lanes ? lanes : 1) + lanes);
  if (in_lanes) {
    narrowLanes(block, k, candidates, d2);
  }
  bool all = true;
  for (std::size_t i = 0; i < block.size; ++i) {
    if (in_lanes && !std::isnan(block.kth_d2[i])) {
      setRadiusTo(block, i, block.kth_d2[i]);
    }
    else {
      all = narrow(block, i, k, candidates, d2) && all;
    }
  }
  return all;
}

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
