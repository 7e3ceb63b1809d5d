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
#include "simd_inad_lanes-inl.h"
#include "simd_spreads-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

constexpr INADResult unknown_inad{std::numeric_limits<float>::quiet_NaN(),
                                  std::numeric_limits<float>::quiet_NaN()};

/** Clusters are looked at in portions of this many, so that buffers stay small however
 * many points there are. */
constexpr std::size_t most_clusters = 256;

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
      const bool any_kept = kept_count_[i] != 0;
      const Spread spread{(any_kept ? kept_ : all_).mean[i],
                          (any_kept ? kept_ : all_).sd[i]};
      results[i] = isKnown(i) ? toINAD(spread) : unknown_inad;
    }
  }

private:
  /** \brief Where the angles of query i begin: vectors, and one more for what ends
   * them. */
  static std::size_t
  anglesBegin(const INADSlots& slots, std::size_t i)
  {
    return i * ((slots.total() + block_size - 1) / block_size + 1) * block_size;
  }

  template <bool with_ties, bool is_smooth>
  void
  collect(const INADSlots& slots, std::uint32_t* angles, BlockSums& sums) const
  {
    auto* chords = reinterpret_cast<float*>(angles);
    for (std::size_t i = 0; i < block_.size; ++i) {
      sums.count[i] = collectChords<with_ties, is_smooth>(
          block_, own_, i, slots, chords + anglesBegin(slots, i));
    }
    for (std::size_t i = 0; i < block_.size; ++i) {
      AngleAdder adder;
      chordsToAngles(angles + anglesBegin(slots, i), sums.count[i], adder);
      sums.sum[i] = adder.total();
      sums.squares[i] = adder.totalOfSquares();
    }
    sums.clearFrom(block_.size);
  }

  void
  collect(const INADSlots& slots, std::uint32_t* angles, BlockSums& sums) const
  {
    const bool is_smooth = candidates_.isSmooth();
    if (near_.hasTies()) {
      is_smooth ? collect<true, true>(slots, angles, sums)
                : collect<true, false>(slots, angles, sums);
    }
    else {
      is_smooth ? collect<false, true>(slots, angles, sums)
                : collect<false, false>(slots, angles, sums);
    }
  }

  /** \brief All less the rejected ones, which are few: sums are exact. Moves angles. */
  void
  sumKeptOf(const INADSlots& slots,
            std::uint32_t* angles,
            const BlockSums& all,
            BlockSums& kept) const
  {
    kept = all;
    std::size_t rejected[block_size];
    // One after the other, what is packed would be read before it is there.
    for (std::size_t i = 0; i < block_.size; ++i) {
      rejected[i] = packRejected(angles + anglesBegin(slots, i),
                                 all.count[i],
                                 ranges_.least[i],
                                 ranges_.width[i]);
    }
    for (std::size_t i = 0; i < block_.size; ++i) {
      AngleAdder adder;
      addAngles(angles + anglesBegin(slots, i), rejected[i], adder);
      kept.count[i] -= rejected[i];
      kept.sum[i] -= adder.total();
      kept.squares[i] -= adder.totalOfSquares();
    }
  }

  static std::uint32_t*
  anglesOfAll(const INADSlots& slots)
  {
    return simdScratch().angles.atLeast(anglesBegin(slots, block_size));
  }

  /** \brief Angles are there for the second pass. */
  void
  sumOnePortion()
  {
    const INADSlots slots = candidates_.list(0, near_.size());
    std::uint32_t* angles = anglesOfAll(slots);
    BlockSums found, all, kept;
    collect(slots, angles, found);
    all = found;
    setAll(all);
    findMissingSpreads(slots);
    sumKeptOf(slots, angles, found, kept);
    for (std::size_t i = 0; i < block_size; ++i) {
      kept_count_[i] = kept.count[i] -= std::min(kept.count[i], ownKept(i));
    }
    spreadsOf(kept, kept_);
  }

  /** \brief The ranges that follow from the sums over all angles, own points included.
   */
  void
  setAll(BlockSums& all)
  {
    for (std::size_t i = 0; i < block_size; ++i) {
      const std::uint64_t own = own_.is_neighbor[i];
      count_[i] = all.count[i] -= std::min(all.count[i], own);
    }
    spreadsOf(all, all_);
    keptRanges(all_, outlier_rate_, ranges_);
  }

  /** \brief However many candidates: their angles are computed twice. */
  void
  sumManyPortions()
  {
    AngleSums all[block_size], kept[block_size];
    forEachPortion([&](const INADSlots& slots) {
      BlockSums part;
      collect(slots, anglesOfAll(slots), part);
      add(part, all);
    });
    for (std::size_t i = 0; i < block_size; ++i) {
      const std::uint64_t own = own_.is_neighbor[i];
      count_[i] = all[i].count -= std::min(all[i].count, own);
    }
    setSpreads(all, all_);
    keptRanges(all_, outlier_rate_, ranges_);
    forEachPortion([&](const INADSlots& slots) {
      BlockSums found, part;
      std::uint32_t* angles = anglesOfAll(slots);
      collect(slots, angles, found);
      sumKeptOf(slots, angles, found, part);
      add(part, kept);
    });
    for (std::size_t i = 0; i < block_size; ++i) {
      kept_count_[i] = kept[i].count -= std::min(kept[i].count, ownKept(i));
    }
    setSpreads(kept, kept_);
  }

  /** \brief How many own points are among the angles kept: their angle is 0. */
  std::uint64_t
  ownKept(std::size_t i) const
  {
    return ranges_.least[i] == 0 ? own_.is_neighbor[i] : 0;
  }

  template <typename Visit>
  void
  forEachPortion(const Visit& visit)
  {
    for (std::size_t begin = 0; begin < near_.size(); begin += most_clusters) {
      visit(candidates_.list(begin, std::min(most_clusters, near_.size() - begin)));
    }
  }

  static void
  add(const BlockSums& part, AngleSums* sums)
  {
    for (std::size_t i = 0; i < block_size; ++i) {
      sums[i].count += part.count[i];
      sums[i].sum += part.sum[i];
      sums[i].squares += part.squares[i];
    }
  }

  /** \brief As of one portion, whatever the number of portions: the same angles give
   * the same result. */
  static void
  setSpreads(const AngleSums* sums, BlockSpreads& spreads)
  {
    BlockSums few;
    few.clearFrom(0);
    for (std::size_t i = 0; i < block_size; ++i) {
      if (sums[i].count <= most_for_64_bits) {
        few.count[i] = sums[i].count;
        few.sum[i] = sums[i].sum;
        few.squares[i] = static_cast<std::uint64_t>(sums[i].squares);
      }
    }
    spreadsOf(few, spreads);
    for (std::size_t i = 0; i < block_size; ++i) {
      if (sums[i].count > most_for_64_bits) {
        const Spread spread = sums[i].spread();
        spreads.mean[i] = spread.mean;
        spreads.sd[i] = spread.sd;
      }
    }
  }

  /** \brief Mostly, a few of the candidates tell. */
  void
  findMissingSpreads(const INADSlots& slots)
  {
    for (const std::size_t step : {8, 1}) {
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
  BlockRanges ranges_;
};

inline void
inad(const SweepBlock& block, double outlier_rate, INADResult* results)
{
  BlockINAD(block, outlier_rate).compute(results);
}

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
