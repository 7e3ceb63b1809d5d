/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#if defined(PCL_SHAPE_SIMD_ORDERED_NORMALS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PCL_SHAPE_SIMD_ORDERED_NORMALS_INL_H_
#undef PCL_SHAPE_SIMD_ORDERED_NORMALS_INL_H_
#else
#define PCL_SHAPE_SIMD_ORDERED_NORMALS_INL_H_
#endif

#include "simd_eigen-inl.h"
#include "simd_ordered_moments-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

/** More points than these, and sums in float lose what normals need. */
constexpr float most_for_float = 1 << 12;

/** The product of a plane's two larger eigenvalues over the square of the mean squared
 * offset, which is what float sums are exact to some 1e-7 of: normals turn by less than
 * 2e-4 rad then, mostly by less than 1e-5. */
constexpr double least_plane_ratio = 1e-2;

/** \brief Whether squares of offsets, and sums of them, are far from the limits of
 * float. */
inline bool
suitsFloat(const SweepBlock& block)
{
  constexpr float least = 1e-24f, most = 1e24f;
  return block.rows_by_radius && block.tie_d2[0] < 0.0f && block.r2[0] > least &&
         block.r2[0] < most;
}

HWY_INLINE void
covariancesOf(const OrderedMoments& m, BlockCovariances& c)
{
  const Doubles d;
  const hn::Rebind<float, Doubles> floats;
  const std::size_t first[] = {sum_x, sum_x, sum_x, sum_y, sum_y, sum_z};
  const std::size_t second[] = {sum_x, sum_y, sum_z, sum_y, sum_z, sum_z};
  double* const products[] = {c.xx, c.xy, c.xz, c.yy, c.yz, c.zz};
  for (std::size_t i = 0; i < block_size; i += double_lanes) {
    const auto at = [&](std::size_t moment) {
      return hn::PromoteTo(d, hn::LoadU(floats, m.sums[moment] + i));
    };
    const auto n = hn::PromoteTo(d, hn::LoadU(floats, m.counts + i));
    const auto inverse = hn::Div(hn::Set(d, 1.0), hn::Max(hn::Set(d, 1.0), n));
    for (std::size_t p = 0; p < 6; ++p) {
      const auto product = hn::Mul(at(first[p]), at(second[p]));
      const auto central = hn::NegMulAdd(product, inverse, at(OrderedMoments::xx + p));
      hn::Store(hn::Mul(central, inverse), d, products[p] + i);
    }
  }
}

/** \brief Whether the sums say what the normal is: there are not too many, and what is
 * left of them about the mean is not of a line, or a point, or small beside them. */
inline bool
isPlain(const OrderedMoments& m, const BlockCovariances& c, std::size_t i)
{
  const double minors = c.xx[i] * c.yy[i] - c.xy[i] * c.xy[i] + c.xx[i] * c.zz[i] -
                        c.xz[i] * c.xz[i] + c.yy[i] * c.zz[i] - c.yz[i] * c.yz[i];
  const double squares = static_cast<double>(m.sums[OrderedMoments::xx][i]) +
                         m.sums[OrderedMoments::yy][i] + m.sums[OrderedMoments::zz][i];
  const double mean_square = squares / m.counts[i];
  return m.counts[i] <= most_for_float &&
         minors > least_plane_ratio * mean_square * mean_square;
}

/** \brief Normals from sums of floats, in the order of the rows and of the points in
 * them, which depends on the radius and on the neighbors alone.
 * \return whether all are known; is_known tells which */
HWY_INLINE bool
orderedNormals(const SweepBlock& block, NormalResult* results, bool* is_known)
{
  OrderedMoments moments;
  sumInOrder(block, moments);
  BlockCovariances covariances;
  covariancesOf(moments, covariances);
  normalsOfCovariances(covariances, block.size, results);
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  bool all_known = true;
  for (std::size_t i = 0; i < block.size; ++i) {
    const float count = moments.counts[i];
    const std::size_t own =
        block.queries_on_surface || (count > 0.0f && isAtSurfacePoint(block, i)) ? 1
                                                                                 : 0;
    const bool has_few =
        count < static_cast<float>(NeighborhoodSweep::min_neighbors + own);
    if (has_few) {
      results[i] = {nan, nan, nan, nan};
    }
    is_known[i] = has_few || isPlain(moments, covariances, i);
    all_known = all_known && is_known[i];
  }
  return all_known;
}

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
