/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/features/neighborhood_sweep.h>
#include <pcl/types.h>

#include <memory>
#include <vector>

namespace pcl {

/** \brief What the radius of a neighborhood is measured in: the setting that the
 * classes with a radius share. \ingroup features
 */
class AdaptiveRadius {
public:
  /** \brief FIXED: metres. DEPTH: metres where z is 0.8 m or less, beyond that in
   * proportion to z, as the distance between the points of a depth camera grows.
   * DENSITY: in local spacings, whatever the unit of the coordinates is.
   *
   * The local spacing d of a point is the distance to its 12th neighbor: 12 are enough
   * for it to vary by no more than a tenth on a surface sampled at random, where d is
   * two mean distances between points. It is softened against outliers and holes: with
   * m the median of the cloud, d = m * sqrt(clamp(d12 / m, 0.6, 3)). */
  enum RadiusMode { FIXED, DEPTH, DENSITY };

  /** \brief FIXED by default. With k neighbors instead of a radius it says nothing. */
  void
  setRadiusMode(RadiusMode mode)
  {
    radius_mode_ = mode;
  }

  RadiusMode
  getRadiusMode() const
  {
    return radius_mode_;
  }

protected:
  ~AdaptiveRadius() = default;

  RadiusMode radius_mode_ = FIXED;
};

namespace detail {

/** \brief Statistics over the neighborhoods of some points, however they are found.
 * See pcl::NeighborhoodSweep for what each method does. */
class NeighborhoodStatistics {
public:
  virtual ~NeighborhoodStatistics() = default;

  virtual bool computeNormals(const NeighborhoodSize& size,
                              float* normals,
                              float* curvature,
                              std::size_t stride) const = 0;

  virtual bool computeINAD(const NeighborhoodSize& size,
                           const XYZView& normals,
                           double outlier_rate,
                           float* mu_sigma) const = 0;

  virtual void computeDistanceToNearest(std::size_t k, float* distances) const = 0;

  /** \brief The same for some of the points only, which must outlive the result. */
  virtual std::unique_ptr<NeighborhoodStatistics>
  among(const pcl::Indices& points) const = 0;
};

/** \brief The local spacing of each point (of the median where it is not finite).
 * \param[in] distances to the 12th neighbors, NaN where a point is not finite */
PCL_SHAPE_EXPORTS std::vector<float> spacingsOf(std::vector<float> distances);

/** \brief Radii in metres, one for each point: within what a float can be.
 * \param[in] points, indices what the radii are for, null for all points
 * \param[in] finite the number of finite points to find neighbors among */
PCL_SHAPE_EXPORTS std::vector<float>
adaptiveRadii(AdaptiveRadius::RadiusMode mode,
              double radius,
              const NeighborhoodStatistics& neighborhoods,
              const XYZView& points,
              const pcl::Indices& indices,
              std::size_t finite);

/** \brief Parameters of this cloud: the growth with noise is added to the radii. */
template <typename Parameters>
Parameters
withNoise(Parameters parameters, double noise)
{
  parameters.normal_radius += parameters.normal_radius_noise * noise;
  parameters.radius += parameters.radius_noise * noise;
  parameters.normal_radius_noise = parameters.radius_noise = 0.0;
  return parameters;
}

/** \brief How noisy a cloud is: the standard deviation of its points from a smooth
 * surface in local spacings, from 0 to 0.3.
 *
 * 1.5 spacings are small enough for surfaces to be flat in them and large enough for
 * some 25 points. Of a disc of radius R with noise s the surface variation is
 * 2 (s / R)^2. The 20th percentile over the points leaves creases and curved surfaces
 * out; 1.55 makes up for it and for noise that neighbors share. Beyond 0.3 a surface
 * is as thick as it is sampled densely, and no larger radius would help.
 * \param[in] spacings one for each point */
PCL_SHAPE_EXPORTS double noiseOf(const NeighborhoodStatistics& neighborhoods,
                                 const XYZView& points,
                                 const std::vector<float>& spacings);

} // namespace detail
} // namespace pcl
