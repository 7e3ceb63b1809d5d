// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// INAD of a block's queries: angles, outlier rejection, and whether there is a surface.

// No include guard: simd_kernels.cpp includes it once for each target.

#include "sweep/portable/neighborhood.h"
#include "sweep/simd/angles-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

constexpr std::size_t long_lanes = lanes / 2;

/** \brief What the angles of each query of a block add up to: a vector of each at
 * first, whose lanes are added up several queries at once. */
class BlockTotals {
public:
  /** \param[in] size how many queries will be set: the others' sums are 0 */
  HWY_INLINE explicit BlockTotals(std::size_t size)
  {
    const auto nothing = hn::Zero(Longs());
    for (std::size_t i = size; i < block_size; ++i) {
      hn::Store(nothing, Longs(), parts_[i]);
      hn::Store(nothing, Longs(), squares_[i]);
    }
  }

  HWY_INLINE void
  set(std::size_t i, const AngleAdder& adder)
  {
    hn::Store(adder.parts(), Longs(), parts_[i]);
    hn::Store(adder.partsOfSquares(), Longs(), squares_[i]);
  }

  HWY_INLINE void
  store(std::uint64_t* sums, std::uint64_t* squares) const
  {
    for (std::size_t i = 0; i < block_size; i += long_lanes) {
      hn::StoreU(totals(parts_ + i), Longs(), sums + i);
      hn::StoreU(totals(squares_ + i), Longs(), squares + i);
    }
  }

private:
  using Row = std::uint64_t[long_lanes];

  HWY_INLINE static hn::VFromD<Longs>
  totals(const Row* rows)
  {
    const Longs l;
    hn::VFromD<Longs> sums[long_lanes];
    for (std::size_t k = 0; k < long_lanes; ++k)
      sums[k] = hn::Load(l, rows[k]);
    for (std::size_t n = long_lanes / 2; n > 0; n /= 2) {
      for (std::size_t k = 0; k < n; ++k) {
        const auto low = sums[2 * k], high = sums[2 * k + 1];
        sums[k] = hn::Add(hn::ConcatEven(l, high, low), hn::ConcatOdd(l, high, low));
      }
    }
    return sums[0];
  }

  HWY_ALIGN Row parts_[block_size];
  HWY_ALIGN Row squares_[block_size];
};

/** \brief The angles between the normals of a block's queries and candidates. */
class BlockAngles {
public:
  BlockAngles(const SweepBlock& block, const OwnPoints& own, const INADSlots& slots)
  : block_(block)
  , own_(own)
  , slots_(slots)
  , stride_(((slots.size + slots.sure_size * lanes + block_size - 1) / block_size + 1) *
            block_size)
  , angles_(simdScratch().angles.atLeast(block_size * stride_))
  {}

  BlockSums
  find(bool has_ties, bool is_smooth)
  {
    BlockSums sums;
    if (has_ties)
      is_smooth ? find<true, true>(sums) : find<true, false>(sums);
    else
      is_smooth ? find<false, true>(sums) : find<false, false>(sums);
    return sums;
  }

  /** \brief All less the rejected ones, which are few: sums are exact. Moves angles. */
  BlockSums
  sumKept(const BlockRanges& ranges, const BlockSums& all)
  {
    std::size_t rejected[block_size] = {};
    // One after the other, what is packed would be read before it is there.
    for (std::size_t i = 0; i < block_.size; ++i) {
      rejected[i] =
          packRejected(angles(i), all.count[i], ranges.min[i], ranges.width[i]);
    }
    BlockTotals totals(block_.size);
    for (std::size_t i = 0; i < block_.size; ++i) {
      AngleAdder adder;
      addAngles(angles(i), rejected[i], adder);
      totals.set(i, adder);
    }
    BlockSums kept;
    totals.store(kept.sum, kept.squares);
    for (std::size_t i = 0; i < block_size; ++i) {
      kept.count[i] = all.count[i] - rejected[i];
      kept.sum[i] = all.sum[i] - kept.sum[i];
      kept.squares[i] = all.squares[i] - kept.squares[i];
    }
    return kept;
  }

private:
  /** \brief Of query i: whole vectors, and one more for what ends them. */
  std::uint32_t*
  angles(std::size_t i) const
  {
    return angles_ + i * stride_;
  }

