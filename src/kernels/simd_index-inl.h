/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#if defined(PCL_SHAPE_SIMD_INDEX_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PCL_SHAPE_SIMD_INDEX_INL_H_
#undef PCL_SHAPE_SIMD_INDEX_INL_H_
#else
#define PCL_SHAPE_SIMD_INDEX_INL_H_
#endif

#include "row_index.h"
#include "simd_common-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

/** \brief As cellOf(), of whole vectors. */
inline void
cells(const float* coordinates,
      std::size_t count,
      double cells_a_metre,
      std::int32_t* out)
{
  const Doubles d;
  const hn::Rebind<float, Doubles> floats;
  const hn::Rebind<std::int32_t, Doubles> ints;
  const auto scale = hn::Set(d, cells_a_metre);
  const auto most = hn::Set(d, most_cell), least = hn::Set(d, -most_cell);
  for (std::size_t i = 0; i < count; i += double_lanes) {
    const auto at = hn::PromoteTo(d, hn::LoadU(floats, coordinates + i));
    const auto cell = hn::Min(most, hn::Max(least, hn::Mul(at, scale)));
    hn::StoreU(hn::DemoteTo(ints, hn::Floor(cell)), ints, out + i);
  }
}

inline std::uint32_t
countLess(const float* values, std::size_t count, float bound)
{
  const Floats d;
  std::size_t less = 0;
  for (std::size_t i = 0; i < block_size; i += lanes) {
    const auto is_less = hn::Lt(hn::LoadU(d, values + i), hn::Set(d, bound));
    const auto counts = hn::FirstN(d, count > i ? count - i : 0);
    less += hn::CountTrue(d, hn::And(is_less, counts));
  }
  return static_cast<std::uint32_t>(less);
}

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
