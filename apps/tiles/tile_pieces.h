// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Pieces of surface that run over several tiles, united and cut by one process.

#pragma once

#include "tiles/bytes.h"
#include "tiles/tile_places.h"

#include <pcl/segmentation/instances_of_parts.h>
#include <pcl/tiling/tiled_cloud.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::app {

/** \brief The nodes that a tile has written. */
std::vector<pcl::InstanceNode> nodesOf(const pcl::tiling::TiledCloud& cloud,
                                       const std::string& name,
                                       std::size_t tile);

/** \brief A node by its tile, and its number there. */
struct NodeOfTile {
  std::uint32_t tile = 0, number = 0;
};

/** \brief \param[in] own how many nodes the tile has
 * \param[in] around the nodes after them that links run to */
Bytes linkBytes(const pcl::LinkedNodes& linked,
                std::size_t own,
                const std::vector<NodeOfTile>& around);

/** \brief Names of results. */
struct NamesOfLinks {
  std::string nodes, links;
};

/** \brief Unite the pieces of all tiles, and cut each of them. In memory are the nodes
 * of the largest piece, or of some million, and eight bytes for each node of the cloud.
 * \param[in] names of what tiles have written */
void cutPieces(const pcl::tiling::TiledCloud& cloud,
               const NamesOfLinks& names,
               const pcl::InstancesOfParts& parts,
               const pcl::tiling::TiledCloud::Write& write);

/** \brief Nodes with the labels that cutPieces() has written. */
struct CutNodes {
  std::vector<pcl::InstanceNode> nodes;
  std::vector<std::int32_t> labels;
};

/** \brief \param[in] nodes, pieces names of results */
CutNodes cutNodesOf(const pcl::tiling::TiledCloud& cloud,
                    const std::string& nodes,
                    const std::string& pieces,
                    std::size_t tile);

} // namespace pcl::app
