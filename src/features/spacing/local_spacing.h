// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The spacing of points, the noise of a cloud, and radii measured in them.

#pragma once

#include <pcl/features/cloud_numbers.h>
#include <pcl/features/inad_parameters.h>
#include <pcl/features/xyz_view.h>
#include <pcl/types.h>

#include <vector>

namespace pcl::detail {

class Neighborhoods;

/** \brief The local spacing of each point (of the median where it is not finite), see
 * AdaptiveRadius. \param[in] distances to the 12th neighbors, NaN where a point is not
 * finite */
PCL_SHAPE_EXPORTS std::vector<float> spacingsOf(std::vector<float> distances);

/** \brief Those of a cloud whose spacing changes slowly: the distances as they are, to
 * a tenth of the median or ten times as much. */
std::vector<float> evenSpacingsOf(std::vector<float> distances);

/** \brief The distance from each point of some neighborhoods to its 12th neighbor, NaN
 * unknown. */
std::vector<float> distancesToTwelfth(const Neighborhoods& neighborhoods);

/** \brief The local spacings of the points of some neighborhoods. */
std::vector<float> localSpacings(const Neighborhoods& neighborhoods,
                                 bool is_even = false);

/** \brief Those of the points of a part of a cloud. A point with fewer neighbors in the
 * part is far from the others. \param[in] neighborhoods of all points of the part */
std::vector<float> localSpacings(const Neighborhoods& neighborhoods,
                                 const CloudNumbers& of_cloud);

/** \brief The local spacing where the 12th neighbor is so far. */
float spacingOf(float distance, double median);

/** \brief The largest local spacing, and the distance beyond which a 12th neighbor
 * makes no difference to it. \param[in] median of the distances */
double mostSpacing(double median);
double spacingReach(double median);

/** \brief Each of them, as floats are multiplied. */
std::vector<float> times(double factor, std::vector<float> lengths);

/** \brief Radii within what a float can be. \param[in] units of each, meters */
std::vector<float> radiiInMeters(double radius, std::vector<float> units);

/** \brief Radii in meters, one for each point, in DEPTH or DENSITY mode. */
std::vector<float> adaptiveRadii(AdaptiveRadius::RadiusMode mode,
                                 double radius,
                                 const Neighborhoods& neighborhoods);

/** \brief Normals of either sign and their curvature, four numbers for each point; NaN
 * unknown. \param[in] radii one for each, meters */
std::vector<float> normalsWithCurvature(const Neighborhoods& neighborhoods,
                                        const std::vector<float>& radii);

/** \brief The most that noiseOf() gives, in spacings. */
constexpr double max_noise = 0.3;

/** \brief How noisy a cloud is: the standard deviation of its points from a smooth
 * surface in local spacings, from 0 to 0.3.
 *
 * 1.5 spacings are small enough for surfaces to be flat in them and large enough for
 * some 25 points. Of a disc of radius R with noise s the surface variation is
 * 2 (s / R)^2. The 20th percentile over the points leaves creases and curved surfaces
 * out; 1.55 makes up for it and for noise that neighbors share. Beyond 0.3 a surface
 * is as thick as it is sampled densely, and no larger radius would help.
 * \param[in] neighborhoods of all points of a cloud among themselves
 * \param[in] spacings one for each point */
PCL_SHAPE_EXPORTS double noiseOf(const Neighborhoods& neighborhoods,
                                 const std::vector<float>& spacings);

/** \brief The points that noiseOf() looks at, of a cloud of so many points. */
pcl::Indices noisePoints(const XYZView& points, std::uint64_t of_points);

/** \brief How far it looks from a point, in the largest local spacing. */
double variationReach();

/** \brief The surface variation around some of them. */
std::vector<float> variationsAt(const pcl::Indices& chosen,
                                const Neighborhoods& neighborhoods,
                                const std::vector<float>& spacings);

/** \brief The noise that surface variations show, at least one of them finite; else 0.
 */
double noiseOfVariations(std::vector<float> variations);

/** \brief Parameters for this noise: the growth with noise is added to the radii. */
INADParameters withNoise(INADParameters parameters, double noise);

} // namespace pcl::detail
