/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#if defined(PCL_SHAPE_SIMD_ORDERED_MOMENTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PCL_SHAPE_SIMD_ORDERED_MOMENTS_INL_H_
#undef PCL_SHAPE_SIMD_ORDERED_MOMENTS_INL_H_
#else
#define PCL_SHAPE_SIMD_ORDERED_MOMENTS_INL_H_
#endif

#include "moments.h"
#include "simd_packed_points-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

/** \brief Sums over the neighbors' offsets from each query: first and second moments.
 */
struct alignas(64) OrderedMoments {
  enum Second : std::size_t { xx = sum_z + 1, xy, xz, yy, yz, zz, size };

  float counts[block_size];
  float sums[size][block_size];

  HWY_INLINE
  OrderedMoments()
  {
    const Floats d;
    for (std::size_t i = 0; i < block_size; i += lanes) {
      hn::Store(hn::Zero(d), d, counts + i);
      for (auto& sum : sums) {
        hn::Store(hn::Zero(d), d, sum + i);
      }
    }
  }
};

/** \brief sum += a b and sum += a where the mask is set. */
template <class M, class V>
HWY_INLINE V
mulAddWhere(M mask, V a, V b, V sum)
{
#if HWY_TARGET <= HWY_AVX3
  return V{_mm512_mask3_fmadd_ps(a.raw, b.raw, sum.raw, mask.raw)};
#else
  return hn::MulAdd(hn::IfThenElseZero(mask, a), b, sum);
#endif
}

template <class M, class V>
HWY_INLINE V
addWhere(M mask, V a, V sum)
{
#if HWY_TARGET <= HWY_AVX3
  return V{_mm512_mask_add_ps(sum.raw, mask.raw, sum.raw, a.raw)};
#else
  return hn::Add(sum, hn::IfThenElseZero(mask, a));
#endif
}

/** \brief Adds the moments of a row's points to what is so far summed over that row,
 * for as many queries as there are lanes. */
HWY_NOINLINE void
addPoints(const SweepBlock& block,
          const PackedPoints& points,
          std::size_t first,
          OrderedMoments& layer)
{
  const Floats d;
  const auto qx = hn::LoadU(d, block.qx + first), qy = hn::LoadU(d, block.qy + first),
             qz = hn::LoadU(d, block.qz + first), r2 = hn::LoadU(d, block.r2 + first);
  const auto one = hn::Set(d, 1.0f);
  const auto load = [&](std::size_t m) { return hn::Load(d, layer.sums[m] + first); };
  auto n = hn::Load(d, layer.counts + first);
  auto x = load(sum_x), y = load(sum_y), z = load(sum_z);
  auto xx = load(OrderedMoments::xx), xy = load(OrderedMoments::xy),
       xz = load(OrderedMoments::xz), yy = load(OrderedMoments::yy),
       yz = load(OrderedMoments::yz), zz = load(OrderedMoments::zz);
  for (std::size_t c = 0; c < points.size; ++c) {
    const auto dx = hn::Sub(hn::Set(d, points.x[c]), qx);
    const auto dy = hn::Sub(hn::Set(d, points.y[c]), qy);
    const auto dz = hn::Sub(hn::Set(d, points.z[c]), qz);
    const auto mask = hn::Lt(squaredLength(dx, dy, dz), r2);
    n = addWhere(mask, one, n);
    x = addWhere(mask, dx, x);
    y = addWhere(mask, dy, y);
    z = addWhere(mask, dz, z);
    xx = mulAddWhere(mask, dx, dx, xx);
    xy = mulAddWhere(mask, dx, dy, xy);
    xz = mulAddWhere(mask, dx, dz, xz);
    yy = mulAddWhere(mask, dy, dy, yy);
    yz = mulAddWhere(mask, dy, dz, yz);
    zz = mulAddWhere(mask, dz, dz, zz);
  }
  const auto store = [&](auto v, std::size_t m) {
    hn::Store(v, d, layer.sums[m] + first);
  };
  hn::Store(n, d, layer.counts + first);
  store(x, sum_x), store(y, sum_y), store(z, sum_z);
  store(xx, OrderedMoments::xx), store(xy, OrderedMoments::xy);
  store(xz, OrderedMoments::xz), store(yy, OrderedMoments::yy);
  store(yz, OrderedMoments::yz), store(zz, OrderedMoments::zz);
}

HWY_INLINE void
addLayer(const OrderedMoments& layer, OrderedMoments& all)
{
  const Floats d;
  const auto add = [&](const float* from, float* to) {
    hn::Store(hn::Add(hn::Load(d, to), hn::Load(d, from)), d, to);
  };
  for (std::size_t i = 0; i < block_size; i += lanes) {
    add(layer.counts + i, all.counts + i);
    for (std::size_t m = 0; m < OrderedMoments::size; ++m) {
      add(layer.sums[m] + i, all.sums[m] + i);
    }
  }
}

/** \brief Layer by layer of rows, each by itself, row by row, along x: so that sums of
 * few are added up, and the result does not depend on points that are no neighbors. */
HWY_INLINE void
sumInOrder(const SweepBlock& block, OrderedMoments& all)
{
  constexpr std::size_t portion = 256;
  const NearClusters near(block);
  std::size_t begin = 0;
  for (std::size_t r = 0; r < block.run_count; ++r) {
    const bool is_last = r + 1 == block.run_count;
    if (!is_last && block.runs[r + 1].layer == block.runs[r].layer) {
      continue;
    }
    const std::size_t end = near.endOfRun(r);
    OrderedMoments layer;
    for (; begin < end; begin += std::min(portion, end - begin)) {
      const PackedPoints points =
          packPoints<false>(block, near, begin, std::min(end, begin + portion));
      for (std::size_t first = 0; first < block.size; first += lanes) {
        addPoints(block, points, first, layer);
      }
    }
    addLayer(layer, all);
  }
}

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
