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

/** \brief Write an output for each source: its fields and points in their order, with
 * the fields of the tiles appended, or in the place of those of the same name. Outputs
 * appear complete. \param[in] outputs paths, one for each source \param[in] format not
 * compressed \param[in] is_given whether the offset was, see chooseOffset() */
void joinTiles(const pcl::tiling::TiledCloud& cloud,
               const CloudSources& sources,
               const std::vector<std::string>& outputs,
               const TileWanted& wanted,
               PCDFormat format,
               bool is_given);

} // namespace pcl::app
