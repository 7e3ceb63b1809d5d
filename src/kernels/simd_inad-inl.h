/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#if defined(PCL_SHAPE_SIMD_INAD_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PCL_SHAPE_SIMD_INAD_INL_H_
#undef PCL_SHAPE_SIMD_INAD_INL_H_
#else
#define PCL_SHAPE_SIMD_INAD_INL_H_
#endif

#include "angle.h"
#include "angle_sums.h"
#include "neighborhood.h"
#include "simd_candidates-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

/** \brief Writes the squared chords between the query's normal and its neighbors', and
 * finds out whether the neighbors spread over a surface: whether one of them makes,
 * with the anchor, a parallelogram larger than those on a line can make
 * (geometry_check.h: two offsets within 1e-3 r of one line span less than 2.1e-3 r^2).
 * \tparam is_smooth all normals are on the same side of the query's
 */
template <bool with_ties, bool is_smooth>
HWY_INLINE std::size_t
collectChords(const SweepBlock& block,
              const OwnPoints& own,
              std::size_t i,
              const Candidates& candidates,
              float* HWY_RESTRICT chords,
              bool& spreads)
{
  const Floats d;
  const std::size_t size = candidates.size;
  const auto qx = hn::Set(d, block.qx[i]);
  const auto qy = hn::Set(d, block.qy[i]);
  const auto qz = hn::Set(d, block.qz[i]);
  const auto nx = hn::Set(d, own.nx[i]);
  const auto ny = hn::Set(d, own.ny[i]);
  const auto nz = hn::Set(d, own.nz[i]);
  std::size_t count = 0;
  for (std::size_t c = 0; c < size; c += lanes) {
    const auto dx = hn::Sub(hn::LoadU(d, candidates.x() + c), qx);
    const auto dy = hn::Sub(hn::LoadU(d, candidates.y() + c), qy);
    const auto dz = hn::Sub(hn::LoadU(d, candidates.z() + c), qz);
    const auto mask =
        neighborMask<with_ties>(block, i, candidates, c, squaredLength(dx, dy, dz));
    if (HWY_UNLIKELY(!spreads)) {
      const auto ax = hn::Set(d, own.ax[i]);
      const auto ay = hn::Set(d, own.ay[i]);
      const auto az = hn::Set(d, own.az[i]);
      const auto cross2 = squaredLength(hn::Sub(hn::Mul(ay, dz), hn::Mul(az, dy)),
                                        hn::Sub(hn::Mul(az, dx), hn::Mul(ax, dz)),
                                        hn::Sub(hn::Mul(ax, dy), hn::Mul(ay, dx)));
      const float r2 = std::max(block.r2[i], block.tie_d2[i]);
      const auto wide = hn::Gt(cross2, hn::Set(d, 4.5e-6f * r2 * r2));
      spreads = !hn::AllFalse(d, hn::And(mask, wide));
    }
    const auto ox = hn::LoadU(d, candidates.nx() + c);
    const auto oy = hn::LoadU(d, candidates.ny() + c);
    const auto oz = hn::LoadU(d, candidates.nz() + c);
    const auto mx = hn::Sub(ox, nx), my = hn::Sub(oy, ny), mz = hn::Sub(oz, nz);
    auto chord = hn::MulAdd(mx, mx, hn::MulAdd(my, my, hn::Mul(mz, mz)));
    if constexpr (!is_smooth) {
      // Normals have either sign: the nearer one counts.
      const auto px = hn::Add(ox, nx), py = hn::Add(oy, ny), pz = hn::Add(oz, nz);
      chord = hn::Min(chord, hn::MulAdd(px, px, hn::MulAdd(py, py, hn::Mul(pz, pz))));
    }
    count += packStore(d, chord, mask, chords + count);
  }
  return count;
}

