// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

// No include guard: included once for each target.

#undef PCL_SHAPE_SIMD_TARGET
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_SSE4 ||      \
    HWY_TARGET == HWY_NEON
#define PCL_SHAPE_SIMD_TARGET 1
#else
#define PCL_SHAPE_SIMD_TARGET 0
#endif
