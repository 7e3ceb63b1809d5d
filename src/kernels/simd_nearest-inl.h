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

#include "simd_few_nearest-inl.h"
#include "simd_narrow-inl.h"

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

/** \brief Few nearest: of all queries at once, the smallest distances are kept. */
HWY_INLINE bool
narrowToFew(SweepBlock& block, std::size_t k, const PackedPoints& candidates)
{
  constexpr std::size_t some = 11;
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

inline bool
nearest(SweepBlock& block, std::size_t k)
{
  const NearClusters near(block);
  if (near.size() > most_clusters) {
    return portableKernels().nearest(block, k);
  }
  const PackedPoints candidates = packPoints<true>(block, near, 0, near.size());
  if (k < most_kept) {
    return narrowToFew(block, k, candidates);
  }
  float* d2 = simdScratch().values.atLeast(candidates.size + lanes);
  bool all = true;
  for (std::size_t i = 0; i < block.size; ++i) {
    if (i == 0 || !narrowNear(block, i, k, candidates, block.kth_d2[i - 1], d2)) {
      all = narrow(block, i, k, candidates, d2) && all;
    }
  }
  return all;
}

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
