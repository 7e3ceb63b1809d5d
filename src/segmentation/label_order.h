/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/segmentation/instance_detection.h>

#include <cstdint>
#include <vector>

namespace pcl::segmentation {

using Labels = std::vector<std::int32_t>; ///< of points; -1 none

/** \brief Sort labels by their number of points, the largest first, ties by the first
 * point in the order of coordinates; drop those with fewer points. */
void
sortLabels(const detail::InstanceInput& input, std::size_t min_points, Labels& labels);

} // namespace pcl::segmentation
