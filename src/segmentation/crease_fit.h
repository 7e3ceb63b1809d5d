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

#include <optional>
#include <vector>

namespace pcl::segmentation {

/** \brief Where two planes that a neighborhood lies on meet. */
struct CreaseFit {
  Eigen::Vector3f foot;      ///< the point of the line that is nearest to the origin
  Eigen::Vector3f direction; ///< of the line, unit
  float angle = 0.0f;        ///< between the planes' normals, 0 to pi/2
  float turn = 0.0f;         ///< by which the surface turns at the line, 0 to pi
};

/** \brief Fit two planes to points by turns: each point to the nearer plane, each plane
 * to its points (k-planes, after Bradley and Mangasarian, "k-Plane Clustering", 2000).
 * It starts from the two normals that differ most.
 * \param[in] points relative to the point in question
 * \param[in] normals theirs, unit, of either sign
 * \return nothing if there are not five points on each plane, or the planes are
 * parallel */
std::optional<CreaseFit> fitCrease(const std::vector<Eigen::Vector3f>& points,
                                   const std::vector<Eigen::Vector3f>& normals);

} // namespace pcl::segmentation
