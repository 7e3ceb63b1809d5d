/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#if defined(PCL_SHAPE_SIMD_ADD_MOMENTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PCL_SHAPE_SIMD_ADD_MOMENTS_INL_H_
#undef PCL_SHAPE_SIMD_ADD_MOMENTS_INL_H_
#else
#define PCL_SHAPE_SIMD_ADD_MOMENTS_INL_H_
#endif

#include "simd_moments-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

/** 512 halves of products fit in 32 bits. */
constexpr std::size_t candidates_between_widening = 512;

#if HWY_TARGET <= HWY_AVX3

/** \brief sum += value where the mask is set: one instruction, which GCC 12 does not
 * find. */
HWY_INLINE void
addWhere(__mmask16 mask, __m512i& sum, const std::uint32_t* value)
{
  asm("vpaddd %2%{1to16%}, %0, %0%{%1%}" : "+v"(sum) : "Yk"(mask), "m"(*value));
}

/** \brief All moments at once: there are registers enough, if the compiler sees each
 * sum as a variable of its own. */
template <bool with_ties>
HWY_NOINLINE void
addMoments(const QueryLanes<with_ties>& lanes_queries,
           const float* slots,
           const std::uint32_t* offsets,
           std::size_t begin,
           std::size_t end,
           std::size_t first_lane,
           BlockMoments& block)
{
  const QueryLanes<with_ties> queries = lanes_queries;
  const __m512i zero = _mm512_setzero_si512();
  __m512i s0 = zero;
  __m512i s1 = zero;
  __m512i s2 = zero;
  __m512i s3 = zero;
  __m512i s4 = zero;
  __m512i s5 = zero;
  __m512i s6 = zero;
  __m512i s7 = zero;
  __m512i s8 = zero;
  __m512i s9 = zero;
  __m512i s10 = zero;
  __m512i s11 = zero;
  __m512i s12 = zero;
  __m512i s13 = zero;
  __m512i s14 = zero;
  __m512i s15 = zero;
  constexpr std::uint32_t one = 1;
  for (std::size_t c = begin; c < end; ++c) {
    const float* candidate = slots + offsets[c];
    const __mmask16 mask = queries.neighborMask(candidate).raw;
    const auto* value = reinterpret_cast<const std::uint32_t*>(candidate);
    addWhere(mask, s0, value + momentAt(sum_x));
    addWhere(mask, s1, value + momentAt(sum_y));
    addWhere(mask, s2, value + momentAt(sum_z));
    addWhere(mask, s3, value + momentAt(low_xx));
    addWhere(mask, s4, value + momentAt(low_xy));
    addWhere(mask, s5, value + momentAt(low_xz));
    addWhere(mask, s6, value + momentAt(low_yy));
    addWhere(mask, s7, value + momentAt(low_yz));
    addWhere(mask, s8, value + momentAt(low_zz));
    addWhere(mask, s9, value + momentAt(high_xx));
    addWhere(mask, s10, value + momentAt(high_xy));
    addWhere(mask, s11, value + momentAt(high_xz));
    addWhere(mask, s12, value + momentAt(high_yy));
    addWhere(mask, s13, value + momentAt(high_yz));
    addWhere(mask, s14, value + momentAt(high_zz));
    addWhere(mask, s15, &one);
  }
  addLanes(hn::VFromD<Words>{s0}, block.values[sum_x] + first_lane);
  addLanes(hn::VFromD<Words>{s1}, block.values[sum_y] + first_lane);
  addLanes(hn::VFromD<Words>{s2}, block.values[sum_z] + first_lane);
  addLanes(hn::VFromD<Words>{s3}, block.values[low_xx] + first_lane);
  addLanes(hn::VFromD<Words>{s4}, block.values[low_xy] + first_lane);
  addLanes(hn::VFromD<Words>{s5}, block.values[low_xz] + first_lane);
  addLanes(hn::VFromD<Words>{s6}, block.values[low_yy] + first_lane);
  addLanes(hn::VFromD<Words>{s7}, block.values[low_yz] + first_lane);
  addLanes(hn::VFromD<Words>{s8}, block.values[low_zz] + first_lane);
  addLanes(hn::VFromD<Words>{s9}, block.values[high_xx] + first_lane);
  addLanes(hn::VFromD<Words>{s10}, block.values[high_xy] + first_lane);
  addLanes(hn::VFromD<Words>{s11}, block.values[high_xz] + first_lane);
  addLanes(hn::VFromD<Words>{s12}, block.values[high_yy] + first_lane);
  addLanes(hn::VFromD<Words>{s13}, block.values[high_yz] + first_lane);
  addLanes(hn::VFromD<Words>{s14}, block.values[high_zz] + first_lane);
  addLanes(hn::VFromD<Words>{s15}, block.count + first_lane);
}

#else

/** \brief A few moments at a time, from stored masks: registers are few. */
template <std::size_t first, std::size_t count>
HWY_INLINE void
addSomeMoments(const std::uint32_t* masks,
               const float* slots,
               const std::uint32_t* offsets,
               std::size_t size,
               std::size_t first_lane,
               BlockMoments& block)
{
  const Words w;
  hn::VFromD<Words> sums[count];
  for (auto& sum : sums) {
    sum = hn::Zero(w);
  }
  for (std::size_t c = 0; c < size; ++c) {
    const auto mask = hn::Load(w, masks + c * lanes);
    const auto* value = reinterpret_cast<const std::uint32_t*>(slots + offsets[c]);
    HWY_UNROLL(5)
    for (std::size_t m = 0; m < count; ++m) {
      sums[m] = hn::Add(sums[m], hn::And(mask, hn::Set(w, value[momentAt(first + m)])));
    }
  }
  for (std::size_t m = 0; m < count; ++m) {
    addLanes(sums[m], block.values[first + m] + first_lane);
  }
}

template <bool with_ties>
HWY_INLINE void
addMoments(const QueryLanes<with_ties>& queries,
           const float* slots,
           const std::uint32_t* offsets,
           std::size_t begin,
           std::size_t end,
           std::size_t first_lane,
           BlockMoments& block)
{
  const Words w;
  std::uint32_t* masks =
      simdScratch().masks.atLeast(candidates_between_widening * lanes);
  auto counts = hn::Zero(w);
  for (std::size_t c = begin; c < end; ++c) {
    const auto mask =
        hn::VecFromMask(w, hn::RebindMask(w, queries.neighborMask(slots + offsets[c])));
    counts = hn::Sub(counts, mask);
    hn::Store(mask, w, masks + (c - begin) * lanes);
  }
  addLanes(counts, block.count + first_lane);
  static_assert(moment_count == 15, "three parts of five");
  const std::size_t size = end - begin;
  offsets += begin;
  addSomeMoments<0, 5>(masks, slots, offsets, size, first_lane, block);
  addSomeMoments<5, 5>(masks, slots, offsets, size, first_lane, block);
  addSomeMoments<10, 5>(masks, slots, offsets, size, first_lane, block);
}

#endif

template <bool with_ties>
HWY_INLINE void
addPortion(const SweepBlock& block,
           const float* r2,
           const float* tie_d2,
           const CandidateList& candidates,
           BlockMoments& sums)
{
  for (std::size_t lane = 0; lane < block.size; lane += lanes) {
    const QueryLanes<with_ties> queries(block, r2, tie_d2, lane);
    for (std::size_t c = 0; c < candidates.size; c += candidates_between_widening) {
      const std::size_t end =
          std::min(candidates.size, c + candidates_between_widening);
      addMoments(queries, candidates.slots, candidates.offsets, c, end, lane, sums);
    }
  }
}

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
