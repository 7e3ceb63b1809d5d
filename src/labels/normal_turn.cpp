// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A linear fit to normals.

#include "labels/normal_turn.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl::segmentation {

NormalTurn::NormalTurn(const Eigen::Vector3f& normal) : normal_(normal.cast<double>())
{
  const Eigen::Vector3d u = normal_.unitOrthogonal();
  axes_.row(0) = u;
  axes_.row(1) = normal_.cross(u);
}

void
NormalTurn::add(const Eigen::Vector3f& offset, const Eigen::Vector3f& normal)
{
  const Eigen::Vector3d other = normal.cast<double>();
  const Eigen::Vector2d tilt = axes_ * (other.dot(normal_) < 0.0 ? -other : other);
  const Eigen::Vector2d across = axes_ * offset.cast<double>();
  const Eigen::Vector3d place(1.0, across.x(), across.y());
  places_ += place * place.transpose();
  products_ += place * tilt.transpose();
  squares_ += tilt.squaredNorm();
  count_ += 1.0;
}

float
NormalTurn::rest() const
{
  constexpr double unknowns = 3.0;
  constexpr double ridge = 1e-6; // keeps points on a line solvable
  if (count_ < unknowns)
    return 0.0f;
  const Eigen::Matrix3d places = places_ + ridge * Eigen::Matrix3d::Identity();
  const Eigen::Matrix<double, 3, 2> fit = places.ldlt().solve(products_);
  const double left = squares_ - fit.cwiseProduct(products_).sum();
  return static_cast<float>(std::sqrt(std::max(0.0, left) / count_));
}

} // namespace pcl::segmentation
