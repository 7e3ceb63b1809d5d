/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#if defined(PCL_SHAPE_SIMD_QUERY_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PCL_SHAPE_SIMD_QUERY_LANES_INL_H_
#undef PCL_SHAPE_SIMD_QUERY_LANES_INL_H_
#else
#define PCL_SHAPE_SIMD_QUERY_LANES_INL_H_
#endif

#include "simd_slots-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

/** \brief As many queries as there are lanes, and which candidates are their neighbors.
 */
template <bool with_ties>
class QueryLanes {
public:
  HWY_INLINE
  QueryLanes(const SweepBlock& block,
             const float* r2,
             const float* tie_d2,
             std::size_t first)
  : x_(hn::LoadU(Floats(), block.qx + first))
  , y_(hn::LoadU(Floats(), block.qy + first))
  , z_(hn::LoadU(Floats(), block.qz + first))
  , r2_(hn::LoadU(Floats(), r2 + first))
  , tie_d2_(hn::LoadU(Floats(), tie_d2 + first))
  , tie_index_(hn::BitCast(Ints(), hn::LoadU(Words(), block.tie_index + first)))
  {}

  /** \brief Whether the point in a slot is a neighbor. */
  HWY_INLINE MaskOf<Floats>
  neighborMask(const float* candidate) const
  {
    std::uint32_t order = 0;
    if constexpr (with_ties) {
      std::memcpy(&order, candidate + slot_order * block_size, sizeof(order));
    }
    return neighborMask(candidate[slot_x * block_size],
                        candidate[slot_y * block_size],
                        candidate[slot_z * block_size],
                        order);
  }

  /** \brief Whether a point is; `order` counts with ties only. */
  HWY_INLINE MaskOf<Floats>
  neighborMask(float x, float y, float z, std::uint32_t order) const
  {
    const Floats d;
    const auto d2 = squaredLength(hn::Sub(hn::Set(d, x), x_),
                                  hn::Sub(hn::Set(d, y), y_),
                                  hn::Sub(hn::Set(d, z), z_));
    const auto near = hn::Lt(d2, r2_);
    if constexpr (with_ties) {
      const auto index = hn::Set(Ints(), static_cast<std::int32_t>(order));
      const auto first = hn::RebindMask(d, hn::Not(hn::Gt(index, tie_index_)));
      return hn::Or(near, hn::And(hn::Eq(d2, tie_d2_), first));
    }
    else {
      return near;
    }
  }

private:
  hn::VFromD<Floats> x_, y_, z_, r2_, tie_d2_;
  hn::VFromD<Ints> tie_index_;
};

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
