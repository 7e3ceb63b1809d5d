// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The places of a tile's points, and of those around them, as floats.

#pragma once

#include <pcl/features/distinct_points.h>
#include <pcl/features/xyz_view.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/tiling/tiled_cloud.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace pcl::app {

/** \brief What the library computes with: equal points are at one place. */
struct TilePlaces {
  pcl::PointCloud<pcl::PointXYZ>::Ptr places;
  std::vector<bool> is_own;             ///< of each place: it is the tile's
  std::vector<std::int32_t> own_places; ///< of each of the tile's points
  std::vector<float> distances; ///< to the 12th neighbor of each place, if known

  pcl::XYZView view() const;

  /** \brief \param[in] point of the tile's */
  std::size_t
  placeOf(std::size_t point) const
  {
    return static_cast<std::size_t>(own_places[point]);
  }
};

/** \brief A box along the axes; it begins with no point. */
struct PointBox {
  std::array<float, 3> low{far, far, far}, high{-far, -far, -far};

  static PointBox
  of(const std::array<float, 3>& point)
  {
    PointBox box;
    box.low = box.high = point;
    return box;
  }

  void
  add(const PointBox& other)
  {
    for (std::size_t axis = 0; axis < low.size(); ++axis) {
      low[axis] = std::min(low[axis], other.low[axis]);
      high[axis] = std::max(high[axis], other.high[axis]);
    }
  }

private:
  static constexpr float far = std::numeric_limits<float>::infinity();
};

/** \brief use(tile) for each one that has points. */
template <typename Use>
void
forEachTile(const pcl::tiling::TiledCloud& cloud, const Use& use)
{
  for (std::size_t tile = 0; tile < cloud.size(); ++tile)
    if (cloud.pointsOf(tile) > 0)
      use(tile);
}

/** \brief The points as floats, with the offset subtracted. */
pcl::PointCloud<pcl::PointXYZ>::Ptr floatsOf(const pcl::tiling::TilePoints& points,
                                             const pcl::tiling::Position& offset);

/** \brief The places, or with a resolution the voxel means that stand for them; its own
 * ones count as the tile's points then. \param[in] resolution meters, 0 for none */
TilePlaces placesOf(const pcl::tiling::TilePoints& points,
                    const pcl::tiling::Position& offset,
                    double resolution);

/** \brief The tile's own means alone, in their order. */
TilePlaces ownMeansOf(const pcl::tiling::TilePoints& points,
                      const pcl::tiling::Position& offset,
                      double resolution);

/** \brief How far around a tile points are needed, so that all places within a reach of
 * its own ones are known. */
double haloOf(double reach, double resolution);

} // namespace pcl::app
