// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What the default method needs to know of all points, from counts of the tiles.

#include "tiles/tile_numbers.h"

#include "io/errors.h"
#include "tiles/bytes.h"
#include "tiles/selection.h"
#include "tiles/tile_places.h"

#include <pcl/segmentation/cloud_reach.h>
#include <pcl/segmentation/known_parts.h>
#include <pcl/segmentation/means_of_parts.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace pcl::app {
namespace {

using pcl::tiling::TiledCloud;
using pcl::tiling::TilePoints;
using Json = nlohmann::ordered_json;

constexpr std::uint64_t min_places = 13; // each has a 12th neighbor
// The first reach is more than three distances, which the spacing looks.
constexpr double first_reach = 4.0;

/** What a tile adds to the numbers of all, and which of its points are equal. */
struct TileDistances {
  PointBox box;
  std::vector<float> distances;       ///< of its places
  std::vector<std::uint32_t> repeats; ///< points whose place is that of one before them
  std::vector<std::uint32_t> places;  ///< of them
};

/** Those of the own points of a tile. */
void
setRepeats(const std::vector<std::int32_t>& own_places, TileDistances& distances)
{
  std::int32_t next = 0;
  for (std::size_t i = 0; i < own_places.size(); ++i)
    if (own_places[i] == next)
      ++next;
    else {
      distances.repeats.push_back(static_cast<std::uint32_t>(i));
      distances.places.push_back(static_cast<std::uint32_t>(own_places[i]));
    }
}

Bytes
measuredDistances(const TilePoints& points, const MeasuredCloud& cloud, double reach)
{
  const TilePlaces places = placesOf(points, cloud.tiles.offset(), cloud.resolution);
  TileDistances distances;
  for (std::size_t i = 0; i < places.places->size(); ++i)
    if (places.is_own[i]) {
      const pcl::PointXYZ& place = (*places.places)[i];
      distances.box.add(PointBox::of({place.x, place.y, place.z}));
    }
  distances.distances = pcl::PartOfCloud(places.view(), places.is_own, cloud.threads)
                            .measureDistances(reach);
  if (cloud.resolution == 0.0)
    setRepeats(places.own_places, distances);
  return bytesOf(
      distances.box, distances.distances, distances.repeats, distances.places);
}

TileDistances
distancesOf(const TiledCloud& cloud, const std::string& name, std::size_t tile)
{
  TileDistances distances;
  ByteReader(cloud.resultOf(name, tile))
      .take(distances.box, distances.distances, distances.repeats, distances.places);
  return distances;
}

/** The distance of each point, NaN for repeats. */
std::vector<float>
distancesOfPoints(const TileDistances& distances)
{
  std::vector<float> result(distances.distances.size() + distances.repeats.size(),
                            0.0f);
  for (const std::uint32_t repeat : distances.repeats)
    result[repeat] = std::numeric_limits<float>::quiet_NaN();
  auto next = distances.distances.begin();
  for (float& d : result)
    if (!std::isnan(d))
      d = *next++;
  return result;
}

std::uint64_t
middleOf(std::uint64_t count)
{
  return count / 2; // the upper one of two, as the library's medians
}

/** Medians and the number of places, of distances as far as the reach. Each pass over
 * the files of tiles finds further digits of the medians. */
Json
mediansOf(const TiledCloud& cloud, const std::string& name, double resolution)
{
  std::uint64_t places = 0;
  Selection<float> positives(middleOf), all(middleOf);
  float distance = 1.0f; // without a positive one
  for (int pass = 0; pass < Selection<float>::passes; ++pass) {
    forEachTile(cloud, [&](std::size_t tile) {
      const TileDistances of_tile = distancesOf(cloud, name, tile);
      for (const float d : of_tile.distances) {
        all.add(d);
        if (d > 0.0f)
          positives.add(d);
      }
      places += pass == 0 ? of_tile.distances.size() : 0;
    });
    if (places < min_places)
      throw InputError("the cloud has " + std::to_string(places) +
                       " different places; expected at least " +
                       std::to_string(min_places) + " to divide it");
    positives.endPass();
    if (positives.count() > 0)
      distance = positives.value();
    // Points that are not finite count with it, as in the whole cloud; no voxel mean
    // stands for them.
    all.add(distance, resolution > 0.0 ? 0 : cloud.countNotFinite());
    all.endPass();
  }
  const bool is_known = std::isfinite(distance);
  return {{"distance", is_known ? double{distance} : 0.0},
          {"spacing", is_known ? pcl::spacingAt(all.value(), double{distance}) : 0.0f},
          {"places", places}};
}

/** Sets the numbers that distances give, with a reach that was far enough for them. */
void
measureDistances(MeasuredCloud& cloud)
{
  // Twelve neighbors of a mean are within some two voxels.
  constexpr double first_voxels = 8.0;
  double reach = std::max(first_reach * cloud.tiles.typicalDistance(),
                          first_voxels * cloud.resolution);
  if (!(reach > 0.0))
    reach = 1.0; // all points in one cell: it grows if that is too little
  for (int round = 0;; ++round) {
    cloud.distances = cloud.prefix + "distances_" + std::to_string(round);
    cloud.tiles.run(cloud.distances,
                    haloOf(reach, cloud.resolution),
                    [&](std::size_t, const TilePoints& points) {
                      return measuredDistances(points, cloud, reach);
                    });
    const Json medians = Json::parse(
        cloud.tiles.decide(cloud.prefix + "medians_" + std::to_string(round), [&] {
          return mediansOf(cloud.tiles, cloud.distances, cloud.resolution).dump();
        }));
    cloud.numbers.distance = medians.at("distance");
    cloud.numbers.spacing = medians.at("spacing");
    cloud.places = medians.at("places");
    const double needed =
        pcl::reachOf(cloud.numbers, pcl::ShapeModel::defaultEdges()).spacing;
    if (needed > 0.0 && needed <= reach)
      return;
    reach = first_reach * std::max(reach, cloud.numbers.distance);
  }
}

Bytes
noiseOf(const MeasuredCloud& cloud, std::size_t tile, const TilePoints& points)
{
  const TilePlaces places = placesOf(cloud, tile, points);
  const pcl::NoiseMeasures measures =
      cloud.resolution > 0.0
          ? pcl::PartOfCloud(places.view(), places.is_own, cloud.threads)
                .measureNoise(cloud.numbers, cloud.places)
          : pcl::measureNoise({places.view(), places.is_own, places.distances},
                              cloud.numbers,
                              cloud.places,
                              cloud.threads);
  return bytesOf(
      measures.variations, measures.angles, measures.steps, measures.thicknesses);
}

/** Sets the numbers that follow from distances. */
void
measureNoise(MeasuredCloud& cloud)
{
  const double reach =
      pcl::reachOf(cloud.numbers, pcl::ShapeModel::defaultEdges()).noise;
  const std::string name = cloud.prefix + "noise";
  cloud.tiles.run(name,
                  haloOf(reach, cloud.resolution),
                  [&](std::size_t tile, const TilePoints& points) {
                    return noiseOf(cloud, tile, points);
                  });
  const Json noise = Json::parse(cloud.tiles.decide(name, [&] {
    pcl::NoiseMeasures all;
    forEachTile(cloud.tiles, [&](std::size_t tile) {
      pcl::NoiseMeasures of_tile;
      ByteReader(cloud.tiles.resultOf(name, tile))
          .take(of_tile.variations, of_tile.angles, of_tile.steps, of_tile.thicknesses);
      all.add(of_tile);
    });
    pcl::CloudNumbers found = cloud.numbers;
    pcl::setNoise(all, found);
    return Json{{"noise", found.noise},
                {"noise_level", found.noise_level},
                {"noise_correlation", found.noise_correlation}}
        .dump();
  }));
  cloud.numbers.noise = noise.at("noise");
  cloud.numbers.noise_level = noise.at("noise_level");
  cloud.numbers.noise_correlation = noise.at("noise_correlation");
}

/** The places of the first points, which are the tile's own. */
TilePlaces
ownPlaces(TileDistances own,
          const pcl::PointCloud<pcl::PointXYZ>& points,
          std::size_t count)
{
  TilePlaces result;
  result.places = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  result.places->reserve(count);
  auto repeat = own.repeats.begin();
  auto place = own.places.begin();
  for (std::size_t i = 0; i < count; ++i)
    if (repeat != own.repeats.end() && *repeat == i) {
      result.own_places.push_back(static_cast<std::int32_t>(*place++));
      ++repeat;
    }
    else {
      result.own_places.push_back(static_cast<std::int32_t>(result.places->size()));
      result.places->push_back(points[i]);
    }
  result.distances = std::move(own.distances);
  return result;
}

} // namespace

