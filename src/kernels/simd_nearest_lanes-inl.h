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

#include "simd_candidates-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

/** \brief Points one after the other, padded with NaN to a whole vector. */
struct PackedPoints {
  const float *x, *y, *z;
  const std::uint32_t* order;
  std::size_t size;
};

/** \brief The points of the near clusters that are near the queries' box. */
HWY_INLINE PackedPoints
packPoints(const SweepBlock& block, const NearClusters& near)
{
  const Floats d;
  const Words w;
  const std::size_t stride = near.size() * block_size + block_size;
  float* out = simdScratch().slots.atLeast(3 * stride);
  std::uint32_t* order = simdScratch().angles.atLeast(stride);
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
      packStore(w,
                hn::LoadU(w, block.order + first + i),
                hn::RebindMask(w, mask),
                order + size);
      packStore(d, p.x, mask, out + size);
      packStore(d, p.y, mask, out + stride + size);
      size += packStore(d, p.z, mask, out + 2 * stride + size);
    }
  }
  hn::StoreU(hn::Set(d, std::numeric_limits<float>::quiet_NaN()), d, out + size);
  return {out, out + stride, out + 2 * stride, order, size};
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
    // Whole numbers: adding floats takes four times as long.
    const Ints w;
    const auto int_one = hn::Set(w, 1);
    auto count = hn::Zero(w);
    for (std::size_t c = 0; c < size; ++c) {
      const auto is_below =
          hn::RebindMask(w, hn::Lt(hn::Load(d, d2 + c * lanes), bound));
      count = hn::IfThenElse(is_below, hn::Add(count, int_one), count);
    }
    return hn::ConvertTo(d, count);
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
    const auto x = hn::LoadU(d, block.qx + first);
    const auto y = hn::LoadU(d, block.qy + first);
    const auto z = hn::LoadU(d, block.qz + first);
    for (std::size_t c = 0; c < candidates.size; ++c) {
      const auto v = squaredLength(hn::Sub(hn::Set(d, candidates.x[c]), x),
                                   hn::Sub(hn::Set(d, candidates.y[c]), y),
                                   hn::Sub(hn::Set(d, candidates.z[c]), z));
      hn::Store(v, d, d2 + c * lanes);
    }
    const auto r2 = hn::LoadU(d, block.r2 + first);
    hn::StoreU(kthSmallestOfLanes(d2, candidates.size, k, r2), d, block.kth_d2 + first);
  }
}

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
