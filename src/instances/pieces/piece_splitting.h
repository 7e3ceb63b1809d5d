// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Pieces cut into planes, cylinders and spheres where these do not meet.

#pragma once

#include "instances/pieces/surface_piece.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace pcl::segmentation {

/** \brief Assign each node of a piece to a part whose surface is near and which nodes
 * around it belong to (iterated conditional modes; Besag, "On the statistical analysis
 * of dirty pictures", 1986); nodes near no surface to none. Drop parts that are left
 * with few nodes, or with nodes on the surfaces of others, and put the largest part
 * first. */
void assignNodes(const SurfacePiece& piece, std::vector<SurfacePart>& parts);

/** \brief The nodes of parts that form one surface: parts whose surfaces meet where
 * their nodes do, and parts too small to be another surface. */
std::vector<NodeIndices> joinParts(const SurfacePiece& piece,
                                   const std::vector<SurfacePart>& parts);

/** \brief The groups of nodes that each of some pieces falls into; none if it stays
 * whole. \param[in] nodesOf gives the nodes of a piece, in the order of their cells
 * \param[in] noise in spacings */
std::vector<std::vector<NodeIndices>>
cutPieces(std::size_t pieces,
          const std::function<std::vector<SurfaceNode>(std::size_t)>& nodesOf,
          double noise,
          unsigned threads);

/** \brief Cut pieces that are planes, cylinders or spheres on each side of a border
 * where these do not meet: faces that cross, or are nearly in line.
 *
 * A piece that such primitives do not describe stays whole.
 * \param[in] labels of the nodes, -1 none
 * \return labels of the nodes; nodes of a piece that was cut which are on none of its
 * parts have none */
Labels splitSurfaces(const detail::InstanceInput& input,
                     const std::vector<SurfaceNode>& nodes,
                     Labels labels);

} // namespace pcl::segmentation