  template <bool with_ties, bool is_smooth>
  void
  find(BlockSums& sums)
  {
    std::fill(sums.count + block_.size, sums.count + block_size, 0);
    BlockTotals totals(block_.size);
    float* const chords = simdScratch().values.atLeast(2 * stride_);
    const auto chordsOf = [&](std::size_t i) { return chords + (i % 2) * stride_; };
    const auto setAngles = [&](std::size_t i) {
      AngleAdder adder;
      chordsToAngles(chordsOf(i), sums.count[i], angles(i), adder);
      totals.set(i, adder);
    };
    // One query late: what was just packed cannot be read before it is in the cache.
    for (std::size_t i = 0; i < block_.size; ++i) {
      sums.count[i] =
          collectChords<with_ties, is_smooth>(block_, own_, i, slots_, chordsOf(i));
      if (i > 0)
        setAngles(i - 1);
    }
    setAngles(block_.size - 1);
    totals.store(sums.sum, sums.squares);
  }

  const SweepBlock& block_;
  const OwnPoints& own_;
  const INADSlots slots_;
  const std::size_t stride_;
  std::uint32_t* const angles_;
};

/** \brief Finds out which queries have neighbors that spread over a surface: one that
 * makes, with another (the anchor), a parallelogram larger than those on a line can
 * make. neighborhood.h: two offsets within 1e-3 r of one line span less than 2.1e-3
 * r^2. Lanes are queries.
 */
class SpreadFinder {
public:
  SpreadFinder(const SweepBlock& block, std::size_t first)
  {
    const Floats d;
    x_ = hn::LoadU(d, block.qx + first);
    y_ = hn::LoadU(d, block.qy + first);
    z_ = hn::LoadU(d, block.qz + first);
    // Of k nearest, the furthest may be left out: enough others are looked at.
    r2_ = hn::LoadU(d, block.r2 + first);
    const auto reach2 = hn::Max(r2_, hn::LoadU(d, block.tie_d2 + first));
    // What is too small for all digits of a float is left to others.
    min_cross2_ = hn::Max(hn::Mul(hn::Set(d, 4.5e-6f), hn::Mul(reach2, reach2)),
                          hn::Set(d, std::numeric_limits<float>::min()));
    furthest_ = anchor_x_ = anchor_y_ = anchor_z_ = hn::Zero(d);
    spreads_ = hn::Zero(d);
    is_query_ = hn::FirstN(d, block.size - first);
  }

  /** \brief Compares a point with the anchor. The furthest neighbor so far becomes it.
   */
  HWY_INLINE void
  look(float x, float y, float z)
  {
    const Floats d;
    const auto dx = hn::Sub(hn::Set(d, x), x_);
    const auto dy = hn::Sub(hn::Set(d, y), y_);
    const auto dz = hn::Sub(hn::Set(d, z), z_);
    const auto d2 = squaredLength(dx, dy, dz);
    const auto is_neighbor = hn::Lt(d2, r2_);
    const auto cross2 =
        roughSquaredLength(hn::MulSub(anchor_y_, dz, hn::Mul(anchor_z_, dy)),
                           hn::MulSub(anchor_z_, dx, hn::Mul(anchor_x_, dz)),
                           hn::MulSub(anchor_x_, dy, hn::Mul(anchor_y_, dx)));
    const auto spreads = hn::And(is_neighbor, hn::Gt(cross2, min_cross2_));
    spreads_ = hn::IfThenElse(spreads, hn::Set(d, 1.0f), spreads_);
    const auto further = hn::And(is_neighbor, hn::Gt(d2, furthest_));
    furthest_ = hn::IfThenElse(further, d2, furthest_);
    anchor_x_ = hn::IfThenElse(further, dx, anchor_x_);
    anchor_y_ = hn::IfThenElse(further, dy, anchor_y_);
    anchor_z_ = hn::IfThenElse(further, dz, anchor_z_);
  }

  /** \brief Whether the neighbors of all queries spread over a surface, so far. */
  HWY_INLINE bool
  hasAll() const
  {
    const Floats d;
    return hn::AllFalse(d, hn::And(is_query_, hn::Eq(spreads_, hn::Zero(d))));
  }

