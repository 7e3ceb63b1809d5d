// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The places of a tile's points, and of those around them, as floats.

#pragma once

#include <pcl/features/distinct_points.h>
#include <pcl/features/xyz_view.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/tiling/tiled_cloud.h>

#include <cstdint>
#include <vector>

namespace pcl::app {

/** \brief What the library computes with: equal points are at one place. */
struct TilePlaces {
  pcl::PointCloud<pcl::PointXYZ>::Ptr places;
  std::vector<bool> is_own;             ///< of each place: it is the tile's
  std::vector<std::int32_t> own_places; ///< of each of the tile's points

  pcl::XYZView view() const;
};

/** \brief The points as floats, with the offset subtracted. */
pcl::PointCloud<pcl::PointXYZ>::Ptr floatsOf(const pcl::tiling::TilePoints& points,
                                             const pcl::tiling::Position& offset);

/** \brief The places, or with a resolution the voxel means that stand for them; its own
 * ones count as the tile's points then. \param[in] resolution meters, 0 for none */
TilePlaces placesOf(const pcl::tiling::TilePoints& points,
                    const pcl::tiling::Position& offset,
                    double resolution);

/** \brief The tile's own ones alone, in their order. */
TilePlaces ownPlacesOf(const pcl::tiling::TilePoints& points,
                       const pcl::tiling::Position& offset,
                       double resolution);

/** \brief How far points must be there so that the places within a reach of a tile's
 * own ones are. */
double haloOf(double reach, double resolution);

} // namespace pcl::app
