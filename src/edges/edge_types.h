// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What kind of edge each point is: a crease, a corner or an open boundary.

#pragma once

#include "geometry/point_grid.h"

#include <pcl/segmentation/adaptive_detection.h>

#include <vector>

namespace pcl::detail {

/** \brief What kind of edge each point is. \param[in] threshold as
 * ShapeDetection::setThreshold() */
std::vector<EdgeType>
edgeTypes(const AdaptiveInput& input, const AdaptiveEdges& edges, double threshold);

} // namespace pcl::detail
