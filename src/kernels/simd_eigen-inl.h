/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#if defined(PCL_SHAPE_SIMD_EIGEN_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PCL_SHAPE_SIMD_EIGEN_INL_H_
#undef PCL_SHAPE_SIMD_EIGEN_INL_H_
#else
#define PCL_SHAPE_SIMD_EIGEN_INL_H_
#endif

#include "moments.h"
#include "simd_common-inl.h"
#include "symmetric_eigen.h"

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

using DoubleV = hn::VFromD<Doubles>;

/** \brief Symmetric matrices, one a lane, scaled to trace 1, and their characteristic
 * polynomials l^3 - l^2 + c1 l - c0. */
struct MatrixLanes {
  DoubleV xx, xy, xz, yy, yz, zz, c1, c0;
};

HWY_INLINE MatrixLanes
scaledToTraceOne(const BlockCovariances& m, std::size_t first)
{
  const Doubles d;
  const auto load = [&](const double* values) { return hn::Load(d, values + first); };
  const auto trace = hn::Add(hn::Add(load(m.xx), load(m.yy)), load(m.zz));
  const auto scale = hn::Div(hn::Set(d, 1.0), trace);
  const auto xx = hn::Mul(load(m.xx), scale), xy = hn::Mul(load(m.xy), scale),
             xz = hn::Mul(load(m.xz), scale), yy = hn::Mul(load(m.yy), scale),
             yz = hn::Mul(load(m.yz), scale), zz = hn::Mul(load(m.zz), scale);
  const auto minor = [](auto a, auto b, auto c, auto e) {
    return hn::NegMulAdd(c, e, hn::Mul(a, b));
  };
  const auto x_minor = minor(yy, zz, yz, yz);
  const auto c1 =
      hn::Add(hn::Add(minor(xx, yy, xy, xy), minor(xx, zz, xz, xz)), x_minor);
  const auto xy_term = hn::Mul(xy, minor(xy, zz, yz, xz));
  const auto xz_term = hn::Mul(xz, minor(xy, yz, yy, xz));
  const auto c0 = hn::Add(hn::MulSub(xx, x_minor, xy_term), xz_term);
  return {xx, xy, xz, yy, yz, zz, c1, c0};
}

/** \brief The smallest roots of l^3 - l^2 + c1 l - c0 by Newton's method from 0, from
 * where it climbs to them. Each stops by itself, whatever the others do; all vectors of
 * them take their steps in turn, as each waits for its divisions. */
HWY_INLINE void
findSmallestRoots(const double* c1, const double* c0, std::size_t size, double* roots)
{
  const Doubles d;
  constexpr int most_steps = 64;
  const auto least_climb = hn::Set(d, 1e-15);
  HWY_ALIGN double moving[block_size];
  std::fill_n(moving, block_size, 1.0);
  std::fill_n(roots, block_size, 0.0);
  bool any_moves = true;
  for (int step = 0; step < most_steps && any_moves; ++step) {
    any_moves = false;
    for (std::size_t i = 0; i < size; i += double_lanes) {
      const auto root = hn::Load(d, roots + i), linear = hn::Load(d, c1 + i);
      const auto shifted = hn::Sub(root, hn::Set(d, 1.0));
      const auto value =
          hn::MulSub(hn::MulAdd(shifted, root, linear), root, hn::Load(d, c0 + i));
      const auto twice = hn::MulSub(hn::Set(d, 3.0), root, hn::Set(d, 2.0));
      const auto slope = hn::MulAdd(twice, root, linear);
      const auto climb = hn::Neg(hn::Div(value, slope));
      const auto climbs =
          hn::And(hn::Gt(climb, least_climb), hn::Gt(slope, hn::Zero(d)));
      const auto moves = hn::And(hn::Gt(hn::Load(d, moving + i), hn::Zero(d)), climbs);
      hn::Store(hn::IfThenElseZero(moves, hn::Set(d, 1.0)), d, moving + i);
      hn::Store(hn::Add(root, hn::IfThenElseZero(moves, climb)), d, roots + i);
      any_moves = any_moves || !hn::AllFalse(d, moves);
    }
  }
}

/** \brief Whether a root is the smallest one, with no other close to it. At a multiple
 * root the slope and the value are both rounding, and a step may go anywhere; the
 * smallest is at most a third of the trace, and up to there the slope is positive
 * before the first extremum only. */
