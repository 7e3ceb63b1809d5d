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

#include "simd_slots-inl.h"

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

template <bool with_ties>
HWY_INLINE void
addCounts(const SweepBlock& block,
          const CandidatePositions& candidates,
          std::uint32_t* counts)
{
  const Words w;
  const auto one = hn::Set(w, 1);
  for (std::size_t first = 0; first < block_size; first += lanes) {
    const QueryLanes<with_ties> queries(block, block.r2, block.tie_d2, first);
    auto count = hn::LoadU(w, counts + first);
    for (std::size_t c = 0; c < candidates.size; ++c) {
      const auto mask =
          hn::RebindMask(w, queries.neighborMask(block, candidates.begin[c]));
      count = hn::IfThenElse(mask, hn::Add(count, one), count);
    }
    hn::StoreU(count, w, counts + first);
  }
}

inline void
count(const SweepBlock& block, std::uint32_t* results)
{
  constexpr std::size_t portion = 256;
  const NearClusters near(block);
  std::uint32_t counts[block_size] = {};
  for (std::size_t begin = 0; begin < near.size(); begin += portion) {
    const std::size_t size = std::min(portion, near.size() - begin);
    const CandidatePositions candidates = listPositions(
        block,
        near,
        begin,
        size,
        false,
        [](const Points& points,
           auto is_point,
           std::uint32_t position,
           CandidateLister& lister) { lister.add(points, is_point, position); });
    near.hasTies() ? addCounts<true>(block, candidates, counts)
                   : addCounts<false>(block, candidates, counts);
  }
  for (std::size_t i = 0; i < block.size; ++i) {
    const bool has_own = block.queries_on_surface || isAtSurfacePoint(block, i);
    results[i] = counts[i] - (counts[i] > 0 && has_own ? 1 : 0);
  }
}

/** \brief Points one after the other, padded with NaN to a whole vector. */
struct PackedPoints {
  const float *x, *y, *z;
  std::size_t size;
};

/** \brief The points of the near clusters that are near the queries' box. */
HWY_INLINE PackedPoints
packPoints(const SweepBlock& block, const NearClusters& near)
{
  const Floats d;
  const std::size_t stride = near.size() * block_size + block_size;
  float* out = simdScratch().slots.atLeast(3 * stride);
  CandidateLister lister(near, block.box, near.size(), false);
  std::size_t size = 0;
  for (std::size_t s = 0; s < near.size(); ++s) {
    const std::uint32_t cluster = near.begin()[s];
    const std::uint32_t first = block.cluster_begin[cluster];
    const std::uint32_t points = block.cluster_begin[cluster + 1] - first;
    for (std::size_t i = 0; i < points; i += lanes) {
      const Points p{hn::LoadU(d, block.x + first + i),
                     hn::LoadU(d, block.y + first + i),
                     hn::LoadU(d, block.z + first + i)};
      const auto mask = lister.add(p, pointsOfCluster(points, i), 0);
      packStore(d, p.x, mask, out + size);
      packStore(d, p.y, mask, out + stride + size);
      size += packStore(d, p.z, mask, out + 2 * stride + size);
    }
  }
  hn::StoreU(hn::Set(d, std::numeric_limits<float>::quiet_NaN()), d, out + size);
  return {out, out + stride, out + 2 * stride, size};
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

/** \brief Squared distances of a query's candidates below r2, packed and padded with
 * infinity. */
HWY_INLINE std::size_t
collectDistances(const SweepBlock& block,
                 std::size_t i,
                 const PackedPoints& candidates,
                 float* d2)
{
  const Floats d;
  const auto qx = hn::Set(d, block.qx[i]);
  const auto qy = hn::Set(d, block.qy[i]);
  const auto qz = hn::Set(d, block.qz[i]);
  const auto r2 = hn::Set(d, block.r2[i]);
  std::size_t count = 0;
  for (std::size_t c = 0; c < candidates.size; c += lanes) {
    const auto v = squaredLength(hn::Sub(hn::Load(d, candidates.x + c), qx),
                                 hn::Sub(hn::Load(d, candidates.y + c), qy),
                                 hn::Sub(hn::Load(d, candidates.z + c), qz));
    count += packStore(d, v, hn::Lt(v, r2), d2 + count);
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
       const PackedPoints& candidates,
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
  constexpr std::size_t most_clusters = 256;
  const NearClusters near(block);
  if (near.size() > most_clusters) {
    return portableKernels().nearest(block, k);
  }
  const PackedPoints candidates = packPoints(block, near);
  float* d2 = simdScratch().values.atLeast(candidates.size + lanes);
  bool all = true;
  for (std::size_t i = 0; i < block.size; ++i) {
    all = narrow(block, i, k, candidates, d2) && all;
  }
  return all;
}

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
