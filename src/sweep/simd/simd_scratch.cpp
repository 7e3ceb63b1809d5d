// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Buffers and tables that the SIMD kernels of all targets share.

#include "sweep/simd/simd_scratch.h"

#include <initializer_list>

namespace pcl::kernels {
namespace {

/** \brief The lanes of set bits, then the others. */
template <std::size_t lanes>
constexpr CompressLanes<lanes>
compressLanes()
{
  CompressLanes<lanes> table{};
  for (std::size_t bits = 0; bits < std::size_t{1} << lanes; ++bits) {
    std::size_t place = 0;
    for (const bool is_set : {true, false})
      for (std::size_t lane = 0; lane < lanes; ++lane)
        if (((bits >> lane & 1) != 0) == is_set)
          table.rows[bits][place++] = static_cast<std::uint32_t>(lane);
  }
  return table;
}

} // namespace

const CompressLanes<4> compress_lanes_4 = compressLanes<4>();
const CompressLanes<8> compress_lanes_8 = compressLanes<8>();

SimdScratch&
simdScratch()
{
  thread_local SimdScratch scratch;
  return scratch;
}

} // namespace pcl::kernels
