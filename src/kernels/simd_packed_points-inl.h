/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#if defined(PCL_SHAPE_SIMD_PACKED_POINTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PCL_SHAPE_SIMD_PACKED_POINTS_INL_H_
#undef PCL_SHAPE_SIMD_PACKED_POINTS_INL_H_
#else
#define PCL_SHAPE_SIMD_PACKED_POINTS_INL_H_
#endif

#include "simd_near_clusters-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

/** \brief Points one after the other; x is padded with NaN to a whole vector. */
struct PackedPoints {
  const float *x, *y, *z;
  const std::uint32_t* order; ///< if asked for
  std::size_t size;
};

/** \brief The points near enough to the queries' box, of some of the near clusters. */
template <bool with_order>
HWY_NOINLINE PackedPoints
packPoints(const SweepBlock& block,
           const NearClusters& near,
           std::size_t begin,
           std::size_t end)
{
  const Floats d;
  const Words w;
  // Local: what is written might be one of these.
  const float *x = block.x, *y = block.y, *z = block.z;
  const std::uint32_t *cluster_begin = block.cluster_begin, *order = block.order;
  const std::uint32_t* clusters = near.begin();
  const std::size_t most = (end - begin) * block_size + lanes;
  float* out = simdScratch().slots.atLeast(3 * most);
  std::uint32_t* out_order = with_order ? simdScratch().angles.atLeast(most) : nullptr;
  const BoxDistances distances(block.box);
  const auto reach2 = hn::Set(d, near.reach2());
  std::size_t size = 0;
  for (std::size_t c = begin; c < end; ++c) {
    const std::uint32_t first = cluster_begin[clusters[c]];
    const std::uint32_t points = cluster_begin[clusters[c] + 1] - first;
    for (std::uint32_t i = 0; i < points; i += lanes) {
      const std::uint32_t j = first + i;
      const auto px = hn::LoadU(d, x + j), py = hn::LoadU(d, y + j),
                 pz = hn::LoadU(d, z + j);
      const auto mask = hn::And(pointsOfCluster(points, i),
                                hn::Lt(distances.of(px, py, pz).least2, reach2));
      if constexpr (with_order) {
        packStore(
            w, hn::LoadU(w, order + j), hn::RebindMask(w, mask), out_order + size);
      }
      packStore(d, px, mask, out + size);
      packStore(d, py, mask, out + most + size);
      size += packStore(d, pz, mask, out + 2 * most + size);
    }
  }
  hn::StoreU(hn::Set(d, std::numeric_limits<float>::quiet_NaN()), d, out + size);
  return {out, out + most, out + 2 * most, out_order, size};
}

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
