// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Instances of a class over tiles, from the surfaces that tiles have written.

#pragma once

#include "tiles/bytes.h"
#include "tiles/tile_numbers.h"

#include <pcl/segmentation/instances_of_parts.h>
#include <pcl/tiling/tiled_cloud.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::app {

/** \brief The name of the results that instances are found from: those of
 * instancePointsOf(). */
inline const std::string instance_points_name = "instance_points";

/** \brief \param[in] places of the tile \param[in] place_of_row of each of its rows
 * \param[in] rows the other fields, which are kept for instancesOf()
 * \param[in] view_point where the points were seen from */
Bytes instancePointsOf(std::vector<pcl::InstancePoint> places,
                       const std::vector<std::uint32_t>& place_of_row,
                       const std::vector<std::uint32_t>& rows,
                       const std::array<float, 3>& view_point,
                       const MeasuredCloud& cloud);

/** \brief Find the instances of the whole cloud, as far as that was not done before. */
void findInstances(const MeasuredCloud& cloud);

/** \brief What a tile has of them. */
struct TileInstances {
  std::vector<std::uint32_t> of_row; ///< 1 and up, 0 none
  std::vector<std::uint32_t> rows;   ///< the other fields
};
TileInstances instancesOf(const pcl::tiling::TiledCloud& cloud, std::size_t tile);

/** \brief How many instances were found in the cloud. */
std::uint64_t countInstances(const pcl::tiling::TiledCloud& cloud);

} // namespace pcl::app
