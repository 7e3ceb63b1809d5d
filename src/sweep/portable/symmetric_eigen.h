// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The normal that a covariance matrix has.

#pragma once

#include "sweep/sweep_block.h"

namespace pcl::kernels {

/** \brief A symmetric 3 x 3 matrix. */
struct Symmetric3 {
  double xx, xy, xz, yy, yz, zz;
};

/** \brief A covariance whose second eigenvalue is at most this fraction of the largest
 * has its points on a line (or in one place), and no normal: a rod a thousand times as
 * long as it is thick. Float coordinates cannot tell much thinner ones from a line. */
constexpr double line_ratio = 1e-6;

/** \brief Normal and curvature of a covariance matrix: the unit eigenvector of its
 * smallest eigenvalue, and that eigenvalue over the trace. NaN for points on a line. */
NormalResult normalOfCovariance(const Symmetric3& covariance);

} // namespace pcl::kernels
