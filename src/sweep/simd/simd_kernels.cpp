// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

// The order of these lines matters.
// clang-format off
#include "sweep/portable/targets.h"

#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sweep/simd/simd_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

// The static target of a generic build has no SIMD: the portable kernels serve there.
#include "sweep/simd/simd_target.h"
#if PCL_SHAPE_SIMD_TARGET
#include "sweep/simd/count-inl.h"
#include "sweep/simd/inad-inl.h"
#include "sweep/simd/nearest-inl.h"
#include "sweep/simd/normals-inl.h"
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
  if (name == "avx3")
    return &N_AVX3::kernelTable();
#endif
#if HWY_TARGETS & HWY_AVX2
  if (name == "avx2")
    return &N_AVX2::kernelTable();
#endif
#if HWY_TARGETS & HWY_SSE4
  if (name == "sse4")
    return &N_SSE4::kernelTable();
#endif
#if HWY_TARGETS & HWY_NEON
  if (name == "neon")
    return &N_NEON::kernelTable();
#endif
  return nullptr;
}

} // namespace pcl::kernels
#endif
