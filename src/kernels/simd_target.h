/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

// No include guard: included once for each target.

#undef PCL_SHAPE_SIMD_TARGET
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_SSE4 ||      \
    HWY_TARGET == HWY_NEON
#define PCL_SHAPE_SIMD_TARGET 1
#else
#define PCL_SHAPE_SIMD_TARGET 0
#endif
