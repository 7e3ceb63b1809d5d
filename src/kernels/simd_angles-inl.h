/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#if defined(PCL_SHAPE_SIMD_ANGLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PCL_SHAPE_SIMD_ANGLES_INL_H_
#undef PCL_SHAPE_SIMD_ANGLES_INL_H_
#else
#define PCL_SHAPE_SIMD_ANGLES_INL_H_
#endif

#include "angle.h"
#include "simd_common-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

/** \brief Angles of squared chords, in units (angle.h). */
template <class V>
HWY_INLINE hn::VFromD<Words>
anglesOf(V chords)
{
  const Floats d;
  const auto coefficient = [&](float q) { return hn::Set(d, q * units_per_radian); };
  auto q = coefficient(2.884860886e-05f);
  q = hn::MulAdd(q, chords, coefficient(-8.097935841e-05f));
  q = hn::MulAdd(q, chords, coefficient(3.057683521e-04f));
  q = hn::MulAdd(q, chords, coefficient(5.256729479e-04f));
  q = hn::MulAdd(q, chords, coefficient(4.766297369e-03f));
  q = hn::MulAdd(q, chords, coefficient(4.165096783e-02f));
  q = hn::MulAdd(q, chords, coefficient(1.000000898e+00f));
  return hn::BitCast(Words(), nearestInt(hn::Mul(hn::Sqrt(chords), q)));
}

/** \brief Squared chord between two normals.
 * \tparam is_smooth both are known to be on the same side; otherwise they have either
 * sign: the nearer one counts */
template <bool is_smooth, class V>
HWY_INLINE V
squaredChords(V ax, V ay, V az, V bx, V by, V bz)
{
  const auto mx = hn::Sub(ax, bx), my = hn::Sub(ay, by), mz = hn::Sub(az, bz);
  const auto chord = hn::MulAdd(mx, mx, hn::MulAdd(my, my, hn::Mul(mz, mz)));
  if constexpr (is_smooth) {
    return chord;
  }
  const auto px = hn::Add(ax, bx), py = hn::Add(ay, by), pz = hn::Add(az, bz);
  return hn::Min(chord, hn::MulAdd(px, px, hn::MulAdd(py, py, hn::Mul(pz, pz))));
}

/** \brief Sums of angles and of their squares. Squares of even and odd lanes are added
 * up apart, in 64 bits. */
class AngleAdder {
public:
  // A constructor that the compiler makes would not have the target's instructions.
  HWY_INLINE
  AngleAdder()
  : sum_(hn::Zero(Words()))
  , even_(hn::Zero(Longs()))
  , odd_(hn::Zero(Longs()))
  , even_squares_(hn::Zero(Longs()))
  , odd_squares_(hn::Zero(Longs()))
  {}

  /** \brief Lanes that are 0 add nothing. */
  template <class V>
  HWY_INLINE void
  add(V units)
  {
    const Words w;
    const Longs l;
    const auto odd = hn::BitCast(w, hn::ShiftRight<32>(hn::BitCast(l, units)));
    sum_ = hn::Add(sum_, units);
    even_squares_ = hn::Add(even_squares_, hn::MulEven(units, units));
    odd_squares_ = hn::Add(odd_squares_, hn::MulEven(odd, odd));
  }

  /** \brief To be called at least every 128 additions: 128 angles fit in 32 bits. */
  HWY_INLINE void
  widen()
  {
    const Longs l;
    const auto sum = hn::BitCast(l, sum_);
    even_ = hn::Add(even_, hn::And(sum, hn::Set(l, 0xffffffffu)));
    odd_ = hn::Add(odd_, hn::ShiftRight<32>(sum));
    sum_ = hn::Zero(Words());
  }

  HWY_INLINE std::uint64_t
  total() const
  {
    return hn::GetLane(hn::SumOfLanes(Longs(), hn::Add(even_, odd_)));
  }

  HWY_INLINE std::uint64_t
  totalOfSquares() const
  {
    return hn::GetLane(hn::SumOfLanes(Longs(), hn::Add(even_squares_, odd_squares_)));
  }

  HWY_INLINE void
  addSums(std::uint64_t* totals) const
  {
    addLanes(even_, odd_, totals);
  }

  HWY_INLINE void
  addSquares(std::uint64_t* totals) const
  {
    addLanes(even_squares_, odd_squares_, totals);
  }

private:
  template <class V>
  static HWY_INLINE void
  addLanes(V even, V odd, std::uint64_t* totals)
  {
    HWY_ALIGN std::uint64_t parts[2][lanes / 2];
    hn::Store(even, Longs(), parts[0]);
    hn::Store(odd, Longs(), parts[1]);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      totals[lane] += parts[lane % 2][lane / 2];
    }
  }

  hn::VFromD<Words> sum_;
  hn::VFromD<Longs> even_, odd_, even_squares_, odd_squares_;
};

constexpr std::size_t additions_between_widening = 128;

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
