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
#include "symmetric_eigen.h"

#include <hwy/highway.h>

#include <algorithm>
#include <cmath>

// Plain loops over the queries of a block: the compiler makes them vectors of the
// target.
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
    const auto about = static_cast<double>(
        aboutQuery<std::int64_t>(high, low, a0, b0, sum_a, sum_b, n));
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
  for (std::size_t p = 0; p < 6; ++p) {
    centerProduct(m, p, first[p], second[p], products[p]);
    for (std::size_t i = 0; i < block_size; ++i) {
      if (HWY_UNLIKELY(m.count[i] > most_for_63_bits)) {
        centerLargeProduct(m, i, p, first[p], second[p], products[p]);
      }
    }
  }
}

/** \brief Coefficients of the characteristic polynomial l^3 - l^2 + c1 l - c0 of
 * matrices scaled to trace 1. */
struct Characteristic {
  double c1[block_size], c0[block_size];
};

HWY_INLINE void
scaleToTraceOne(BlockCovariances& m, Characteristic& p)
{
  for (std::size_t i = 0; i < block_size; ++i) {
    const double s = 1.0 / (m.xx[i] + m.yy[i] + m.zz[i]);
    const double xx = m.xx[i] * s, xy = m.xy[i] * s, xz = m.xz[i] * s;
    const double yy = m.yy[i] * s, yz = m.yz[i] * s, zz = m.zz[i] * s;
    p.c1[i] = (xx * yy - xy * xy) + (xx * zz - xz * xz) + (yy * zz - yz * yz);
    p.c0[i] =
        xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
    m.xx[i] = xx, m.xy[i] = xy, m.xz[i] = xz;
    m.yy[i] = yy, m.yz[i] = yz, m.zz[i] = zz;
  }
}

/** \brief The smallest roots by Newton's method from 0, from where it climbs to them.
 * Each stops by itself, whatever the others do. */
HWY_INLINE void
smallestRoots(const Characteristic& p, double* roots)
{
  std::int64_t moving[block_size];
  std::fill_n(roots, block_size, 0.0);
  std::fill_n(moving, block_size, 1);
  constexpr int most_steps = 64;
  for (int step = 0; step < most_steps; ++step) {
    std::int64_t any = 0;
    for (std::size_t i = 0; i < block_size; ++i) {
      const double l = roots[i];
      const double value = ((l - 1.0) * l + p.c1[i]) * l - p.c0[i];
      const double slope = (3.0 * l - 2.0) * l + p.c1[i];
      const double climb = -value / slope;
      const std::int64_t climbs = climb > 1e-15 ? moving[i] : 0;
      const std::int64_t goes_on = slope > 0.0 ? climbs : 0;
      roots[i] = l + (goes_on != 0 ? climb : 0.0);
      moving[i] = goes_on;
      any |= goes_on;
    }
    if (any == 0) {
      return;
    }
  }
}

/** \brief Eigenvectors, and how long their cross product and the product of the other
 * two roots are: whether the result is safe. */
struct Eigenvectors {
  double x[block_size], y[block_size], z[block_size];
  double squared_length[block_size], other_roots[block_size];
};

/** \brief The longest cross product of two rows of M - l I. */
HWY_INLINE void
eigenvectors(const BlockCovariances& m,
             const Characteristic& p,
             const double* roots,
             Eigenvectors& vectors)
{
  for (std::size_t i = 0; i < block_size; ++i) {
    const double l = roots[i];
    const double xx = m.xx[i] - l, yy = m.yy[i] - l, zz = m.zz[i] - l;
    const double xy = m.xy[i], xz = m.xz[i], yz = m.yz[i];
    const double ax = xy * yz - xz * yy, ay = xz * xy - xx * yz, az = xx * yy - xy * xy;
    const double bx = xy * zz - xz * yz, by = xz * xz - xx * zz, bz = xx * yz - xy * xz;
    const double cx = yy * zz - yz * yz, cy = yz * xz - xy * zz, cz = xy * yz - yy * xz;
    const double a2 = ax * ax + ay * ay + az * az;
    const double b2 = bx * bx + by * by + bz * bz;
    const double c2 = cx * cx + cy * cy + cz * cz;
    const double d2 = b2 > a2 ? b2 : a2;
    const double dx = b2 > a2 ? bx : ax, dy = b2 > a2 ? by : ay, dz = b2 > a2 ? bz : az;
    const double e2 = c2 > d2 ? c2 : d2;
    const double scale = 1.0 / std::sqrt(e2);
    vectors.x[i] = (c2 > d2 ? cx : dx) * scale;
    vectors.y[i] = (c2 > d2 ? cy : dy) * scale;
    vectors.z[i] = (c2 > d2 ? cz : dz) * scale;
    vectors.squared_length[i] = e2;
    vectors.other_roots[i] = p.c1[i] - l * (1.0 - l);
  }
}

/** \brief As normalOfCovariance(), for all queries at once. */
HWY_INLINE void
normalsOfCovariances(const BlockCovariances& covariances,
                     std::size_t size,
                     NormalResult* results)
{
  BlockCovariances m = covariances;
  Characteristic p;
  double roots[block_size];
  Eigenvectors v;
  scaleToTraceOne(m, p);
  smallestRoots(p, roots);
  eigenvectors(m, p, roots, v);
  for (std::size_t i = 0; i < size; ++i) {
    // The other two roots have the sum s and the product q; q <= ratio s^2 on a line.
    const double s = 1.0 - roots[i];
    const bool is_safe =
        v.squared_length[i] > 1e-16 && v.other_roots[i] > 4.0 * line_ratio * s * s;
    results[i] = is_safe ? NormalResult{static_cast<float>(v.x[i]),
                                        static_cast<float>(v.y[i]),
                                        static_cast<float>(v.z[i]),
                                        static_cast<float>(roots[i])}
                         : normalOfCovariance({covariances.xx[i],
                                               covariances.xy[i],
                                               covariances.xz[i],
                                               covariances.yy[i],
                                               covariances.yz[i],
                                               covariances.zz[i]});
  }
}

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
