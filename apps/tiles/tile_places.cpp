// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The places of a tile's points, and of those around them, as floats.

#include "tiles/tile_places.h"

#include <pcl/segmentation/means_of_parts.h>
#include <pcl/features/impl/neighborhoods.hpp>

#include <algorithm>
#include <numeric>
#include <utility>

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

namespace {

pcl::PointCloud<pcl::PointXYZ>::Ptr
cloudOf(const std::vector<float>& coordinates)
{
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (std::size_t i = 0; i < coordinates.size(); i += 3)
    cloud->emplace_back(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
  return cloud;
}

pcl::PointCloud<pcl::PointXYZ>::Ptr
chosenFrom(const pcl::PointCloud<pcl::PointXYZ>& cloud,
           const std::vector<std::int32_t>& points)
{
  const pcl::Indices indices(points.begin(), points.end());
  return pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>(cloud, indices);
}

TilePlaces
distinctPlacesOf(const pcl::tiling::TilePoints& points,
                 const pcl::tiling::Position& offset)
{
  const auto cloud = floatsOf(points, offset);
  const pcl::DistinctPoints distinct = pcl::distinctPoints(pcl::detail::xyzOf(*cloud));
  TilePlaces result;
  if (distinct.hasRepeats()) {
    result.places = chosenFrom(*cloud, distinct.first);
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

} // namespace

TilePlaces
placesOf(const pcl::tiling::TilePoints& points,
         const pcl::tiling::Position& offset,
         double resolution)
{
  TilePlaces places = distinctPlacesOf(points, offset);
  if (resolution == 0.0)
    return places;
  pcl::MeansOfPart part = pcl::meansOfPart(places.view(), places.is_own, resolution);
  places.places = cloudOf(part.means);
  places.is_own = std::move(part.is_own);
  places.own_places.clear();
  for (std::size_t i = 0; i < places.is_own.size(); ++i)
    if (places.is_own[i])
      places.own_places.push_back(static_cast<std::int32_t>(i));
  return places;
}

TilePlaces
ownMeansOf(const pcl::tiling::TilePoints& points,
           const pcl::tiling::Position& offset,
           double resolution)
{
  TilePlaces places = placesOf(points, offset, resolution);
  places.places = chosenFrom(*places.places, places.own_places);
  std::iota(places.own_places.begin(), places.own_places.end(), 0);
  places.is_own.assign(places.places->size(), true);
  return places;
}

double
haloOf(double reach, double resolution)
{
  // A tile's own voxel reaches so far beyond its points, and so does one within reach;
  // sums of floats are rounded.
  constexpr double voxels = 2.0, rounding = 1.001;
  return reach + rounding * voxels * resolution;
}

} // namespace pcl::app
