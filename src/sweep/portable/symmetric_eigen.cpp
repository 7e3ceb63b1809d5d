// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The normal that a covariance matrix has: eigenvalues in closed form, then a vector.

#include "sweep/portable/symmetric_eigen.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl::kernels {
namespace {

using Vector = std::array<double, 3>;

Vector
cross(const Vector& a, const Vector& b)
{
  return {
      a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double
squaredNorm(const Vector& a)
{
  return a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
}

const Vector&
longest(const std::array<Vector, 3>& vectors)
{
  return *std::max_element(
      vectors.begin(), vectors.end(), [](const Vector& a, const Vector& b) {
        return squaredNorm(a) < squaredNorm(b);
      });
}

/** \brief Eigenvalues in ascending order, by the trigonometric solution of the cubic
 * (O. K. Smith, Communications of the ACM 4(4), 1961). */
Vector
eigenvalues(const Symmetric3& m)
{
  const double mean = (m.xx + m.yy + m.zz) / 3.0;
  const double xx = m.xx - mean, yy = m.yy - mean, zz = m.zz - mean;
  const double off = m.xy * m.xy + m.xz * m.xz + m.yz * m.yz;
  const double p = std::sqrt((xx * xx + yy * yy + zz * zz + 2.0 * off) / 6.0);
  if (p == 0.0)
    return {mean, mean, mean};
  const double determinant = xx * (yy * zz - m.yz * m.yz) -
                             m.xy * (m.xy * zz - m.yz * m.xz) +
                             m.xz * (m.xy * m.yz - yy * m.xz);
  const double angle =
      std::acos(std::clamp(determinant / (2.0 * p * p * p), -1.0, 1.0)) / 3.0;
  constexpr double third_turn = 2.0943951023931953;
  const double largest = mean + 2.0 * p * std::cos(angle);
  const double smallest = mean + 2.0 * p * std::cos(angle + third_turn);
  return {smallest, 3.0 * mean - largest - smallest, largest};
}

/** \brief The direction that the matrix (of rank 2 or less) maps to 0. */
Vector
kernelDirection(const std::array<Vector, 3>& rows)
{
  const Vector normal = longest(
      {cross(rows[0], rows[1]), cross(rows[0], rows[2]), cross(rows[1], rows[2])});
  const Vector& row = longest(rows);
  const double scale = squaredNorm(row);
  if (squaredNorm(normal) > 1e-24 * scale * scale)
    return normal;
  if (scale == 0.0)
    return {0.0, 0.0, 1.0};
  return longest({cross(row, {1, 0, 0}), cross(row, {0, 1, 0}), cross(row, {0, 0, 1})});
}

} // namespace

NormalResult
normalOfCovariance(const Symmetric3& covariance)
{
  const double trace = covariance.xx + covariance.yy + covariance.zz;
  if (!(trace > 0.0) || !std::isfinite(trace))
    return unknown_normal;
  const double s = 1.0 / trace;
  const Symmetric3 m{covariance.xx * s,
                     covariance.xy * s,
                     covariance.xz * s,
                     covariance.yy * s,
                     covariance.yz * s,
                     covariance.zz * s};
  const Vector values = eigenvalues(m);
  if (!(values[1] > line_ratio * values[2]))
    return unknown_normal;
  const double l = values[0];
  const Vector v = kernelDirection(
      {{{m.xx - l, m.xy, m.xz}, {m.xy, m.yy - l, m.yz}, {m.xz, m.yz, m.zz - l}}});
  const double scale = 1.0 / std::sqrt(squaredNorm(v));
  return {static_cast<float>(v[0] * scale),
          static_cast<float>(v[1] * scale),
          static_cast<float>(v[2] * scale),
          static_cast<float>(std::max(0.0, l))};
}

} // namespace pcl::kernels
