/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#if defined(PCL_SHAPE_SIMD_NORMALS_BLOCK_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PCL_SHAPE_SIMD_NORMALS_BLOCK_INL_H_
#undef PCL_SHAPE_SIMD_NORMALS_BLOCK_INL_H_
#else
#define PCL_SHAPE_SIMD_NORMALS_BLOCK_INL_H_
#endif

#include "simd_covariance-inl.h"
#include "simd_eigen-inl.h"
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

/** \brief Queries of a block whose moments are taken about one origin. */
struct Group {
  double has[block_size] = {}; ///< 1 or 0
  int level = 0;
};

/** \brief The origin in units: below all neighbors of the group. Returns the largest
 * coordinate of a neighbor of any query, absolute, in units. */
HWY_INLINE double
setOrigin(const SweepBlock& block, const Group& group, BlockMoments& sums)
{
  const Doubles d;
  const auto scale = hn::Set(d, std::ldexp(1.0, offset_bits - group.level));
  const float* coordinates[] = {block.qx, block.qy, block.qz};
  const hn::Rebind<float, Doubles> floats;
  auto largest = hn::Zero(d);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    auto least = hn::Set(d, std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < block_size; i += double_lanes) {
      const auto q = hn::PromoteTo(d, hn::LoadU(floats, coordinates[axis] + i));
      const auto units = hn::Round(hn::Mul(q, scale));
      hn::Store(units, d, sums.own[axis] + i);
      const auto has = hn::Gt(hn::LoadU(d, group.has + i), hn::Zero(d));
      const auto is_query = hn::FirstN(d, block.size > i ? block.size - i : 0);
      least = hn::Min(least, hn::IfThenElse(has, units, least));
      largest = hn::Max(largest, hn::IfThenElseZero(is_query, hn::Abs(units)));
    }
    constexpr double below = (1 << offset_bits) + 2;
    sums.origin[axis] = hn::GetLane(hn::MinOfLanes(d, least)) - below;
    for (std::size_t i = 0; i < block_size; i += double_lanes) {
      const auto own = hn::Load(d, sums.own[axis] + i);
      hn::Store(hn::Sub(own, hn::Set(d, sums.origin[axis])), d, sums.own[axis] + i);
    }
  }
  constexpr double reach = 1 << (offset_bits + 1);
  return hn::GetLane(hn::MaxOfLanes(d, largest)) + reach;
}

HWY_INLINE BlockMoments
sumMoments(const SweepBlock& block, const NearClusters& near, const Group& group)
{
  BlockMoments sums{};
  const double largest = setOrigin(block, group, sums);
  const Quantizer quantizer(group.level, sums.origin, largest);
  float r2[block_size], tie_d2[block_size];
  for (std::size_t i = 0; i < block_size; ++i) {
    const bool has = group.has[i] != 0.0;
    r2[i] = has ? block.r2[i] : -1.0f;
    tie_d2[i] = has ? block.tie_d2[i] : -1.0f;
  }
  const auto fill = [&](const Points& points,
                        std::size_t,
                        float* slot,
                        auto is_point,
                        std::size_t offset,
                        CandidateLister& lister) {
    stageMoments(quantizer, points, slot);
    lister.add(points, is_point, offset);
  };
  constexpr std::size_t portion = 256;
  for (std::size_t begin = 0; begin < near.size(); begin += portion) {
    const std::size_t size = std::min(portion, near.size() - begin);
    near.hasTies()
        ? addPortion<true>(
              block,
              r2,
              tie_d2,
              stageClusters<moments_stride, true>(block, near, begin, size, fill),
              sums)
        : addPortion<false>(
              block,
              r2,
              tie_d2,
              stageClusters<moments_stride, false>(block, near, begin, size, fill),
              sums);
  }
  return sums;
}

/** \brief The group of query i: those of its level, if all of them fit around one
 * origin, else i alone. The sums are exact: which, makes no difference to them. */
HWY_INLINE Group
groupOf(const SweepBlock& block, const int* levels, std::size_t query)
{
  Group group;
  group.level = levels[query];
  const double scale = std::ldexp(1.0, offset_bits - group.level);
  for (std::size_t i = 0; i < block.size; ++i) {
    group.has[i] = levels[i] == group.level ? 1.0 : 0.0;
  }
  for (const float* coordinates : {block.qx, block.qy, block.qz}) {
    double least = coordinates[query], most = coordinates[query];
    for (std::size_t i = 0; i < block.size; ++i) {
      if (group.has[i] != 0.0) {
        least = std::min<double>(least, coordinates[i]);
        most = std::max<double>(most, coordinates[i]);
      }
    }
    constexpr double most_units = (1 << (offset_bits + 1)) - 16;
    if (!((most - least) * scale <= most_units)) {
      group = {};
      group.level = levels[query];
      group.has[query] = 1.0;
      break;
    }
  }
  return group;
}

/** Units are a fraction of the radius: neighbors that are all within a hundredth of it
 * are too few units apart, and are left to the portable kernel. */
constexpr double least_trace = 1 << 26;

inline void
normals(const SweepBlock& block, NormalResult* results)
{
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  int levels[block_size];
  bool done[block_size] = {};
  for (std::size_t i = 0; i < block.size; ++i) {
    levels[i] = levelOf(std::max(block.r2[i], block.tie_d2[i]));
  }
  const NearClusters near(block);
  const bool on_surface = block.queries_on_surface;
  for (std::size_t first = 0; first < block.size; ++first) {
    if (done[first]) {
      continue;
    }
    const Group group = groupOf(block, levels, first);
    const BlockMoments sums = sumMoments(block, near, group);
    BlockCovariances covariances;
    NormalResult normals[block_size];
    centerMoments(sums, covariances);
    normalsOfCovariances(covariances, block.size, normals);
    for (std::size_t i = 0; i < block.size; ++i) {
      if (group.has[i] == 0.0) {
        continue;
      }
      done[i] = true;
      const std::size_t own =
          on_surface || (sums.count[i] > 0 && isAtSurfacePoint(block, i)) ? 1 : 0;
      if (sums.count[i] < NeighborhoodSweep::min_neighbors + own) {
        results[i] = {nan, nan, nan, nan};
        continue;
      }
      const double trace = covariances.xx[i] + covariances.yy[i] + covariances.zz[i];
      results[i] = trace < least_trace ? normalAt(block, i) : normals[i];
    }
  }
}

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
