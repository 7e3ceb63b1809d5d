/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#if defined(PCL_SHAPE_SIMD_INAD_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PCL_SHAPE_SIMD_INAD_LANES_INL_H_
#undef PCL_SHAPE_SIMD_INAD_LANES_INL_H_
#else
#define PCL_SHAPE_SIMD_INAD_LANES_INL_H_
#endif

#include "simd_angles-inl.h"
#include "simd_inad_candidates-inl.h"
#include "simd_query_lanes-inl.h"
#include "simd_spread_of_angles-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

/** \brief Stands for the angle to what is no neighbor: it is in no range. What x86
 * makes of the square root of a negative number. */
constexpr std::uint32_t no_angle = 0x80000000u;

/** \brief Stands for the squared chord to what is no neighbor. */
constexpr float no_chord = -1.0f;

/** \brief Squared chords of as many queries as there are lanes to some candidates. */
template <bool with_ties, bool is_smooth>
HWY_INLINE void
collectChords(const QueryLanes<with_ties>& queries,
              const hn::VFromD<Floats> (&normal)[3],
              const SweepBlock& block,
              const std::uint32_t* positions,
              std::size_t size,
              float* HWY_RESTRICT chords,
              hn::VFromD<Words>& counts)
{
  const Floats d;
  const Words w;
  const auto one = hn::Set(w, 1);
  for (std::size_t c = 0; c < size; ++c) {
    const std::size_t j = positions[c];
    const auto mask = queries.neighborMask(block, j);
    const auto chord = squaredChords<is_smooth>(hn::Set(d, block.nx[j]),
                                                hn::Set(d, block.ny[j]),
                                                hn::Set(d, block.nz[j]),
                                                normal[0],
                                                normal[1],
                                                normal[2]);
    hn::Store(hn::IfThenElse(mask, chord, hn::Set(d, no_chord)), d, chords + c * lanes);
    counts = hn::IfThenElse(hn::RebindMask(w, mask), hn::Add(counts, one), counts);
  }
}

/** \brief The same to neighbors of all queries. */
template <bool is_smooth>
HWY_INLINE void
collectSureChords(const hn::VFromD<Floats> (&normal)[3],
                  const SweepBlock& block,
                  const std::uint32_t* positions,
                  std::size_t size,
                  float* HWY_RESTRICT chords)
{
  const Floats d;
  for (std::size_t c = 0; c < size; ++c) {
    const std::size_t j = positions[c];
    const auto chord = squaredChords<is_smooth>(hn::Set(d, block.nx[j]),
                                                hn::Set(d, block.ny[j]),
                                                hn::Set(d, block.nz[j]),
                                                normal[0],
                                                normal[1],
                                                normal[2]);
    hn::Store(chord, d, chords + c * lanes);
  }
}

/** \brief Squared chords, or no_chord, to angles, or no_angle. */
HWY_INLINE void
collectAngles(const float* HWY_RESTRICT chords,
              std::size_t size,
              std::uint32_t* HWY_RESTRICT angles,
              AngleAdder& adder)
{
  const Floats d;
  const Words w;
  const Ints signed_ints;
  for (std::size_t c = 0; c < size * lanes; c += lanes) {
    const auto chord = hn::Load(d, chords + c);
    auto units = anglesOf(chord);
#if !HWY_ARCH_X86
    units = hn::IfThenElse(
        hn::RebindMask(w, hn::Lt(chord, hn::Zero(d))), hn::Set(w, no_angle), units);
#endif
    hn::Store(units, w, angles + c);
    const auto not_less =
        hn::Max(hn::BitCast(signed_ints, units), hn::Zero(signed_ints));
    adder.add(hn::BitCast(w, not_less));
  }
  adder.widen();
}

/** \brief Angles of as many queries as there are lanes, from `first` on, to all
 * candidates, and their sums. In two loops, through a buffer: one would be a chain too
 * long for processors to look beyond.
 * \param[out] angles a vector for each candidate */
template <bool with_ties, bool is_smooth>
HWY_NOINLINE void
collectAngles(const SweepBlock& block,
              const OwnPoints& own,
              std::size_t first,
              const CandidatePositions& candidates,
              std::uint32_t* HWY_RESTRICT angles,
              BlockSums& sums)
{
  const Floats d;
  const QueryLanes<with_ties> queries(block, block.r2, block.tie_d2, first);
  const hn::VFromD<Floats> normal[] = {hn::LoadU(d, own.nx + first),
                                       hn::LoadU(d, own.ny + first),
                                       hn::LoadU(d, own.nz + first)};
  HWY_ALIGN float chords[additions_between_widening * lanes];
  AngleAdder adder;
  auto counts = hn::Zero(Words());
  for (std::size_t c = 0; c < candidates.size; c += additions_between_widening) {
    const std::size_t size = std::min(candidates.size - c, additions_between_widening);
    collectChords<with_ties, is_smooth>(
        queries, normal, block, candidates.begin + c, size, chords, counts);
    collectAngles(chords, size, angles + c * lanes, adder);
  }
  angles += candidates.size * lanes;
  for (std::size_t c = 0; c < candidates.sure_size; c += additions_between_widening) {
    const std::size_t size =
        std::min(candidates.sure_size - c, additions_between_widening);
    collectSureChords<is_smooth>(normal, block, candidates.sure + c, size, chords);
    collectAngles(chords, size, angles + c * lanes, adder);
  }
  counts = hn::Add(counts,
                   hn::Set(Words(), static_cast<std::uint32_t>(candidates.sure_size)));
  addLanes(counts, sums.count + first);
  adder.addSums(sums.sum + first);
  adder.addSquares(sums.squares + first);
}

/** \brief Sums over the angles in each query's range. */
HWY_NOINLINE void
sumKept(const std::uint32_t* HWY_RESTRICT angles,
        std::size_t count,
        const BlockRanges& ranges,
        std::size_t first,
        BlockSums& sums)
{
  const Words w;
  const auto one = hn::Set(w, 1);
  // One unsigned comparison: what is below the least wraps around.
  const auto from = hn::LoadU(w, ranges.least + first);
  const auto most = hn::LoadU(w, ranges.width + first);
  AngleAdder adder;
  auto counts = hn::Zero(w);
  for (std::size_t c = 0; c < count;) {
    const std::size_t end = std::min(count, c + additions_between_widening);
    for (; c < end; ++c) {
      const auto units = hn::Load(w, angles + c * lanes);
      const auto is_kept = hn::Not(hn::Gt(hn::Sub(units, from), most));
      adder.add(hn::IfThenElseZero(is_kept, units));
      counts = hn::IfThenElse(is_kept, hn::Add(counts, one), counts);
    }
    adder.widen();
  }
  addLanes(counts, sums.count + first);
  adder.addSums(sums.sum + first);
  adder.addSquares(sums.squares + first);
}

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
