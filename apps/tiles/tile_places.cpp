// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The places of a tile's points, and of those around them, as floats.

#include "tiles/tile_places.h"

#include <pcl/features/impl/neighborhoods.hpp>

#include <numeric>

namespace pcl::app {

pcl::XYZView
TilePlaces::view() const
{
  return pcl::detail::xyzOf(*places);
}

pcl::PointCloud<pcl::PointXYZ>::Ptr
floatsOf(const pcl::tiling::TilePoints& points, const pcl::tiling::Position& offset)
{
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  cloud->reserve(points.points.size());
  const auto coordinate = [&](const pcl::tiling::Position& p, std::size_t axis) {
    return static_cast<float>(p[axis] - offset[axis]) + 0.0f; // zeros are positive
  };
  for (const pcl::tiling::Position& p : points.points)
    cloud->emplace_back(coordinate(p, 0), coordinate(p, 1), coordinate(p, 2));
  return cloud;
}

TilePlaces
placesOf(const pcl::tiling::TilePoints& points, const pcl::tiling::Position& offset)
{
  const auto cloud = floatsOf(points, offset);
  const pcl::DistinctPoints distinct = pcl::distinctPoints(pcl::detail::xyzOf(*cloud));
  TilePlaces result;
  if (distinct.hasRepeats()) {
    result.places =
        pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>(*cloud, distinct.first);
    result.own_places.assign(distinct.place.begin(),
                             distinct.place.begin() +
                                 static_cast<std::ptrdiff_t>(points.own));
    // Points of one place are of one tile, and those of the tile come first.
    for (const std::int32_t first : distinct.first)
      result.is_own.push_back(static_cast<std::size_t>(first) < points.own);
    return result;
  }
  result.places = cloud;
  result.own_places.resize(points.own);
  std::iota(result.own_places.begin(), result.own_places.end(), 0);
  result.is_own.assign(points.points.size(), false);
  std::fill_n(result.is_own.begin(), points.own, true);
  return result;
}

} // namespace pcl::app