  HWY_INLINE void
  store(std::size_t first, bool* spreads) const
  {
    HWY_ALIGN float found[lanes];
    hn::Store(spreads_, Floats(), found);
    for (std::size_t lane = 0; lane < lanes; ++lane)
      spreads[first + lane] = spreads[first + lane] || found[lane] != 0.0f;
  }

private:
  hn::VFromD<Floats> x_, y_, z_, r2_, min_cross2_;
  hn::VFromD<Floats> furthest_, anchor_x_, anchor_y_, anchor_z_, spreads_;
  MaskOf<Floats> is_query_;
};

/** \brief Looks among the queries, which are surface points: mostly, a few tell. */
HWY_INLINE void
findSpreadsAmongQueries(const SweepBlock& block, bool* spreads)
{
  constexpr std::size_t step = 5; // neighbors along a row tell little
  for (std::size_t first = 0; first < block.size; first += lanes) {
    SpreadFinder finder(block, first);
    for (std::size_t begin = 0; begin < step && !finder.hasAll(); ++begin)
      for (std::size_t j = begin; j < block.size; j += step)
        finder.look(block.qx[j], block.qy[j], block.qz[j]);
    finder.store(first, spreads);
  }
}

/** \brief Looks at every `step`-th candidate, those left aside that surely are
 * neighbors. */
HWY_INLINE void
findSpreads(const SweepBlock& block,
            const INADSlots& slots,
            std::size_t step,
            bool* spreads)
{
  const float* x = slots.arrays[INADSlots::x];
  const float* y = slots.arrays[INADSlots::y];
  const float* z = slots.arrays[INADSlots::z];
  for (std::size_t first = 0; first < block.size; first += lanes) {
    SpreadFinder finder(block, first);
    for (std::size_t c = 0; c < slots.size; c += step)
      finder.look(x[c], y[c], z[c]);
    finder.store(first, spreads);
  }
}

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
    if (block.queries_on_surface)
      findSpreadsAmongQueries(block, spreads_);
  }

  void
  compute(INADResult* results)
  {
    near_.size <= max_clusters ? sumOnePortion() : sumManyPortions();
    for (std::size_t i = 0; i < block_.size; ++i) {
      const BlockSpreads& spreads = kept_count_[i] != 0 ? kept_ : all_;
      const bool is_known = hasNeighbors(i) && (spreads_[i] || spansSurface(block_, i));
      results[i] = is_known ? toINAD({spreads.mean[i], spreads.sd[i]}) : unknown_inad;
    }
  }

private:
  BlockSums
  sumAll(BlockAngles& angles) const
  {
    return angles.find(near_.has_ties, candidates_.isSmooth());
  }

  /** \brief Angles are there for the second pass. */
  void
  sumOnePortion()
  {
    const INADSlots slots = candidates_.list(0, near_.size);
    BlockAngles angles(block_, own_, slots);
    const BlockSums found = sumAll(angles);
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
    forEachPortion([&](BlockAngles angles) { all.add(sumAll(angles)); });
    const BlockRanges ranges = setAll(all);
    forEachPortion(
        [&](BlockAngles angles) { kept.add(angles.sumKept(ranges, sumAll(angles))); });
    setKept(ranges, kept);
  }

  template <typename Visit>
  void
  forEachPortion(const Visit& visit)
  {
    for (std::size_t begin = 0; begin < near_.size; begin += max_clusters) {
      const std::size_t count = std::min(max_clusters, near_.size - begin);
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
      const std::uint64_t own = ranges.min[i] == 0 ? own_.is_neighbor[i] : 0;
      count[i] -= std::min(count[i], own);
    }
  }

  /** \brief Mostly, a few of the candidates tell. */
  void
  findMissingSpreads(const INADSlots& slots)
  {
    constexpr std::size_t some = 8, all = 1;
    for (const std::size_t step : {some, all}) {
      bool knows_all = true;
      for (std::size_t i = 0; i < block_.size; ++i)
        knows_all = knows_all && (spreads_[i] || !hasNeighbors(i));
      if (!knows_all)
        findSpreads(block_, slots, step, spreads_);
    }
  }

  bool
  hasNeighbors(std::size_t i) const
  {
    return !std::isnan(own_.nx[i]) && count_[i] >= NeighborhoodSweep::min_neighbors;
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
