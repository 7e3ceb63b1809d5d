/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#if defined(PCL_SHAPE_SIMD_MOMENTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PCL_SHAPE_SIMD_MOMENTS_INL_H_
#undef PCL_SHAPE_SIMD_MOMENTS_INL_H_
#else
#define PCL_SHAPE_SIMD_MOMENTS_INL_H_
#endif

#include "moments.h"
#include "neighborhood.h"
#include "simd_query_lanes-inl.h"

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

/** \brief Offsets are counted in 2^(level - 20): the radius is below 2^level. */
inline int
levelOf(float r2)
{
  int exponent = 0;
  std::frexp(r2, &exponent);
  if (std::isinf(r2)) {
    return 64;
  }
  return exponent > 0 ? (exponent + 1) / 2 : exponent / 2;
}

/** \brief Candidates' coordinates in units from an origin, as 32-bit words. Those
 * that are no neighbor of anybody may have no meaning.
 *
 * Units are a power of two, so that scaling is exact and rounding does not depend on
 * the origin.
 */
class Quantizer {
public:
  /** \param[in] largest the largest coordinate of a neighbor, absolute, in units */
  Quantizer(int level, const double* origin, double largest)
  : scale_(std::ldexp(1.0, offset_bits - level))
  , fits_(largest < (1 << 30) && std::abs(level) < 100)
  , origin_(origin)
  {}

  HWY_INLINE hn::VFromD<Words>
  operator()(hn::VFromD<Floats> v, std::size_t axis) const
  {
    const Floats d;
    if (HWY_LIKELY(fits_)) {
      const auto origin = hn::Set(Ints(), static_cast<std::int32_t>(origin_[axis]));
      const auto units = nearestInt(hn::Mul(v, hn::Set(d, static_cast<float>(scale_))));
      return hn::BitCast(Words(), hn::Sub(units, origin));
    }
    const hn::Half<Floats> h;
    const auto low = quantize(hn::LowerHalf(h, v), axis);
    const auto high = quantize(hn::UpperHalf(h, v), axis);
    return hn::BitCast(Words(), hn::Combine(Ints(), high, low));
  }

private:
  template <class V>
  HWY_INLINE hn::VFromD<hn::Half<Ints>>
  quantize(V v, std::size_t axis) const
  {
    const hn::Rebind<double, hn::Half<Floats>> d;
    const auto units = hn::Round(hn::Mul(hn::PromoteTo(d, v), hn::Set(d, scale_)));
    return hn::DemoteTo(hn::Half<Ints>(), hn::Sub(units, hn::Set(d, origin_[axis])));
  }

  double scale_;
  bool fits_;
  const double* origin_;
};

/** \brief Writes both halves of the 64-bit products of two vectors of words. */
HWY_INLINE void
storeProduct(hn::VFromD<Words> a,
             hn::VFromD<Words> b,
             std::uint32_t* low,
             std::uint32_t* high)
{
  const Words w;
  const Longs l;
  const auto odd = [&](auto v) {
    return hn::BitCast(w, hn::ShiftRight<32>(hn::BitCast(l, v)));
  };
  const auto even_product = hn::MulEven(a, b);
  const auto odd_product = hn::MulEven(odd(a), odd(b));
  const auto mask = hn::Set(l, (std::uint64_t{1} << half_bits) - 1);
  const auto interleave = [&](auto even, auto odd_lanes) {
    return hn::BitCast(w, hn::Or(even, hn::ShiftLeft<32>(odd_lanes)));
  };
  hn::Store(
      interleave(hn::And(even_product, mask), hn::And(odd_product, mask)), w, low);
  hn::Store(interleave(hn::And(hn::ShiftRight<half_bits>(even_product),
                               hn::Set(l, 0xffffffffu)),
                       hn::ShiftRight<half_bits>(odd_product)),
            w,
            high);
}

constexpr std::size_t moments_stride = slot_stride<moment_count>;

/** \brief Where a candidate's moment is, from where its x is. */
constexpr std::size_t
momentAt(std::size_t moment)
{
  return (slot_common + moment) * block_size;
}

/** \brief Writes the moments of a vector of points into their slot. */
HWY_INLINE void
stageMoments(const Quantizer& quantizer, const Points& points, float* slot)
{
  const Words w;
  const auto x = quantizer(points.x, 0);
  const auto y = quantizer(points.y, 1);
  const auto z = quantizer(points.z, 2);
  auto* words = reinterpret_cast<std::uint32_t*>(slot);
  const auto at = [&](std::size_t moment) { return words + momentAt(moment); };
  hn::Store(x, w, at(sum_x));
  hn::Store(y, w, at(sum_y));
  hn::Store(z, w, at(sum_z));
  storeProduct(x, x, at(low_xx), at(high_xx));
  storeProduct(x, y, at(low_xy), at(high_xy));
  storeProduct(x, z, at(low_xz), at(high_xz));
  storeProduct(y, y, at(low_yy), at(high_yy));
  storeProduct(y, z, at(low_yz), at(high_yz));
  storeProduct(z, z, at(low_zz), at(high_zz));
}

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
