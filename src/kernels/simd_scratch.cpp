/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "simd_scratch.h"

namespace pcl::kernels {

SimdScratch&
simdScratch()
{
  thread_local SimdScratch scratch;
  return scratch;
}

} // namespace pcl::kernels
