// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// From the results of tiles to clouds: those of the inputs, with new fields.

#pragma once

#include "io/pcd.h"
#include "tiles/cloud_source.h"
#include "tiles/tile_fields.h"

#include <pcl/tiling/tiled_cloud.h>

#include <string>
#include <vector>

namespace pcl::app {

/** \brief Where joined clouds go. */
struct JoinedOutputs {
  std::vector<std::string> paths; ///< one for each source
  PCDFormat format;               ///< not compressed
  bool is_offset_given;           ///< see chooseOffset()
};

/** \brief Write an output for each source: its fields and points in their order, with
 * the fields of the tiles appended, or in the place of those of the same name. Each
 * section of the sources is a task of the team, and then each output is put together.
 * Outputs appear complete. */
void joinTiles(pcl::tiling::TiledCloud& cloud,
               pcl::tiling::Team& team,
               const CloudSources& sources,
               const TileWanted& wanted,
               const JoinedOutputs& outputs);

} // namespace pcl::app
