// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// How normals turn over a face, and what is left of them that turns otherwise.

#pragma once

#include <Eigen/Core>

namespace pcl::segmentation {

/** \brief Fits normals that turn evenly, as on a smooth surface, to those around a
 * point. Noise, steps and creases leave a rest. Either sign of a normal will do. */
class NormalTurn {
public:
  /** \param[in] normal of the point, unit */
  explicit NormalTurn(const Eigen::Vector3f& normal);

  /** \param[in] offset from the point, in any unit \param[in] normal there, unit */
  void add(const Eigen::Vector3f& offset, const Eigen::Vector3f& normal);

  /** \brief The root mean square of what the fit leaves, in radians where it is small;
   * 0 for less points than the fit has unknowns. */
  float rest() const;

private:
  Eigen::Matrix<double, 2, 3> axes_; ///< across the normal
  Eigen::Vector3d normal_;
  Eigen::Matrix3d places_ = Eigen::Matrix3d::Zero(); ///< sums of products
  Eigen::Matrix<double, 3, 2> products_ = Eigen::Matrix<double, 3, 2>::Zero();
  double squares_ = 0.0;
  double count_ = 0.0;
};

} // namespace pcl::segmentation
