/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#if defined(PCL_SHAPE_SIMD_INAD_BLOCK_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PCL_SHAPE_SIMD_INAD_BLOCK_INL_H_
#undef PCL_SHAPE_SIMD_INAD_BLOCK_INL_H_
#else
#define PCL_SHAPE_SIMD_INAD_BLOCK_INL_H_
#endif

#include "simd_inad-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

constexpr INADResult unknown_inad{std::numeric_limits<float>::quiet_NaN(),
                                  std::numeric_limits<float>::quiet_NaN()};

/** \brief Turns the queries' normals to the side of the first one that is known, which
 * becomes the packer's reference; cosines[i] is its cosine with query i's.
 */
HWY_INLINE void
turnToReference(const SweepBlock& block,
                OwnPoints& own,
                CandidatePacker& packer,
                float* cosines)
{
  std::size_t first = 0;
  while (first + 1 < block.size && std::isnan(own.nx[first])) {
    ++first;
  }
  const float x = own.nx[first], y = own.ny[first], z = own.nz[first];
  packer.setReference(x, y, z);
  for (std::size_t i = 0; i < block.size; ++i) {
    const float cosine = own.nx[i] * x + own.ny[i] * y + own.nz[i] * z;
    const float side = cosine < 0.0f ? -1.0f : 1.0f;
    own.nx[i] *= side;
    own.ny[i] *= side;
    own.nz[i] *= side;
    cosines[i] = std::abs(cosine);
  }
}

HWY_INLINE std::size_t
collectChords(const SweepBlock& block,
              const OwnPoints& own,
              std::size_t i,
              const CandidatePacker& packer,
              float cosine,
              const Candidates& candidates,
              float* chords,
              bool& spreads)
{
  if (packer.hasTies()) {
    return collectChords<true, false>(block, own, i, candidates, chords, spreads);
  }
  return packer.isSmoothAround(cosine)
             ? collectChords<false, true>(block, own, i, candidates, chords, spreads)
             : collectChords<false, false>(block, own, i, candidates, chords, spreads);
}

/** \brief The candidates of a block fit in one portion: angles are kept for the second
 * pass. */
HWY_INLINE void
inadOfFewCandidates(const SweepBlock& block,
                    const OwnPoints& own,
                    const CandidatePacker& packer,
                    const float* cosines,
                    double outlier_rate,
                    INADResult* results)
{
  SimdScratch& scratch = simdScratch();
  const Candidates& candidates = scratch.candidates;
  const std::size_t stride = candidates.size + lanes;
  float* chords = scratch.values.atLeast(stride);
  std::uint32_t* angles = scratch.angles.atLeast(block_size * stride);
  Sums all[block_size] = {};
  std::size_t lengths[block_size] = {};
  bool spreads[block_size] = {};
  for (std::size_t i = 0; i < block.size; ++i) {
    if (std::isnan(own.nx[i])) {
      continue;
    }
    lengths[i] = collectChords(
        block, own, i, packer, cosines[i], candidates, chords, spreads[i]);
    all[i] = toAngles(chords, lengths[i], angles + i * stride);
    all[i].count -= std::min<std::uint64_t>(all[i].count, own.is_neighbor[i]);
  }
  Spread spread[block_size];
  for (std::size_t i = 0; i < block_size; ++i) {
    const std::uint64_t count = std::max<std::uint64_t>(1, all[i].count);
    spread[i] = spreadOf(count, all[i].sum, all[i].squares);
  }
  for (std::size_t i = 0; i < block.size; ++i) {
    const bool is_known = !std::isnan(own.nx[i]) &&
                          all[i].count >= NeighborhoodSweep::min_neighbors &&
                          (spreads[i] || spansSurface(block, i));
    if (!is_known) {
      results[i] = unknown_inad;
      continue;
    }
    const KeptRange range = keptRange(spread[i], outlier_rate);
    const Sums kept =
        sumKept(angles + i * stride, lengths[i], range, own.is_neighbor[i]);
    results[i] = toINAD(kept.count == 0 ? spread[i]
                                        : spreadOf(kept.count, kept.sum, kept.squares));
  }
}

/** \brief One pass over all portions: sums of the angles in each query's range. */
HWY_INLINE void
sumOverPortions(const SweepBlock& block,
                OwnPoints& own,
                const KeptRange* ranges,
                AngleSums* sums,
                bool* spreads)
{
  SimdScratch& scratch = simdScratch();
  CandidatePacker packer(block, scratch.candidates);
  float cosines[block_size];
  turnToReference(block, own, packer, cosines);
  float* chords = scratch.values.atLeast(portion_size + lanes);
  std::uint32_t* angles = scratch.angles.atLeast(portion_size + lanes);
  while (!packer.isDone()) {
    packer.next<true>();
    for (std::size_t i = 0; i < block.size; ++i) {
      if (std::isnan(own.nx[i])) {
        continue;
      }
      const std::size_t count = collectChords(
          block, own, i, packer, cosines[i], scratch.candidates, chords, spreads[i]);
      toAngles(chords, count, angles);
      const Sums part = sumKept(angles, count, ranges[i], 0);
      sums[i].count += part.count;
      sums[i].sum += part.sum;
      sums[i].squares += part.squares;
    }
  }
  for (std::size_t i = 0; i < block.size; ++i) {
    const bool has_own = own.is_neighbor[i] != 0 && ranges[i].first <= 0;
    sums[i].count -= has_own ? 1 : 0;
  }
}

/** \brief However many candidates: their angles are computed twice instead of kept. */
HWY_INLINE void
inadOfManyCandidates(const SweepBlock& block,
                     OwnPoints& own,
                     double outlier_rate,
                     INADResult* results)
{
  KeptRange ranges[block_size];
  AngleSums all[block_size], kept[block_size];
  bool spreads[block_size] = {};
  sumOverPortions(block, own, ranges, all, spreads);
  for (std::size_t i = 0; i < block.size; ++i) {
    if (all[i].count > 0) {
      ranges[i] = keptRange(all[i].spread(), outlier_rate);
    }
  }
  sumOverPortions(block, own, ranges, kept, spreads);
  for (std::size_t i = 0; i < block.size; ++i) {
    const bool is_known = !std::isnan(own.nx[i]) &&
                          all[i].count >= NeighborhoodSweep::min_neighbors &&
                          (spreads[i] || spansSurface(block, i));
    results[i] = is_known ? toINAD((kept[i].count == 0 ? all[i] : kept[i]).spread())
                          : unknown_inad;
  }
}

inline void
inad(const SweepBlock& block, double outlier_rate, INADResult* results)
{
  OwnPoints own = ownPointsOf(block);
  CandidatePacker packer(block, simdScratch().candidates);
  float cosines[block_size];
  turnToReference(block, own, packer, cosines);
  packer.next<true>();
  if (packer.isDone()) {
    inadOfFewCandidates(block, own, packer, cosines, outlier_rate, results);
  }
  else {
    inadOfManyCandidates(block, own, outlier_rate, results);
  }
}

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
