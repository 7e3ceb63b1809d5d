// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Pieces of surface that are smooth inside, found over nodes that stand for the points.

#pragma once

#include "geometry/point_grid.h"
#include "instances/instance_points.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::segmentation {

constexpr float same_surface = 0.878f; // cosine of 0.5 rad, the least turn of a crease
constexpr float node_spacings = 1.5f;  // between nodes, in spacings

/** \brief A member that stands for those around it. */
struct SurfaceNode {
  Eigen::Vector3f position; ///< the mean of those around it
  Eigen::Vector3f normal;   ///< unit
  float spacing = 0.0f;     ///< meters
  float noise = 0.0f;       ///< of those around it about their plane, in spacings
  std::uint32_t point = 0;  ///< the member
};

/** \brief One node in each cell of space that has enough members around it, in the
 * order of the cells' coordinates. \param[in] members which points may be in a piece */
std::vector<SurfaceNode> surfaceNodes(const detail::InstanceInput& input,
                                      const PointGrid& points,
                                      const std::vector<char>& members);

/** \brief The size of the cells of space that nodes are made in, and of those in which
 * nodes are visited, meters. */
float nodeCell(const detail::InstanceInput& input);
float nodeGridCell(const detail::InstanceInput& input);

/** \brief How far it is from a member to those that its node is made of, from a node to
 * those that the surface may run to, and from a point to the node of its piece; in
 * spacings. */
float nodeReach();
float linkReach();
float pieceReach();

/** \brief The nodes that the surface runs to from each of the first ones; none if these
 * are too few of those around. \param[in] count how many are the first
 * \param[in] grid of all nodes */
std::vector<std::vector<std::uint32_t>> linksOf(const detail::InstanceInput& input,
                                                const std::vector<SurfaceNode>& nodes,
                                                const PointGrid& grid,
                                                std::size_t count);

/** \brief For each member the label of the nearest node with one whose surface it is
 * on; -1 if there is none. \param[in] grid of the nodes */
Labels labelsAt(const detail::InstanceInput& input,
                const std::vector<char>& members,
                const std::vector<SurfaceNode>& nodes,
                const PointGrid& grid,
                const Labels& labels_of_nodes);

/** \brief Pieces of surface that are smooth inside.
 *
 * The surface continues from one node to another if both are on one circle or line
 * (co-circular: Parent and Zucker, "Trace inference, curvature consistency, and curve
 * detection", 1989), it turns less than a crease does, and there is surface between
 * them. Nodes from which it continues to enough of those around are joined.
 * \param[in] members which points may be in a piece
 * \return labels from 0, the largest piece first */
Labels smoothPieces(const detail::InstanceInput& input,
                    const PointGrid& grid,
                    const std::vector<char>& members);

} // namespace pcl::segmentation
