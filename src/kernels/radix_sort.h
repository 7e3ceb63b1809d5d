/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::kernels {

/** \brief Keys and what they belong to, sorted together. */
struct KeyedIndices {
  std::vector<std::uint64_t> keys;
  std::vector<std::uint32_t> indices;
};

/** \brief Stable sort by the lowest `bits` bits of the keys. The result does not depend
 * on the number of threads. */
void radixSort(KeyedIndices& entries, int bits, unsigned threads);

} // namespace pcl::kernels
