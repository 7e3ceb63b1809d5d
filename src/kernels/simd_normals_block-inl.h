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

#include "neighborhood.h"
#include "simd_add_moments-inl.h"
#include "simd_covariance-inl.h"
#include "simd_eigen-inl.h"
#include "simd_ordered_normals-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

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

/** \brief Squared, what follows from the neighbors alone: of k nearest points, r2 is
 * above the k-th's unless another one is as far. */
HWY_INLINE float
reach2Of(const SweepBlock& block, std::size_t i)
{
  return block.kth_d2[i] > 0.0f ? block.kth_d2[i] : block.r2[i];
}

/** \brief From exact sums: in whatever order. */
HWY_NOINLINE void
exactNormals(const SweepBlock& block, NormalResult* results)
{
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  int levels[block_size];
  bool done[block_size] = {};
  for (std::size_t i = 0; i < block.size; ++i) {
    const bool is_as_before = i > 0 && reach2Of(block, i) == reach2Of(block, i - 1);
    levels[i] = is_as_before ? levels[i - 1] : levelOf(reach2Of(block, i));
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

inline void
normals(const SweepBlock& block, NormalResult* results)
{
  bool is_known[block_size];
  if (!suitsFloat(block)) {
    exactNormals(block, results);
  }
  else if (!orderedNormals(block, results, is_known)) {
    NormalResult exact[block_size];
    exactNormals(block, exact);
    for (std::size_t i = 0; i < block.size; ++i) {
      results[i] = is_known[i] ? results[i] : exact[i];
    }
  }
}

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
