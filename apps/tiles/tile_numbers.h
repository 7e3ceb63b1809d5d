// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What the default method needs to know of all points, from counts of the tiles.

#pragma once

#include "tiles/tile_places.h"

#include <pcl/features/cloud_numbers.h>
#include <pcl/tiling/tiled_cloud.h>

#include <cstdint>
#include <string>

namespace pcl::app {

struct TiledNumbers {
  pcl::CloudNumbers of_cloud;
  std::uint64_t places = 0; ///< that are finite
  std::string distances;    ///< the name of the results that have them
};

/** \brief Measure the tiles, as far as that was not done before. The numbers are those
 * of the whole cloud, bit by bit. \param[in] resolution of the voxel means that they
 * are of, meters; 0 for the cloud's own places
 * \throws InputError if there are too few points */
TiledNumbers
numbersOf(pcl::tiling::TiledCloud& cloud, double resolution, unsigned threads);

/** \brief placesOf() without a resolution, from what measuring the numbers has found:
 * which places are equal, and how far it is to their neighbors. */
TilePlaces measuredPlacesOf(const pcl::tiling::TiledCloud& cloud,
                            std::size_t tile,
                            const pcl::tiling::TilePoints& points,
                            const TiledNumbers& numbers);

/** \brief The tile's own ones alone, in their order. */
TilePlaces ownMeasuredPlacesOf(const pcl::tiling::TiledCloud& cloud,
                               std::size_t tile,
                               const pcl::tiling::TilePoints& points,
                               const TiledNumbers& numbers);

/** \brief The box of a tile's own places, or means. */
PointBox boxOfPlaces(const pcl::tiling::TiledCloud& cloud,
                     std::size_t tile,
                     const TiledNumbers& numbers);

} // namespace pcl::app
