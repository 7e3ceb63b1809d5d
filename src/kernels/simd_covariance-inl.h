/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#if defined(PCL_SHAPE_SIMD_COVARIANCE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PCL_SHAPE_SIMD_COVARIANCE_INL_H_
#undef PCL_SHAPE_SIMD_COVARIANCE_INL_H_
#else
#define PCL_SHAPE_SIMD_COVARIANCE_INL_H_
#endif

#include "moments.h"
#include "simd_common-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

/** Neighborhoods up to this size have moments that fit in 63 bits. */
constexpr std::uint64_t most_for_63_bits = std::uint64_t{1} << 18;

/** \brief sum (a - a0) (b - b0) from sums about 0, exactly. */
template <typename Integer>
HWY_INLINE Integer
aboutQuery(Integer high,
           Integer low,
           Integer a0,
           Integer b0,
           Integer sum_a,
           Integer sum_b,
           Integer n)
{
  constexpr auto half = static_cast<Integer>(1) << half_bits;
  return high * half + low - a0 * (sum_b - n * b0) - b0 * sum_a;
}

/** Neighborhoods up to this size have moments, and terms of aboutQuery(), below 2^53:
 * doubles hold them exactly. */
constexpr std::uint64_t most_for_doubles = 256;

/** \brief The central second moments of one product of some queries with few neighbors.
 */
HWY_INLINE void
centerProductOfFew(const BlockMoments& m,
                   std::size_t i,
                   std::size_t product,
                   std::size_t a,
                   std::size_t b,
                   double* covariances)
{
  const Doubles d;
  const auto n = toDoubles(m.count + i);
  const auto inverse = hn::Div(hn::Set(d, 1.0), n);
  const auto a0 = hn::Load(d, m.own[a] + i), b0 = hn::Load(d, m.own[b] + i);
  const auto sum_a = toDoubles(m.values[a] + i), sum_b = toDoubles(m.values[b] + i);
  const auto all = hn::MulAdd(toDoubles(m.values[high_xx + product] + i),
                              hn::Set(d, static_cast<double>(1 << half_bits)),
                              toDoubles(m.values[low_xx + product] + i));
  const auto y = hn::NegMulAdd(n, b0, sum_b);
  const auto x = hn::NegMulAdd(n, a0, sum_a);
  const auto about = hn::NegMulAdd(b0, sum_a, hn::NegMulAdd(a0, y, all));
  const auto central = hn::Sub(about, hn::Mul(hn::Mul(x, y), inverse));
  hn::Store(hn::Mul(central, inverse), d, covariances + i);
}

/** \brief The central second moments of one product, of all queries. */
HWY_INLINE void
centerProduct(const BlockMoments& m,
              std::size_t product,
              std::size_t a,
              std::size_t b,
              double* covariances)
{
  for (std::size_t i = 0; i < block_size; ++i) {
    const auto n = static_cast<std::int64_t>(m.count[i]);
    const auto a0 = static_cast<std::int64_t>(m.own[a][i]);
    const auto b0 = static_cast<std::int64_t>(m.own[b][i]);
    const auto sum_a = static_cast<std::int64_t>(m.values[a][i]);
    const auto sum_b = static_cast<std::int64_t>(m.values[b][i]);
    const auto high = static_cast<std::int64_t>(m.values[high_xx + product][i]);
    const auto low = static_cast<std::int64_t>(m.values[low_xx + product][i]);
    // Unsigned: of neighborhoods that are too large, whose result is not used, it
    // wraps.
    const auto word = [](std::int64_t v) { return static_cast<std::uint64_t>(v); };
    const auto about = static_cast<
        double>(static_cast<std::int64_t>(aboutQuery<std::uint64_t>(
        word(high), word(low), word(a0), word(b0), word(sum_a), word(sum_b), word(n))));
    const double inverse = 1.0 / static_cast<double>(n);
    const auto x = static_cast<double>(sum_a - n * a0);
    const auto y = static_cast<double>(sum_b - n * b0);
    covariances[i] = (about - x * y * inverse) * inverse;
  }
}

/** \brief The same for a neighborhood that is too large for 63 bits. */
HWY_INLINE void
centerLargeProduct(const BlockMoments& m,
                   std::size_t i,
                   std::size_t product,
                   std::size_t a,
                   std::size_t b,
                   double* covariances)
{
  __extension__ using SignedWide = __int128;
  const SignedWide n = m.count[i], sum_a = m.values[a][i], sum_b = m.values[b][i];
  const auto a0 = static_cast<SignedWide>(m.own[a][i]);
  const auto b0 = static_cast<SignedWide>(m.own[b][i]);
  const auto about =
      static_cast<double>(aboutQuery<SignedWide>(m.values[high_xx + product][i],
                                                 m.values[low_xx + product][i],
                                                 a0,
                                                 b0,
                                                 sum_a,
                                                 sum_b,
                                                 n));
  const double inverse = 1.0 / static_cast<double>(n);
  const auto x = static_cast<double>(sum_a - n * a0);
  const auto y = static_cast<double>(sum_b - n * b0);
  covariances[i] = (about - x * y * inverse) * inverse;
}

/** \brief Central second moments of the neighbors, from exact sums. */
HWY_INLINE void
centerMoments(const BlockMoments& m, BlockCovariances& c)
{
  const std::size_t first[] = {0, 0, 0, 1, 1, 2};
  const std::size_t second[] = {0, 1, 2, 1, 2, 2};
  double* const products[] = {c.xx, c.xy, c.xz, c.yy, c.yz, c.zz};
  const std::uint64_t largest = *std::max_element(m.count, m.count + block_size);
  for (std::size_t p = 0; p < 6; ++p) {
    if (HWY_LIKELY(largest <= most_for_doubles)) {
      for (std::size_t i = 0; i < block_size; i += double_lanes) {
        centerProductOfFew(m, i, p, first[p], second[p], products[p]);
      }
      continue;
    }
    centerProduct(m, p, first[p], second[p], products[p]);
    for (std::size_t i = 0; i < block_size; ++i) {
      if (HWY_UNLIKELY(m.count[i] > most_for_63_bits)) {
        centerLargeProduct(m, i, p, first[p], second[p], products[p]);
      }
    }
  }
}

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
