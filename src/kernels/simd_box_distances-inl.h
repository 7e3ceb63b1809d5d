/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#if defined(PCL_SHAPE_SIMD_BOX_DISTANCES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PCL_SHAPE_SIMD_BOX_DISTANCES_INL_H_
#undef PCL_SHAPE_SIMD_BOX_DISTANCES_INL_H_
#else
#define PCL_SHAPE_SIMD_BOX_DISTANCES_INL_H_
#endif

#include "simd_common-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

/** \brief How far points are from a box. */
class BoxDistances {
public:
  /** \brief Squared distances to the nearest and to the furthest point of the box. */
  struct Squares {
    hn::VFromD<Floats> least2, most2;
  };

  HWY_INLINE explicit BoxDistances(const Box& box)
  : x_min_(hn::Set(Floats(), box.x_min))
  , x_max_(hn::Set(Floats(), box.x_max))
  , y_min_(hn::Set(Floats(), box.y_min))
  , y_max_(hn::Set(Floats(), box.y_max))
  , z_min_(hn::Set(Floats(), box.z_min))
  , z_max_(hn::Set(Floats(), box.z_max))
  {}

  HWY_INLINE Squares
  of(hn::VFromD<Floats> x, hn::VFromD<Floats> y, hn::VFromD<Floats> z) const
  {
    const Floats d;
    const auto outside = [&](auto low, auto high) {
      return hn::Max(hn::Max(low, high), hn::Zero(d));
    };
    const auto x_low = hn::Sub(x_min_, x), x_high = hn::Sub(x, x_max_);
    const auto y_low = hn::Sub(y_min_, y), y_high = hn::Sub(y, y_max_);
    const auto z_low = hn::Sub(z_min_, z), z_high = hn::Sub(z, z_max_);
    return {roughSquaredLength(
                outside(x_low, x_high), outside(y_low, y_high), outside(z_low, z_high)),
            roughSquaredLength(hn::Min(x_low, x_high),
                               hn::Min(y_low, y_high),
                               hn::Min(z_low, z_high))};
  }

private:
  hn::VFromD<Floats> x_min_, x_max_, y_min_, y_max_, z_min_, z_max_;
};

/** \brief How far the boxes of clusters are from a box. */
class BoxToBoxes {
public:
  /** \param[in] sides least x, y, z, most x, y, z of the clusters */
  HWY_INLINE
  BoxToBoxes(const Box& box, const float* const* sides)
  : least_{hn::Set(Floats(), box.x_min),
           hn::Set(Floats(), box.y_min),
           hn::Set(Floats(), box.z_min)}
  , most_{hn::Set(Floats(), box.x_max),
          hn::Set(Floats(), box.y_max),
          hn::Set(Floats(), box.z_max)}
  {
    std::copy_n(sides, std::size(sides_), sides_);
  }

  /** \brief Of a vector of clusters from this one on. */
  HWY_INLINE hn::VFromD<Floats>
  squaredDistances(std::uint32_t first) const
  {
    const Floats d;
    const auto apart = [&](std::size_t axis) {
      const auto low = hn::LoadU(d, sides_[axis] + first);
      const auto high = hn::LoadU(d, sides_[axis + 3] + first);
      return hn::Max(hn::Max(hn::Sub(least_[axis], high), hn::Sub(low, most_[axis])),
                     hn::Zero(d));
    };
    return roughSquaredLength(apart(0), apart(1), apart(2));
  }

private:
  hn::VFromD<Floats> least_[3], most_[3];
  const float* sides_[6];
};

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
