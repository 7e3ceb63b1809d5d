// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Compiles the SIMD kernels for each target of Highway.

// The order of these lines matters.
// clang-format off
#include "sweep/portable/targets.h"

#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sweep/simd/simd_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

// The static target of a generic build has no SIMD: the portable kernels serve there.
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_SSE4 || \
    HWY_TARGET == HWY_NEON
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

std::vector<Target>
simdTargets()
{
  std::vector<Target> targets;
  const auto add = [&](std::int64_t bit, const char* name, auto kernels) {
    if ((hwy::SupportedTargets() & bit) != 0)
      targets.push_back({name, &kernels()});
  };
#if HWY_TARGETS & HWY_AVX3
  add(HWY_AVX3, "avx3", N_AVX3::kernelTable);
#endif
#if HWY_TARGETS & HWY_AVX2
  add(HWY_AVX2, "avx2", N_AVX2::kernelTable);
#endif
#if HWY_TARGETS & HWY_SSE4
  add(HWY_SSE4, "sse4", N_SSE4::kernelTable);
#endif
#if HWY_TARGETS & HWY_NEON
  add(HWY_NEON, "neon", N_NEON::kernelTable);
#endif
  return targets;
}

} // namespace pcl::kernels
#endif
