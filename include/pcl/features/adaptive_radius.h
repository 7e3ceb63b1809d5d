/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

namespace pcl {

/** \brief What the radius of a neighborhood is measured in: the setting that the
 * classes with a radius share. \ingroup features
 */
class AdaptiveRadius {
public:
  /** \brief FIXED: meters. DEPTH: meters where z is 0.8 m or less, beyond that in
   * proportion to z, as the distance between the points of a depth camera grows.
   * DENSITY: in local spacings, whatever the unit of the coordinates is.
   *
   * The local spacing d of a point is the distance to its 12th neighbor: 12 are enough
   * for it to vary by no more than a tenth on a surface sampled at random, where d is
   * two mean distances between points. It is softened against outliers and holes: with
   * m the median of the cloud, d = m * sqrt(clamp(d12 / m, 0.6, 3)). */
  enum RadiusMode { FIXED, DEPTH, DENSITY };

  /** \brief FIXED by default. Ignored for k-nearest-neighbor searches. */
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

} // namespace pcl
