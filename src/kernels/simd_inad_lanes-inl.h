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
#include "simd_spread_of_angles-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

/** \brief One query, and which of the packed candidates are its neighbors. */
template <bool with_ties>
class OneQuery {
public:
  HWY_INLINE
  OneQuery(const SweepBlock& block, const OwnPoints& own, std::size_t i)
  : x_(hn::Set(Floats(), block.qx[i]))
  , y_(hn::Set(Floats(), block.qy[i]))
  , z_(hn::Set(Floats(), block.qz[i]))
  , r2_(hn::Set(Floats(), block.r2[i]))
  , nx_(hn::Set(Floats(), own.nx[i]))
  , ny_(hn::Set(Floats(), own.ny[i]))
  , nz_(hn::Set(Floats(), own.nz[i]))
  , tie_d2_(hn::Set(Floats(), block.tie_d2[i]))
  , tie_index_(hn::Set(Ints(), static_cast<std::int32_t>(block.tie_index[i])))
  {}

  /** \brief Which of a vector of points are neighbors. */
  HWY_INLINE MaskOf<Floats>
  neighborMask(const float* x, const float* y, const float* z, const float* order) const
  {
    const Floats d;
    const auto d2 = squaredLength(hn::Sub(hn::LoadU(d, x), x_),
                                  hn::Sub(hn::LoadU(d, y), y_),
                                  hn::Sub(hn::LoadU(d, z), z_));
    const auto near = hn::Lt(d2, r2_);
    if constexpr (with_ties) {
      const auto index = hn::BitCast(Ints(), hn::LoadU(d, order));
      const auto first = hn::RebindMask(d, hn::Not(hn::Gt(index, tie_index_)));
      return hn::Or(near, hn::And(hn::Eq(d2, tie_d2_), first));
    }
    else {
      return near;
    }
  }

  template <bool is_smooth>
  HWY_INLINE hn::VFromD<Floats>
  chords(const float* nx, const float* ny, const float* nz) const
  {
    const Floats d;
    return squaredChords<is_smooth>(
        hn::LoadU(d, nx), hn::LoadU(d, ny), hn::LoadU(d, nz), nx_, ny_, nz_);
  }

private:
  hn::VFromD<Floats> x_, y_, z_, r2_, nx_, ny_, nz_, tie_d2_;
  hn::VFromD<Ints> tie_index_;
};

/** \brief The squared chords between the normals of a query and its neighbors, packed,
 * then a vector of least chords.
 * \return how many neighbors there are, the query's own point among them */
template <bool with_ties, bool is_smooth>
HWY_NOINLINE std::size_t
collectChords(const SweepBlock& block,
              const OwnPoints& own,
              std::size_t i,
              const INADSlots& slots,
              float* HWY_RESTRICT chords)
{
  const Floats d;
  const OneQuery<with_ties> query(block, own, i);
  // Local: what is written might be one of these.
  const float* arrays[INADSlots::array_count];
  std::copy_n(slots.arrays, std::size_t{INADSlots::array_count}, arrays);
  const std::size_t size = slots.size;
  std::size_t count = 0;
  for (std::size_t c = 0; c < size; c += lanes) {
    const auto mask = query.neighborMask(arrays[INADSlots::x] + c,
                                         arrays[INADSlots::y] + c,
                                         arrays[INADSlots::z] + c,
                                         arrays[INADSlots::order] + c);
    const auto chord = query.template chords<is_smooth>(arrays[INADSlots::nx] + c,
                                                        arrays[INADSlots::ny] + c,
                                                        arrays[INADSlots::nz] + c);
    count += packStore(d, chord, mask, chords + count);
  }
  const float *nx = block.nx, *ny = block.ny, *nz = block.nz;
  for (std::size_t s = 0; s < slots.sure_size; ++s, count += lanes) {
    const std::size_t j = slots.sure[s];
    const auto chord = query.template chords<is_smooth>(nx + j, ny + j, nz + j);
    hn::StoreU(chord, d, chords + count);
  }
  hn::StoreU(hn::Set(d, least_chord), d, chords + count);
  return count;
}

/** \brief Squared chords, of which a vector follows them, to angles, and their sums. */
HWY_INLINE void
chordsToAngles(const float* HWY_RESTRICT chords,
               std::size_t count,
               std::uint32_t* HWY_RESTRICT angles,
               AngleAdder& adder)
{
  const Floats d;
  const Words w;
  for (std::size_t c = 0; c < count;) {
    const std::size_t end = std::min(count, c + additions_between_widening * lanes);
    for (; c < end; c += lanes) {
      const auto units = anglesOf(hn::Load(d, chords + c));
      hn::Store(units, w, angles + c);
      adder.add(units);
    }
    adder.widen();
  }
}

/** \brief Packs the angles that are not in a range, in place; of what follows them, a
 * vector is overwritten. \return how many they are */
template <bool from_zero>
HWY_INLINE std::size_t
packRejected(std::uint32_t* HWY_RESTRICT angles,
             std::size_t count,
             std::uint32_t least,
             std::uint32_t width)
{
  const Words w;
  // One unsigned comparison: what is below the least wraps around.
  const auto from = hn::Set(w, least);
  const auto most = hn::Set(w, width);
  std::size_t rejected = 0;
  const auto isRejected = [&](auto units) {
    return hn::Gt(from_zero ? units : hn::Sub(units, from), most);
  };
  std::size_t c = 0;
  for (; c + lanes <= count; c += lanes) {
    const auto units = hn::Load(w, angles + c);
    rejected += packStore(w, units, isRejected(units), angles + rejected);
  }
  const auto units = hn::Load(w, angles + c);
  const auto mask = hn::And(isRejected(units), hn::FirstN(w, count - c));
  rejected += packStore(w, units, mask, angles + rejected);
  hn::StoreU(hn::Zero(w), w, angles + rejected);
  return rejected;
}

HWY_INLINE std::size_t
packRejected(std::uint32_t* angles,
             std::size_t count,
             std::uint32_t least,
             std::uint32_t width)
{
  // In one vector, a subtraction takes less time than a branch that goes either way.
  return least == 0 && count > lanes ? packRejected<true>(angles, count, least, width)
                                     : packRejected<false>(angles, count, least, width);
}

/** \brief Sums over angles that a vector of zeros follows. */
HWY_INLINE void
addAngles(const std::uint32_t* HWY_RESTRICT angles,
          std::size_t count,
          AngleAdder& adder)
{
  const Words w;
  // At least one: mostly there are one or none, and which cannot be predicted.
  std::size_t c = 0;
  do {
    const std::size_t end = std::min(count, c + additions_between_widening * lanes);
    do {
      adder.add(hn::Load(w, angles + c));
      c += lanes;
    }
    while (c < end);
    adder.widen();
  }
  while (c < count);
}

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
