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

/** \brief What squared chords are at least: an angle of no unit, with an inverse. */
constexpr float least_chord = 1e-30f;

/** \brief Angles of squared chords, in units (angle.h). */
template <class V>
HWY_INLINE hn::VFromD<Words>
anglesOf(V chords)
{
  const Floats d;
#if HWY_ARCH_X86
  // A step of Newton's from an estimate y of 1 / sqrt(t), which is much sooner known
  // than the root: sqrt(t) = t y (3 - t y^2) / 2.
  constexpr float scale = 0.5f * units_per_radian;
  const auto y = hn::ApproximateReciprocalSqrt(chords);
  const auto estimate = hn::Mul(chords, y);
  const auto root = hn::Mul(estimate, hn::NegMulAdd(estimate, y, hn::Set(d, 3.0f)));
#else
  constexpr float scale = units_per_radian;
  const auto root = hn::Sqrt(chords);
#endif
  const auto coefficient = [&](float q) { return hn::Set(d, q * scale); };
  auto q = coefficient(2.884860886e-05f);
  q = hn::MulAdd(q, chords, coefficient(-8.097935841e-05f));
  q = hn::MulAdd(q, chords, coefficient(3.057683521e-04f));
  q = hn::MulAdd(q, chords, coefficient(5.256729479e-04f));
  q = hn::MulAdd(q, chords, coefficient(4.766297369e-03f));
  q = hn::MulAdd(q, chords, coefficient(4.165096783e-02f));
  q = hn::MulAdd(q, chords, coefficient(1.000000898e+00f));
  return hn::BitCast(Words(), nearestInt(hn::Mul(root, q)));
}

/** \brief Squared chord between two normals, and least_chord more.
 * \tparam is_smooth both are known to be on the same side; otherwise they have either
 * sign: the nearer one counts */
template <bool is_smooth, class V>
HWY_INLINE V
squaredChords(V ax, V ay, V az, V bx, V by, V bz)
{
  const auto mx = hn::Sub(ax, bx), my = hn::Sub(ay, by), mz = hn::Sub(az, bz);
  const auto least = hn::Set(hn::DFromV<V>(), least_chord);
  const auto chord = hn::MulAdd(mx, mx, hn::MulAdd(my, my, hn::MulAdd(mz, mz, least)));
  if constexpr (is_smooth) {
    return chord;
  }
  const auto px = hn::Add(ax, bx), py = hn::Add(ay, by), pz = hn::Add(az, bz);
  return hn::Min(chord,
                 hn::MulAdd(px, px, hn::MulAdd(py, py, hn::MulAdd(pz, pz, least))));
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

  /** \brief What lanes add up to. */
  HWY_INLINE hn::VFromD<Longs>
  parts() const
  {
    return hn::Add(even_, odd_);
  }

  HWY_INLINE hn::VFromD<Longs>
  partsOfSquares() const
  {
    return hn::Add(even_squares_, odd_squares_);
  }

private:
  hn::VFromD<Words> sum_;
  hn::VFromD<Longs> even_, odd_, even_squares_, odd_squares_;
};

constexpr std::size_t additions_between_widening = 128;

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
