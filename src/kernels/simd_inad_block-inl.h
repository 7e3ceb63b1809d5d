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

#include "neighborhood.h"
#include "simd_block_angles-inl.h"
#include "simd_spreads-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

constexpr INADResult unknown_inad{std::numeric_limits<float>::quiet_NaN(),
                                  std::numeric_limits<float>::quiet_NaN()};

/** \brief The INAD of one block. */
class BlockINAD {
public:
  BlockINAD(const SweepBlock& block, double outlier_rate)
  : block_(block)
  , own_(ownPointsOf(block))
  , near_(block)
  , candidates_(block, own_, near_)
  , outlier_rate_(outlier_rate)
  {
    if (block.queries_on_surface) {
      findSpreadsAmongQueries(block, spreads_);
    }
  }

  void
  compute(INADResult* results)
  {
    near_.size() <= most_clusters ? sumOnePortion() : sumManyPortions();
    for (std::size_t i = 0; i < block_.size; ++i) {
      const BlockSpreads& spreads = kept_count_[i] != 0 ? kept_ : all_;
      results[i] = isKnown(i) ? toINAD({spreads.mean[i], spreads.sd[i]}) : unknown_inad;
    }
  }

private:
  void
  find(BlockAngles& angles, BlockSums& sums) const
  {
    angles.find(near_.hasTies(), candidates_.isSmooth(), sums);
  }

  /** \brief Angles are there for the second pass. */
  void
  sumOnePortion()
  {
    const INADSlots slots = candidates_.list(0, near_.size());
    BlockAngles angles(block_, own_, slots);
    BlockSums found;
    find(angles, found);
    BlockSums all = found;
    const BlockRanges ranges = setAll(all);
    findMissingSpreads(slots);
    BlockSums kept = angles.sumKept(ranges, found);
    setKept(ranges, kept);
  }

  /** \brief However many candidates: their angles are computed twice. */
  void
  sumManyPortions()
  {
    ManySums all, kept;
    forEachPortion([&](BlockAngles angles) {
      BlockSums part;
      find(angles, part);
      all.add(part);
    });
    const BlockRanges ranges = setAll(all);
    forEachPortion([&](BlockAngles angles) {
      BlockSums found;
      find(angles, found);
      kept.add(angles.sumKept(ranges, found));
    });
    setKept(ranges, kept);
  }

  template <typename Visit>
  void
  forEachPortion(const Visit& visit)
  {
    for (std::size_t begin = 0; begin < near_.size(); begin += most_clusters) {
      const std::size_t count = std::min(most_clusters, near_.size() - begin);
      const INADSlots slots = candidates_.list(begin, count);
      visit(BlockAngles(block_, own_, slots));
    }
  }

  /** \brief From the sums over all angles. \return the ranges that follow from them */
  template <typename Sums>
  BlockRanges
  setAll(Sums& sums)
  {
    leaveOutOwn({}, sums.count);
    std::copy_n(sums.count, block_size, count_);
    spreadsOf(sums, all_);
    return keptRanges(all_, outlier_rate_);
  }

  template <typename Sums>
  void
  setKept(const BlockRanges& ranges, Sums& sums)
  {
    leaveOutOwn(ranges, sums.count);
    std::copy_n(sums.count, block_size, kept_count_);
    spreadsOf(sums, kept_);
  }

  /** \brief Own points, whose angle is 0, are in ranges that begin there. */
  void
  leaveOutOwn(const BlockRanges& ranges, std::uint64_t* count) const
  {
    for (std::size_t i = 0; i < block_size; ++i) {
      const std::uint64_t own = ranges.least[i] == 0 ? own_.is_neighbor[i] : 0;
      count[i] -= std::min(count[i], own);
    }
  }

  /** \brief Mostly, a few of the candidates tell. */
  void
  findMissingSpreads(const INADSlots& slots)
  {
    constexpr std::size_t some = 8, all = 1;
    for (const std::size_t step : {some, all}) {
      if (!knowsSpreads()) {
        findSpreads(block_, slots, step, spreads_);
      }
    }
  }

  bool
  knowsSpreads() const
  {
    bool all = true;
    for (std::size_t i = 0; i < block_.size; ++i) {
      all = all && (spreads_[i] || !hasNeighbors(i));
    }
    return all;
  }

  bool
  hasNeighbors(std::size_t i) const
  {
    return !std::isnan(own_.nx[i]) && count_[i] >= NeighborhoodSweep::min_neighbors;
  }

  bool
  isKnown(std::size_t i) const
  {
    return hasNeighbors(i) && (spreads_[i] || spansSurface(block_, i));
  }

  const SweepBlock& block_;
  const OwnPoints own_;
  const NearClusters near_;
  INADCandidates candidates_;
  double outlier_rate_;
  bool spreads_[block_size] = {};
  std::uint64_t count_[block_size], kept_count_[block_size];
  BlockSpreads all_, kept_;
};

inline void
inad(const SweepBlock& block, double outlier_rate, INADResult* results)
{
  BlockINAD(block, outlier_rate).compute(results);
}

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
