// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Pieces of surface that are smooth inside, found over nodes that stand for the points.

#pragma once

#include "geometry/point_grid.h"
#include "instances/instance_points.h"

#include <Eigen/Core>

#include <vector>

namespace pcl::segmentation {

constexpr float same_surface = 0.878f; // cosine of 0.5 rad, the least turn of a crease

/** \brief A member that stands for those around it. */
struct SurfaceNode {
  Eigen::Vector3f position; ///< the mean of those around it
  Eigen::Vector3f normal;   ///< unit
  float spacing = 0.0f;     ///< meters
  float noise = 0.0f;       ///< of those around it about their plane, in spacings
};

/** \brief One node in each cell of space that has enough members around it, in the
 * order of the cells' coordinates. \param[in] members which points may be in a piece */
std::vector<SurfaceNode> surfaceNodes(const detail::InstanceInput& input,
                                      const PointGrid& points,
                                      const std::vector<char>& members);

/** \brief Pieces of surface that are smooth inside.
 *
 * The surface runs from one node to another if both are on one circle or line
 * (co-circular: Parent and Zucker, "Trace inference, curvature consistency, and curve
 * detection", 1989), it turns less than a crease does, and there is surface between
 * them. Those from which it runs to enough of the others around are joined.
 * \param[in] members which points may be in a piece
 * \return labels from 0, the largest piece first */
Labels smoothPieces(const detail::InstanceInput& input,
                    const PointGrid& grid,
                    const std::vector<char>& members);

} // namespace pcl::segmentation