std::vector<std::size_t>
MeasuredCloud::tilesAround(std::size_t tile, double reach) const
{
  return tiles.tilesAround(tile, haloOf(reach, resolution));
}

MeasuredCloud
measure(TiledCloud& tiles, double resolution, unsigned threads)
{
  std::string prefix;
  for (int steps = 1;; ++steps) {
    MeasuredCloud cloud{tiles, resolution, threads, {}, 0, {}, prefix};
    measureDistances(cloud);
    measureNoise(cloud);
    const double coarser =
        pcl::coarserResolution(cloud.numbers, cloud.places, resolution);
    if (coarser == 0.0)
      return cloud;
    resolution = coarser;
    prefix = "coarser_" + std::to_string(steps) + "_";
  }
}

TilePlaces
placesOf(const MeasuredCloud& cloud, std::size_t tile, const TilePoints& points)
{
  if (cloud.resolution > 0.0)
    return placesOf(points, cloud.tiles.offset(), cloud.resolution);
  const auto all = floatsOf(points, cloud.tiles.offset());
  TilePlaces result =
      ownPlaces(distancesOf(cloud.tiles, cloud.distances, tile), *all, points.own);
  const std::size_t own_places = result.places->size();
  std::vector<float> of_tile;
  for (std::size_t k = 0; k < points.around.size(); ++k) {
    const auto& [other, row] = points.around[k];
    if (k == 0 || other != points.around[k - 1].tile)
      of_tile = distancesOfPoints(distancesOf(cloud.tiles, cloud.distances, other));
    if (std::isnan(of_tile[row]))
      continue;
    result.places->push_back((*all)[points.own + k]);
    result.distances.push_back(of_tile[row]);
  }
  result.is_own.resize(own_places, true);
  result.is_own.resize(result.places->size(), false);
  return result;
}

TilePlaces
ownPlacesOf(const MeasuredCloud& cloud, std::size_t tile, const TilePoints& points)
{
  if (cloud.resolution > 0.0)
    return ownMeansOf(points, cloud.tiles.offset(), cloud.resolution);
  TilePlaces result = ownPlaces(distancesOf(cloud.tiles, cloud.distances, tile),
                                *floatsOf(points, cloud.tiles.offset()),
                                points.own);
  result.is_own.assign(result.places->size(), true);
  return result;
}

PointBox
boxOfPlaces(const MeasuredCloud& cloud, std::size_t tile)
{
  return takeFrom<PointBox>(cloud.tiles.resultOf(cloud.distances, tile));
}

} // namespace pcl::app
