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

#include <cstddef>
#include <vector>

namespace pcl::segmentation {

/** \brief A place on a surface. */
struct Place {
  Eigen::Vector3f position;
  Eigen::Vector3f normal; ///< unit
};

/** \brief For each place, the best one first, the one that stands for it: itself, or
 * the first better one that does so for itself, is nearer than the radius and faces the
 * same way to 45 degrees. */
std::vector<std::size_t> representativesOf(const std::vector<Place>& places,
                                           float radius);

} // namespace pcl::segmentation
