/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#if defined(PCL_SHAPE_SIMD_SLOTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PCL_SHAPE_SIMD_SLOTS_INL_H_
#undef PCL_SHAPE_SIMD_SLOTS_INL_H_
#else
#define PCL_SHAPE_SIMD_SLOTS_INL_H_
#endif

#include "simd_candidates-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

/** \brief Arrays of block_size values at the front of every slot; a kernel's own
 * follow.
 */
enum SlotArray : std::size_t { slot_x, slot_y, slot_z, slot_order, slot_common };

/** \brief A slot of a kernel with some arrays of its own. Candidates are known by their
 * offset from the first slot. */
template <std::size_t own_arrays>
constexpr std::size_t slot_stride = (slot_common + own_arrays) * block_size;

/** \brief Copies points into a slot. */
template <bool with_order>
HWY_INLINE Points
stagePoints(const SweepBlock& block, std::size_t position, float* slot)
{
  const Floats d;
  const Words w;
  const Points points{hn::LoadU(d, block.x + position),
                      hn::LoadU(d, block.y + position),
                      hn::LoadU(d, block.z + position)};
  hn::Store(points.x, d, slot + slot_x * block_size);
  hn::Store(points.y, d, slot + slot_y * block_size);
  hn::Store(points.z, d, slot + slot_z * block_size);
  if constexpr (with_order) {
    hn::Store(hn::LoadU(w, block.order + position),
              w,
              reinterpret_cast<std::uint32_t*>(slot + slot_order * block_size));
  }
  return points;
}

/** \brief Candidates, as offsets of lanes of slots. */
struct CandidateList {
  const float* slots;
  const std::uint32_t* offsets;
  std::size_t size;
};

/** \brief Fills slots of this stride with some of the near clusters: fill(points,
 * slot lanes) copies a kernel's own arrays. */
template <std::size_t stride, bool with_order, typename Fill>
HWY_INLINE CandidateList
stageClusters(const SweepBlock& block,
              const NearClusters& near,
              std::size_t begin,
              std::size_t count,
              const Fill& fill)
{
  float* slots = simdScratch().slots.atLeast(count * stride);
  CandidateLister lister(near, block.box, count);
  for (std::size_t s = 0; s < count; ++s) {
    const std::uint32_t cluster = near.begin()[begin + s];
    const std::uint32_t first = block.cluster_begin[cluster];
    const std::uint32_t size = block.cluster_begin[cluster + 1] - first;
    for (std::size_t i = 0; i < size; i += lanes) {
      const std::size_t offset = s * stride + i;
      const Points points = stagePoints<with_order>(block, first + i, slots + offset);
      fill(points, slots + offset, pointsOfCluster(size, i), offset, lister);
    }
  }
  return {slots, lister.numbers(), lister.size()};
}

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
