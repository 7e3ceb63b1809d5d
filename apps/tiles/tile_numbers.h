// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What the default method needs to know of all points, from counts of the tiles.

#pragma once

#include "tiles/tile_places.h"

#include <pcl/features/cloud_numbers.h>
#include <pcl/tiling/tiled_cloud.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::app {

/** \brief A cloud in tiles whose numbers are known. */
struct MeasuredCloud {
  pcl::tiling::TiledCloud& tiles;
  double resolution; ///< of the voxel means that places are, meters; 0 for points
  unsigned threads;
  pcl::CloudNumbers numbers;
  std::uint64_t places = 0; ///< that are finite
  std::string distances;    ///< the name of the results that have them
  std::string prefix;       ///< of the names of results at this resolution

  /** \brief The tiles around one, see haloOf(). */
  std::vector<std::size_t> tilesAround(std::size_t tile, double reach) const;
};

/** \brief Measure the tiles, as far as that was not done before, and go on to a coarser
 * resolution where neighbors share noise, as ShapeFieldEstimation does. The numbers are
 * those of the whole cloud, bit by bit. \param[in] resolution of the voxel means to
 * begin with, meters; 0 for the cloud's own places
 * \throws InputError if there are too few points */
MeasuredCloud
measure(pcl::tiling::TiledCloud& tiles, double resolution, unsigned threads);

/** \brief The places or means of a tile and around it. Without a resolution it is known
 * from measuring which places are equal, and how far it is to their neighbors. */
TilePlaces placesOf(const MeasuredCloud& cloud,
                    std::size_t tile,
                    const pcl::tiling::TilePoints& points);

/** \brief The tile's own ones alone, in their order. */
TilePlaces ownPlacesOf(const MeasuredCloud& cloud,
                       std::size_t tile,
                       const pcl::tiling::TilePoints& points);

/** \brief The box of a tile's own places, or means. */
PointBox boxOfPlaces(const MeasuredCloud& cloud, std::size_t tile);

} // namespace pcl::app
