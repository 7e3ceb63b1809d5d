/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include "point_grid.h"

#include <pcl/segmentation/instance_detection.h>

#include <Eigen/Core>

#include <cstdint>
#include <utility>
#include <vector>

namespace pcl::segmentation {

using Labels = std::vector<std::int32_t>; ///< of points; -1 none

constexpr float edge_threshold = 0.5f;

inline Eigen::Vector3f
normalOf(const detail::InstanceInput& input, std::size_t i)
{
  return Eigen::Map<const Eigen::Vector3f>(&input.normals[3 * i]);
}

/** \brief The median of the spacings. */
float medianSpacing(const detail::InstanceInput& input);

/** \brief How far a point may be off a surface, in spacings. */
float offsetLimit(const detail::InstanceInput& input);

/** \brief Pieces of surface that are smooth inside: the members that are bonded to most
 * points around them, and the members that are bonded to those.
 *
 * Two members are bonded if they are near each other, their normals agree, and each is
 * in the tangent plane of the other. A strip narrower than the neighborhood is no
 * bridge. \param[in] members which points may be in a piece
 * \return labels from 0, in no order that matters */
Labels smoothPieces(const detail::InstanceInput& input,
                    const PointGrid& grid,
                    const std::vector<char>& members);

/** \brief Sort labels by their number of points, the largest first, ties by the first
 * point in the order of coordinates; drop those with fewer points. */
void
sortLabels(const detail::InstanceInput& input, std::size_t min_points, Labels& labels);

} // namespace pcl::segmentation