HWY_INLINE MaskOf<Doubles>
isSimple(DoubleV root, DoubleV c1)
{
  const Doubles d;
  constexpr double least_slope = 1e-5;
  const auto twice = hn::MulSub(hn::Set(d, 3.0), root, hn::Set(d, 2.0));
  const auto slope = hn::MulAdd(twice, root, c1);
  return hn::And(hn::Gt(slope, hn::Set(d, least_slope)),
                 hn::Lt(root, hn::Set(d, 1.0 / 3.0)));
}

/** \brief Vectors, one a lane. */
struct VectorLanes {
  DoubleV x, y, z, squared_length;
};

HWY_INLINE VectorLanes
vectorLanes(DoubleV x, DoubleV y, DoubleV z)
{
  return {x, y, z, hn::MulAdd(x, x, hn::MulAdd(y, y, hn::Mul(z, z)))};
}

HWY_INLINE VectorLanes
longer(const VectorLanes& a, const VectorLanes& b)
{
  const auto is_b = hn::Gt(b.squared_length, a.squared_length);
  return {hn::IfThenElse(is_b, b.x, a.x),
          hn::IfThenElse(is_b, b.y, a.y),
          hn::IfThenElse(is_b, b.z, a.z),
          hn::IfThenElse(is_b, b.squared_length, a.squared_length)};
}

/** \brief The longest cross product of two rows of M - l I. */
HWY_INLINE VectorLanes
eigenvectors(const MatrixLanes& m, DoubleV root)
{
  const auto xx = hn::Sub(m.xx, root), yy = hn::Sub(m.yy, root),
             zz = hn::Sub(m.zz, root);
  const auto minor = [](auto a, auto b, auto c, auto e) {
    return hn::NegMulAdd(c, e, hn::Mul(a, b));
  };
  const auto first = vectorLanes(minor(m.xy, m.yz, m.xz, yy),
                                 minor(m.xz, m.xy, xx, m.yz),
                                 minor(xx, yy, m.xy, m.xy));
  const auto second = vectorLanes(minor(m.xy, zz, m.xz, m.yz),
                                  minor(m.xz, m.xz, xx, zz),
                                  minor(xx, m.yz, m.xy, m.xz));
  const auto third = vectorLanes(minor(yy, zz, m.yz, m.yz),
                                 minor(m.yz, m.xz, m.xy, zz),
                                 minor(m.xy, m.yz, yy, m.xz));
  return longer(longer(first, second), third);
}

/** \brief As normalOfCovariance(), for all queries at once. */
HWY_INLINE void
normalsOfCovariances(const BlockCovariances& covariances,
                     std::size_t size,
                     NormalResult* results)
{
  const Doubles d;
  HWY_ALIGN double x[block_size], y[block_size], z[block_size], roots[block_size];
  HWY_ALIGN double safe[block_size];
  HWY_ALIGN double c1[block_size], c0[block_size];
  for (std::size_t i = 0; i < size; i += double_lanes) {
    const auto m = scaledToTraceOne(covariances, i);
    hn::Store(m.c1, d, c1 + i);
    hn::Store(m.c0, d, c0 + i);
  }
  findSmallestRoots(c1, c0, size, roots);
  for (std::size_t i = 0; i < size; i += double_lanes) {
    const auto m = scaledToTraceOne(covariances, i);
    const auto root = hn::Load(d, roots + i);
    const auto v = eigenvectors(m, root);
    const auto scale = hn::Div(hn::Set(d, 1.0), hn::Sqrt(v.squared_length));
    hn::Store(hn::Mul(v.x, scale), d, x + i);
    hn::Store(hn::Mul(v.y, scale), d, y + i);
    hn::Store(hn::Mul(v.z, scale), d, z + i);
    // The other two roots have the sum s and the product q; q <= ratio s^2 on a line.
    const auto s = hn::Sub(hn::Set(d, 1.0), root);
    const auto q = hn::NegMulAdd(root, s, m.c1);
    const auto is_safe =
        hn::And(hn::Gt(v.squared_length, hn::Set(d, 1e-16)),
                hn::Gt(q, hn::Mul(hn::Set(d, 4.0 * line_ratio), hn::Mul(s, s))));
    const auto is_simple = isSimple(root, m.c1);
    hn::Store(
        hn::IfThenElseZero(hn::And(is_safe, is_simple), hn::Set(d, 1.0)), d, safe + i);
  }
  for (std::size_t i = 0; i < size; ++i) {
    results[i] = safe[i] != 0.0 ? NormalResult{static_cast<float>(x[i]),
                                               static_cast<float>(y[i]),
                                               static_cast<float>(z[i]),
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
