/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#if defined(PCL_SHAPE_SIMD_CANDIDATES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PCL_SHAPE_SIMD_CANDIDATES_INL_H_
#undef PCL_SHAPE_SIMD_CANDIDATES_INL_H_
#else
#define PCL_SHAPE_SIMD_CANDIDATES_INL_H_
#endif

#include "simd_near_clusters-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

/** \brief A vector of points. */
struct Points {
  hn::VFromD<Floats> x, y, z;
};

/** \brief Lists points that may be a neighbor of a query of the block. */
class CandidateLister {
public:
  CandidateLister(const NearClusters& near, const Box& box, std::size_t clusters)
  : distances_(box)
  , reach2_(hn::Set(Floats(), near.reach2()))
  {
    numbers_ = simdScratch().offsets.atLeast(clusters * block_size + lanes);
  }

  /** \brief Those near enough to the queries' box, among lanes that count; the first
   * one is known by this number. */
  HWY_INLINE void
  add(const Points& points, MaskOf<Floats> counts, std::size_t number)
  {
    const Words w;
    const auto squares = distances_.of(points.x, points.y, points.z);
    const auto mask = hn::And(hn::Lt(squares.least2, reach2_), counts);
    size_ += packStore(w,
                       numbersFrom(static_cast<std::uint32_t>(number)),
                       hn::RebindMask(w, mask),
                       numbers_ + size_);
  }

  const std::uint32_t*
  numbers() const
  {
    return numbers_;
  }

  std::size_t
  size() const
  {
    return size_;
  }

private:
  BoxDistances distances_;
  hn::VFromD<Floats> reach2_;
  std::uint32_t* numbers_;
  std::size_t size_ = 0;
};

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
