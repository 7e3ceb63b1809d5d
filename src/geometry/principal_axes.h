// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Principal axes of scattered vectors, and the plane nearest to some points.

#pragma once

#include "geometry/scatter.h"

#include <Eigen/Eigenvalues>

#include <cmath>
#include <cstddef>
#include <type_traits>

namespace pcl::segmentation {

/** \brief An eigenvector of a sum of products v * v^T: of the smallest (0) to the
 * largest (2) eigenvalue. In float by the closed form, which is fast enough for one at
 * each point; in double by iteration, which is exact. */
template <typename Scalar>
Eigen::Matrix<Scalar, 3, 1>
principalAxis(const Eigen::Matrix<Scalar, 3, 3>& scatter, int which)
{
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix<Scalar, 3, 3>> solver;
  if constexpr (std::is_same_v<Scalar, float>)
    solver.computeDirect(scatter);
  else
    solver.compute(scatter);
  return solver.eigenvectors().col(which);
}

template <typename Scalar>
struct Plane {
  using Vector = Eigen::Matrix<Scalar, 3, 1>;

  Scalar
  distance(const Vector& point) const
  {
    return std::abs(normal.dot(point - center));
  }

  Vector center = Vector::Zero(); ///< the mean of the points
  Vector normal = Vector::Zero(); ///< unit, of either sign
};

/** \brief The plane nearest to some points, by least squares.
 * \param[in] forEach forEach(visit) calls visit(point) for each point */
template <typename Scalar, typename ForEach>
Plane<Scalar>
fitPlane(const ForEach& forEach)
{
  using Vector = Eigen::Matrix<Scalar, 3, 1>;
  Plane<Scalar> plane;
  std::size_t count = 0;
  forEach([&](const Vector& point) {
    plane.center += point;
    ++count;
  });
  plane.center /= static_cast<Scalar>(count);
  Scatter<Scalar> scatter;
  forEach([&](const Vector& point) { scatter.add(point - plane.center); });
  plane.normal = principalAxis(scatter.matrix(), 0);
  return plane;
}

} // namespace pcl::segmentation
