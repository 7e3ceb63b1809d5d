/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/features/adaptive_radius.h>

namespace pcl {

/** \brief How the INAD of a surface is computed. Either both radii or k is positive.
 *
 * Radii are in meters or in local spacings, as radius_mode says. In DENSITY mode they
 * may grow with the cloud's noise (see ShapeField::noise_level): radius + radius_noise
 * * noise. */
struct INADParameters {
  double normal_radius = 0.025; ///< meters, neighborhood of the normals
  double radius = 0.025;        ///< meters, neighborhood of the angles
  int k = 0;                    ///< nearest points, for normals and angles alike
  double outlier_rate = 2.0;    ///< c, 0 for no rejection
  AdaptiveRadius::RadiusMode radius_mode =
      AdaptiveRadius::FIXED;        ///< what the radii are measured in
  double normal_radius_noise = 0.0; ///< spacings for a noise of one spacing
  double radius_noise = 0.0;        ///< likewise

  /** \brief The paper's setting for planar and curved surfaces: 25 mm, 25 mm. */
  static INADParameters
  surfaces()
  {
    return {};
  }

  /** \brief The paper's setting for edges: normals over 15 mm, angles over 6 mm. */
  static INADParameters
  edges()
  {
    INADParameters parameters;
    parameters.normal_radius = 0.015;
    parameters.radius = 0.006;
    return parameters;
  }
};

} // namespace pcl
