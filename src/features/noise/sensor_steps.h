// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Whether points lie on the steps of a sensor that are wider than their neighborhoods.

#pragma once

#include <pcl/features/cloud_numbers.h>
#include <pcl/features/xyz_view.h>
#include <pcl/types.h>
#include <pcl/features/impl/neighborhoods.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace pcl::detail {

/** \brief What the means of two sizes show. */
using AreasOfMeans = decltype(NoiseMeasures::steps);

/** \brief About how many points of a cloud are looked at. */
constexpr std::size_t step_points = 300; // a quarter of them is known to 3 %

/** \brief How far means are looked at from a point, meters. \param[in] spacing of the
 * cloud, meters */
double stepReach(double spacing);

/** \brief The areas around some points of a cloud, or of a part of it.
 * \param[in] chosen ascending \param[in] neighborhoods of all points among themselves
 * \param[in] spacings one for each point \param[in] spacing of the cloud, meters
 */
AreasOfMeans stepAreas(const pcl::Indices& chosen,
                       const Neighborhoods& neighborhoods,
                       const std::vector<float>& spacings,
                       double spacing,
                       unsigned threads);

/** \brief Whether most of a cloud that seems to bend does so only between the steps of
 * its sensor.
 *
 * A sensor that counts disparities or ticks of a clock gives steps, which grow with the
 * square of the range: the points of each are on a plane without noise. Steps and the
 * faces of a shape differ in this: all steps around a place have the same normal, for
 * there are no points on the risers between them, while the means of many points have
 * other normals. */
bool areOnWideSteps(const AreasOfMeans& areas);

} // namespace pcl::detail
