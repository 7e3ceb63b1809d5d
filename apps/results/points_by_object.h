// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The points of each object of a labeled cloud.

#pragma once

#include <pcl/pcl_base.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstdint>
#include <map>
#include <vector>

namespace pcl::app {

/** \brief The finite points of each object, by its number from 1 on.
 * \param[in] cloud the points
 * \param[in] labels parts * object + part, one a point; object 0 is none
 * \param[in] parts labels to an object */
std::map<std::uint32_t, pcl::IndicesPtr>
pointsByObject(const pcl::PointCloud<pcl::PointXYZ>& cloud,
               const std::vector<std::uint32_t>& labels,
               std::uint32_t parts);

} // namespace pcl::app
