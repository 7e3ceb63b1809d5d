// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What all SIMD kernels are made of: vector types, packing, distances.

// No include guard: candidates-inl.h includes it once for each target.

#include "sweep/simd/simd_scratch.h"
#include "sweep/sweep_block.h"

#include <hwy/highway.h>

#include <algorithm>
#include <cstring>
#include <iterator>

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, block_size>;
using Words = hn::RebindToUnsigned<Floats>;
using Ints = hn::RebindToSigned<Floats>;
using Longs = hn::RepartitionToWide<Words>;
using Doubles = hn::CappedTag<double, block_size>;

/** \brief Highway 1.0.3 has no name for it on ARM. */
template <class D>
using MaskOf = decltype(hn::Eq(hn::Zero(D()), hn::Zero(D())));

constexpr std::size_t lanes =
    HWY_LANES(float) < block_size ? HWY_LANES(float) : block_size;
constexpr std::size_t double_lanes =
    HWY_LANES(double) < block_size ? HWY_LANES(double) : block_size;

/** Highway 1.0.3's Compress copies its table at each call on some targets. */
template <class D, class V, class M>
HWY_INLINE std::size_t
packStore(D d, V v, M mask, hn::TFromD<D>* out)
{
#if HWY_TARGET <= HWY_AVX3
  hn::StoreU(hn::Compress(v, mask), d, out);
  return hn::CountTrue(d, mask);
#else
  std::uint8_t bytes[8];
  hn::StoreMaskBits(d, mask, bytes);
  const std::uint32_t bits = bytes[0];
  const std::uint32_t* table =
      lanes == 8 ? compress_lanes_8.rows[bits] : compress_lanes_4.rows[bits & 15];
  hn::StoreU(hn::TableLookupLanes(v, hn::SetTableIndices(d, table)), d, out);
  return hn::CountTrue(d, mask);
#endif
}

/** \brief first, first + 1, ... Highway's Iota may pass them through memory, which then
 * waits for each of them. */
HWY_INLINE hn::VFromD<Words>
numbersFrom(std::uint32_t first)
{
  alignas(64) static constexpr std::uint32_t numbers[] = {
      0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
  static_assert(std::size(numbers) == block_size);
  return hn::Add(hn::Load(Words(), numbers), hn::Set(Words(), first));
}

/** Highway's NearestInt also takes care of values that do not fit. */
template <class V>
HWY_INLINE hn::VFromD<Ints>
nearestInt(V v)
{
#if HWY_TARGET == HWY_AVX3
  return hn::VFromD<Ints>{_mm512_cvtps_epi32(v.raw)};
#elif HWY_TARGET == HWY_AVX2
  return hn::VFromD<Ints>{_mm256_cvtps_epi32(v.raw)};
#elif HWY_TARGET == HWY_SSE4
  return hn::VFromD<Ints>{_mm_cvtps_epi32(v.raw)};
#else
  return hn::NearestInt(v);
#endif
}

/** d^2 as the neighbor rule has it: this file is compiled without fusing. */
template <class V>
HWY_INLINE V
squaredLength(V x, V y, V z)
{
  return hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z));
}

/** \brief The same but for the rounding: for bounds with a margin. */
template <class V>
HWY_INLINE V
roughSquaredLength(V x, V y, V z)
{
  return hn::MulAdd(x, x, hn::MulAdd(y, y, hn::Mul(z, z)));
}

/** \brief Whole numbers below 2^63 as doubles. */
HWY_INLINE hn::VFromD<Doubles>
toDoubles(const std::uint64_t* values)
{
  const hn::RebindToSigned<Doubles> i;
  return hn::ConvertTo(Doubles(),
                       hn::LoadU(i, reinterpret_cast<const std::int64_t*>(values)));
}

/** \brief Adds each lane to its total. */
HWY_INLINE void
addLanes(hn::VFromD<Words> sums, std::uint64_t* totals)
{
  HWY_ALIGN std::uint32_t parts[lanes];
  hn::Store(sums, Words(), parts);
  for (std::size_t lane = 0; lane < lanes; ++lane)
    totals[lane] += parts[lane];
}

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
