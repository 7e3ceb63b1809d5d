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
namespace pcl {
namespace kernels {
namespace HWY_NAMESPACE {

/** Neighborhoods up to this size have moments that fit in 63 bits. */
constexpr std::uint64_t most_for_63_bits = std::uint64_t{1} << 18;

__extension__ using SignedWide = __int128;

/** \brief sum (a - a0) (b - b0) from sums about 0, exactly. */
template <typename Integer>
double
aboutQuery(const BlockMoments& m,
           std::size_t i,
           std::size_t product,
           std::size_t a,
           std::size_t b)
{
  const auto a0 = static_cast<Integer>(m.own[a][i]);
  const auto b0 = static_cast<Integer>(m.own[b][i]);
  const auto low = static_cast<Integer>(m.values[low_xx + product][i]);
  const auto high = static_cast<Integer>(m.values[high_xx + product][i]);
  const auto sum_a = static_cast<Integer>(m.values[a][i]);
  const auto sum_b = static_cast<Integer>(m.values[b][i]);
  const auto n = static_cast<Integer>(m.count[i]);
  constexpr auto half = static_cast<Integer>(1) << half_bits;
  return static_cast<double>(high * half + low - a0 * sum_b - b0 * sum_a + n * a0 * b0);
}

inline void
centerMoments(const BlockMoments& m, std::size_t i, BlockCovariances& covariances)
{
  const auto n = static_cast<double>(m.count[i]);
  const auto offset = [&](std::size_t a) {
    const auto a0 = static_cast<std::int64_t>(m.own[a][i]);
    const auto count = static_cast<std::int64_t>(m.count[i]);
    return static_cast<double>(static_cast<std::int64_t>(m.values[a][i]) - count * a0);
  };
  const double x = offset(0), y = offset(1), z = offset(2);
  const auto central =
      [&](std::size_t product, std::size_t a, std::size_t b, double ab) {
        const double about = m.count[i] <= most_for_63_bits
                                 ? aboutQuery<std::int64_t>(m, i, product, a, b)
                                 : aboutQuery<SignedWide>(m, i, product, a, b);
        return (about - ab / n) / n;
      };
  covariances.xx[i] = central(0, 0, 0, x * x);
  covariances.xy[i] = central(1, 0, 1, x * y);
  covariances.xz[i] = central(2, 0, 2, x * z);
  covariances.yy[i] = central(3, 1, 1, y * y);
  covariances.yz[i] = central(4, 1, 2, y * z);
  covariances.zz[i] = central(5, 2, 2, z * z);
}

/** \brief Coefficients of the characteristic polynomial l^3 - l^2 + c1 l - c0 of
 * matrices scaled to trace 1. */
struct Characteristic {
  double c1[block_size], c0[block_size];
};

inline void
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
inline void
smallestRoots(const Characteristic& p, double* roots)
{
  double moving[block_size];
  std::fill_n(roots, block_size, 0.0);
  std::fill_n(moving, block_size, 1.0);
  constexpr int most_steps = 64;
  for (int step = 0; step < most_steps; ++step) {
    double any = 0.0;
    for (std::size_t i = 0; i < block_size; ++i) {
      const double l = roots[i];
      const double value = ((l - 1.0) * l + p.c1[i]) * l - p.c0[i];
      const double slope = (3.0 * l - 2.0) * l + p.c1[i];
      const double climb = -value / slope;
      const bool goes_on = moving[i] > 0.0 && climb > 1e-15 && slope > 0.0;
      roots[i] = goes_on ? l + climb : l;
      moving[i] = goes_on ? 1.0 : 0.0;
      any += moving[i];
    }
    if (any == 0.0) {
      return;
    }
  }
}

/** \brief The longest cross product of two rows of M - l I, and whether that is a safe
 * eigenvector: long enough, and the points not on a line. */
inline void
eigenvectors(const BlockCovariances& m,
             const Characteristic& p,
             const double* roots,
             NormalResult* results,
             bool* safe)
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
    const bool b_wins = b2 > a2;
    const double d2 = b_wins ? b2 : a2;
    const double dx = b_wins ? bx : ax, dy = b_wins ? by : ay, dz = b_wins ? bz : az;
    const bool c_wins = c2 > d2;
    const double e2 = c_wins ? c2 : d2;
    const double scale = 1.0 / std::sqrt(e2);
    results[i].x = static_cast<float>((c_wins ? cx : dx) * scale);
    results[i].y = static_cast<float>((c_wins ? cy : dy) * scale);
    results[i].z = static_cast<float>((c_wins ? cz : dz) * scale);
    results[i].curvature = static_cast<float>(l);
    // The other two roots have the sum s and the product q; q <= ratio s^2 on a line.
    const double s = 1.0 - l;
    const double q = p.c1[i] - l * s;
    safe[i] = e2 > 1e-16 && q > 4.0 * line_ratio * s * s;
  }
}

inline void
normalsOfCovariances(const BlockCovariances& covariances,
                     std::size_t size,
                     NormalResult* results)
{
  BlockCovariances m = covariances;
  Characteristic p;
  double roots[block_size];
  NormalResult all[block_size];
  bool safe[block_size];
  scaleToTraceOne(m, p);
  smallestRoots(p, roots);
  eigenvectors(m, p, roots, all, safe);
  for (std::size_t i = 0; i < size; ++i) {
    results[i] = safe[i] ? all[i]
                         : normalOfCovariance({covariances.xx[i],
                                               covariances.xy[i],
                                               covariances.xz[i],
                                               covariances.yy[i],
                                               covariances.yz[i],
                                               covariances.zz[i]});
  }
}

} // namespace HWY_NAMESPACE
} // namespace kernels
} // namespace pcl
HWY_AFTER_NAMESPACE();

#endif
