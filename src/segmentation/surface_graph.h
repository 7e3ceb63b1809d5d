/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include "label_order.h"
#include "point_grid.h"

#include <pcl/segmentation/instance_detection.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::segmentation {

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

/** \brief How far two pieces of one surface may be apart where they meet, in spacings.
 */
float stepLimit(const detail::InstanceInput& input);

/** \brief Pieces of surface that are smooth inside.
 *
 * Some members stand for all, each with the mean position and normal of those around
 * it. The surface runs from one to another if both are on one circle or line
 * (co-circular: Parent and Zucker, "Trace inference, curvature consistency, and curve
 * detection", 1989), it turns less than a crease does, and there is surface between
 * them. Those from which it runs to enough of the others around are joined. \param[in]
 * members which points may be in a piece \return labels from 0, the largest piece first
 */
Labels smoothPieces(const detail::InstanceInput& input,
                    const PointGrid& grid,
                    const std::vector<char>& members);

} // namespace pcl::segmentation
