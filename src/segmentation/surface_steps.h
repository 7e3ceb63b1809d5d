/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <Eigen/Core>

#include <vector>

namespace pcl::segmentation {

/** \brief The largest step of a surface at a point, and how clear it is. */
struct SurfaceStep {
  float height = 0.0f; ///< in the unit of the points
  float gain = 0.0f; ///< what the step explains over what is left: squares of distances
};

/** \brief Fit a paraboloid to points around the origin, and for lines in four
 * directions the same with a step at the line through the origin. \param[in] points
 * relative to the point in question \param[in] normal of the surface there, unit
 * \param[in] noise least standard deviation to reckon with, in the unit of the points
 * \return no step if there are not enough points on both sides of the lines */
SurfaceStep largestStep(const std::vector<Eigen::Vector3f>& points,
                        const Eigen::Vector3f& normal,
                        float noise);

} // namespace pcl::segmentation
