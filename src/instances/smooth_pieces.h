// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include "geometry/point_grid.h"
#include "instances/label_growth.h"

#include "instances/instance_detection.h"

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

// In spacings; doc/instances.md has the reason of each number.
constexpr float node_spacings = 1.5f;
constexpr float same_surface = 0.878f; // cosine of 0.5 rad, the least turn of a crease

/** \brief A member that stands for those around it. */
struct SurfaceNode {
  Eigen::Vector3f center; ///< the mean of those around it
  Eigen::Vector3f normal; ///< unit
  float spacing = 0.0f;   ///< metres
  float noise = 0.0f;     ///< of those around it about their plane, in spacings
};

/** \brief One node in each cell of space that has enough members around it, in the
 * order of the cells' coordinates. \param[in] members which points may be in a piece */
std::vector<SurfaceNode> surfaceNodes(const detail::InstanceInput& input,
                                      const PointGrid& points,
                                      const std::vector<char>& members);

inline XYZView
centersOf(const std::vector<SurfaceNode>& nodes)
{
  constexpr std::size_t stride = sizeof(SurfaceNode) / sizeof(float);
  return {nodes.empty() ? nullptr : nodes[0].center.data(), stride, nodes.size()};
}

} // namespace pcl::segmentation
