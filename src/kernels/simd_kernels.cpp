/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

// The order of these lines matters.
// clang-format off
#include "targets.h"

#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "simd_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

// The static target of a generic build has no SIMD: the portable kernels serve there.
#include "simd_target.h"
#if PCL_SHAPE_SIMD_TARGET
#include "simd_index-inl.h"
#include "simd_count-inl.h"
#include "simd_inad_block-inl.h"
#include "simd_nearest-inl.h"
#include "simd_normals_block-inl.h"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

const KernelTable&
kernelTable()
{
  static const KernelTable table{normals, inad, count, nearest, cells, countLess};
  return table;
}

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if HWY_ONCE
namespace pcl::kernels {

const KernelTable*
simdKernels(const std::string& name)
{
#if HWY_TARGETS & HWY_AVX3
  if (name == "avx3") {
    return &N_AVX3::kernelTable();
  }
#endif
#if HWY_TARGETS & HWY_AVX2
  if (name == "avx2") {
    return &N_AVX2::kernelTable();
  }
#endif
#if HWY_TARGETS & HWY_SSE4
  if (name == "sse4") {
    return &N_SSE4::kernelTable();
  }
#endif
#if HWY_TARGETS & HWY_NEON
  if (name == "neon") {
    return &N_NEON::kernelTable();
  }
#endif
  return nullptr;
}

} // namespace pcl::kernels
#endif
