// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Sums of products of vectors with themselves.

#pragma once

#include <Eigen/Core>

namespace pcl::segmentation {

/** \brief A sum of v * v^T. Entries are added one by one: Eigen writes those of a
 * product to memory and reads them together again, for which processors wait. */
template <typename Scalar>
class Scatter {
public:
  using Vector = Eigen::Matrix<Scalar, 3, 1>;
  using Matrix = Eigen::Matrix<Scalar, 3, 3>;

  void
  add(const Vector& v)
  {
    xx_ += v.x() * v.x();
    xy_ += v.x() * v.y();
    xz_ += v.x() * v.z();
    yy_ += v.y() * v.y();
    yz_ += v.y() * v.z();
    zz_ += v.z() * v.z();
  }

  Matrix
  matrix() const
  {
    Matrix matrix;
    matrix << xx_, xy_, xz_, xy_, yy_, yz_, xz_, yz_, zz_;
    return matrix;
  }

private:
  Scalar xx_ = 0, xy_ = 0, xz_ = 0, yy_ = 0, yz_ = 0, zz_ = 0;
};

} // namespace pcl::segmentation