/** \brief Adds up angles in units; lanes that are 0 add nothing. */
class AngleAdder {
public:
  // A constructor that the compiler makes would not have the target's instructions.
  HWY_INLINE
  AngleAdder()
  : sum_(hn::Zero(Words()))
  , long_sum_(hn::Zero(Longs()))
  , even_squares_(hn::Zero(Longs()))
  , odd_squares_(hn::Zero(Longs()))
  {}

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
    long_sum_ = hn::Add(
        long_sum_,
        hn::Add(hn::And(sum, hn::Set(l, 0xffffffffu)), hn::ShiftRight<32>(sum)));
    sum_ = hn::Zero(Words());
  }

  HWY_INLINE std::uint64_t
  sum() const
  {
    return hn::GetLane(hn::SumOfLanes(Longs(), long_sum_));
  }

  HWY_INLINE std::uint64_t
  squares() const
  {
    return hn::GetLane(hn::SumOfLanes(Longs(), hn::Add(even_squares_, odd_squares_)));
  }

private:
  hn::VFromD<Words> sum_;
  hn::VFromD<Longs> long_sum_;
  hn::VFromD<Longs> even_squares_;
  hn::VFromD<Longs> odd_squares_;
};

struct Sums {
  std::uint64_t count = 0, sum = 0, squares = 0;
};

constexpr std::size_t additions_between_widening = 128;

/** \brief Squared chords to angles in units (angle.h), and their sums. Writes up to a
 * whole vector; the lanes behind the last angle are 0. */
HWY_INLINE Sums
toAngles(float* HWY_RESTRICT chords,
         std::size_t count,
         std::uint32_t* HWY_RESTRICT angles)
{
  const Floats d;
  const auto coefficient = [&](float q) { return hn::Set(d, q * units_per_radian); };
  hn::StoreU(hn::Zero(d), d, chords + count);
  AngleAdder adder;
  std::size_t i = 0;
  while (i < count) {
    const std::size_t end = std::min(count, i + additions_between_widening * lanes);
    for (; i < end; i += lanes) {
      const auto t = hn::LoadU(d, chords + i);
      auto q = coefficient(2.884860886e-05f);
      q = hn::MulAdd(q, t, coefficient(-8.097935841e-05f));
      q = hn::MulAdd(q, t, coefficient(3.057683521e-04f));
      q = hn::MulAdd(q, t, coefficient(5.256729479e-04f));
      q = hn::MulAdd(q, t, coefficient(4.766297369e-03f));
      q = hn::MulAdd(q, t, coefficient(4.165096783e-02f));
      q = hn::MulAdd(q, t, coefficient(1.000000898e+00f));
      const auto units = hn::BitCast(Words(), nearestInt(hn::Mul(hn::Sqrt(t), q)));
      hn::StoreU(units, Words(), angles + i);
      adder.add(units);
    }
    adder.widen();
  }
  return {count, adder.sum(), adder.squares()};
}

/** \brief Sums over the angles in the range.
 * \param[in] own_zeros how many of the angles are not to be counted: they are 0, as is
 * what follows the last angle in its vector */
HWY_INLINE Sums
sumKept(const std::uint32_t* HWY_RESTRICT angles,
        std::size_t count,
        const KeptRange& range,
        std::size_t own_zeros)
{
  const Words w;
  // One unsigned comparison: what is below the first wraps around.
  const auto first = hn::Set(w, static_cast<std::uint32_t>(range.first));
  const auto width = hn::Set(w, static_cast<std::uint32_t>(range.last - range.first));
  AngleAdder adder;
  std::size_t rejected = 0;
  std::size_t i = 0;
  while (i < count) {
    const std::size_t end = std::min(count, i + additions_between_widening * lanes);
    for (; i < end; i += lanes) {
      const auto units = hn::LoadU(w, angles + i);
      const auto is_outlier = hn::Gt(hn::Sub(units, first), width);
      rejected += hn::CountTrue(w, is_outlier);
      adder.add(hn::IfThenZeroElse(is_outlier, units));
    }
    adder.widen();
  }
  const std::size_t zeros = range.first <= 0 ? i - count + own_zeros : 0;
  return {i - rejected - zeros, adder.sum(), adder.squares()};
}

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
