// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Which points of a cloud a page shows, and how far they are from each other.

#pragma once

#include "io/cloud_file.h"

#include <cstddef>
#include <vector>

namespace pcl::app {

/** \brief An even choice of at most `max_points` points with finite coordinates, in an
 * order that looks random: any first part of it is an even choice as well. It depends
 * on the values of the points, not on their order. \param[in] points of the cloud;
 * those that are NaN are left out */
std::vector<std::size_t> choosePoints(const CloudFile& cloud,
                                      const pcl::PointCloud<pcl::PointXYZ>& points,
                                      std::size_t max_points);

/** \brief The median distance from some of the points to their nearest neighbor at
 * another place, meters; 1 if there is only one place. */
float spacingOf(const pcl::PointCloud<pcl::PointXYZ>& points);

} // namespace pcl::app
