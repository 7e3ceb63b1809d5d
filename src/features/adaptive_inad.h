// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Normals and INAD at radii that follow the density and the noise of a cloud.

#pragma once

#include "features/spacing/local_spacing.h"
#include "geometry/point_grid.h"

#include <Eigen/Core>

#include <vector>

namespace pcl::detail {

/** \brief A cloud, how its neighborhoods are found, and normals if they are given. */
struct FieldInput {
  const Neighborhoods& neighborhoods; ///< of all points of the cloud
  XYZView points;
  XYZView normals; ///< of size 0 to estimate them
  unsigned threads = 0;
  bool is_even = false; ///< the spacing changes slowly: it is taken as it is
  const CloudNumbers* of_cloud = nullptr; ///< of which the points are a part
};

/** \brief The median of the spacings, of the whole cloud. \param[in] spacings of the
 * points */
float spacingOfCloud(const FieldInput& input, const std::vector<float>& spacings);

/** \brief Normals and INAD; NaN unknown. */
struct AdaptiveINAD {
  std::vector<Eigen::Vector3f> normals; ///< unit, towards the origin
  std::vector<float> mu_sigma;          ///< two for each point, radians
};

/** \param[in] spacings one for each point, meters
 * \param[in] parameters radii in spacings */
AdaptiveINAD adaptiveINAD(const FieldInput& input,
                          const std::vector<float>& spacings,
                          const INADParameters& parameters);

/** \brief INAD of some points among themselves, with normals that all points make: a
 * part of the neighbors has the same mean and deviation as all.
 * \param[in] points ascending \param[in] chosen which of them are asked for, ascending
 * \return mu and sigma of each chosen one */
std::vector<float> adaptiveINADAmong(const pcl::Indices& points,
                                     const pcl::Indices& chosen,
                                     const FieldInput& input,
                                     const std::vector<float>& spacings,
                                     const INADParameters& parameters);

} // namespace pcl::detail
