// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Surfaces of tiles, from the pieces of faces that tiles have written.

#pragma once

#include "tiles/bytes.h"
#include "tiles/tile_numbers.h"

#include <pcl/segmentation/faces_of_parts.h>
#include <pcl/segmentation/instances_of_parts.h>
#include <pcl/tiling/tiled_cloud.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::app {

/** \brief What is computed of a tile before its surfaces. */
struct TileFaces {
  std::uint64_t unknown = 0; ///< how many of its places have no edge likelihood
  pcl::PartOfFaces part;
  std::vector<std::uint32_t> rows; ///< the other fields of its points
  /** \brief Of its places, for instances: all but likelihoods; empty without. */
  std::vector<pcl::InstancePoint> places;
};

/** \brief The name of these results; they begin with how many are unknown. */
inline const std::string faces_name = "faces";

Bytes toBytes(const TileFaces& faces);

/** \brief The noise of the whole cloud that windows of faces are compared with, at each
 * level. The windows of all tiles are measured, as far as that was not done before. */
pcl::FacesAround::Noise noiseOfFaces(const MeasuredCloud& cloud);

/** \brief What the tile's own points get, or with a resolution its own means. */
struct TileSurfaces {
  std::vector<std::uint32_t> rows; ///< the other fields
  std::vector<float> likelihood;
  std::vector<std::uint32_t> surface; ///< 1 planar, 2 curved, 0 unknown
  /** \brief With the likelihood of the class; empty without a class. */
  std::vector<pcl::InstancePoint> places;
  std::vector<std::uint32_t> place_of_row;
};

/** \param[in] instances the class of instances, or empty */
TileSurfaces surfacesOf(const MeasuredCloud& cloud,
                        std::size_t tile,
                        const pcl::tiling::TilePoints& points,
                        const pcl::FacesAround::Noise& noise,
                        const std::string& instances);

} // namespace pcl::app
