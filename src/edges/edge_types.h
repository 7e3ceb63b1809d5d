// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What kind of edge each point is: a crease, a corner or an open boundary.

#pragma once

#include <pcl/segmentation/shape_field.h>

#include <vector>

namespace pcl::detail {

/** \brief What kind of edge each point is. \param[in] threshold as
 * ShapeDetectionSettings::setThreshold() \param[in] threads 0 for all cores */
std::vector<EdgeType>
edgeTypes(const ShapeField& edges, double threshold, unsigned threads);

/** \brief How far creases are looked at for a corner, and neighbors for a boundary, in
 * spacings. */
double cornerSpacings(double noise_level);
double boundarySpacings();

} // namespace pcl::detail
