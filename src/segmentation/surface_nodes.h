/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include "surface_graph.h"

namespace pcl::segmentation {

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
