// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Lines through points: simplification and length.

#pragma once

#include <Eigen/Core>

#include <vector>

namespace pcl::segmentation {

/** \brief The points of a line without those that are nearer than a tolerance to the
 * line through the others (Douglas and Peucker, "Algorithms for the reduction of the
 * number of points required to represent a digitized line", 1973). Both ends stay. */
std::vector<Eigen::Vector3f> simplified(const std::vector<Eigen::Vector3f>& line,
                                        float tolerance);

float lengthOf(const std::vector<Eigen::Vector3f>& line);

} // namespace pcl::segmentation
