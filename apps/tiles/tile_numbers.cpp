// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What the default method needs to know of all points, from counts of the tiles.

#include "tiles/tile_numbers.h"

#include "cli/errors.h"
#include "tiles/bytes.h"
#include "tiles/selection.h"
#include "tiles/tile_places.h"

#include <pcl/segmentation/cloud_reach.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace pcl::app {
namespace {

using pcl::tiling::TiledCloud;
using pcl::tiling::TilePoints;
using Json = nlohmann::ordered_json;

constexpr std::uint64_t min_places = 13; // each has a 12th neighbor
// The first reach is more than three distances, which the spacing looks.
constexpr double first_reach = 4.0;

/** What a tile adds to the numbers of all. */
struct TileDistances {
  std::array<float, 3> low{}, high{};
  std::vector<float> distances;
};

Bytes
measuredDistances(const TilePoints& points,
                  const pcl::tiling::Position& offset,
                  double reach,
                  double resolution,
                  unsigned threads)
{
  const TilePlaces places = placesOf(points, offset, resolution);
  constexpr float far = std::numeric_limits<float>::infinity();
  std::array<float, 3> low{far, far, far}, high{-far, -far, -far};
  for (std::size_t i = 0; i < places.places->size(); ++i)
    for (std::size_t axis = 0; places.is_own[i] && axis < 3; ++axis) {
      low[axis] = std::min(low[axis], (*places.places)[i].data[axis]);
      high[axis] = std::max(high[axis], (*places.places)[i].data[axis]);
    }
  Bytes bytes;
  put(low, bytes);
  put(high, bytes);
  putAll(
      pcl::PartOfCloud(places.view(), places.is_own, threads).measureDistances(reach),
      bytes);
  return bytes;
}

TileDistances
distancesOf(const TiledCloud& cloud, const std::string& name, std::size_t tile)
{
  const Bytes bytes = cloud.resultOf(name, tile);
  ByteReader reader(bytes);
  TileDistances distances;
  distances.low = reader.take<std::array<float, 3>>();
  distances.high = reader.take<std::array<float, 3>>();
  distances.distances = reader.takeAll<float>();
  return distances;
}

std::uint64_t
middleOf(std::uint64_t count)
{
  return count / 2; // the upper one of two, as the library's medians
}

/** Of points that are not finite: no voxel mean stands for them. */
std::uint64_t
unknownPlaces(const TiledCloud& cloud, double resolution)
{
  return resolution > 0.0 ? 0 : cloud.countNotFinite();
}

/** Medians, the box and the number of places, of distances as far as the reach. */
Json
mediansOf(const TiledCloud& cloud, const std::string& name, double resolution)
{
  constexpr float far = std::numeric_limits<float>::infinity();
  std::array<float, 3> low{far, far, far}, high{-far, -far, -far};
  std::uint64_t places = 0, positive = 0;
  const auto forEachTile = [&](const auto& use) {
    for (std::size_t tile = 0; tile < cloud.size(); ++tile)
      if (cloud.pointsOf(tile) > 0)
        use(distancesOf(cloud, name, tile));
  };
  forEachTile([&](const TileDistances& of_tile) {
    places += of_tile.distances.size();
    for (const float d : of_tile.distances)
      positive += d > 0.0f ? 1 : 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], of_tile.low[axis]);
      high[axis] = std::max(high[axis], of_tile.high[axis]);
    }
  });
  if (places < min_places)
    throw InputError("the cloud has " + std::to_string(places) +
                     " different places; expected at least " +
                     std::to_string(min_places) + " to divide it");
  double distance = 1.0;
  if (positive > 0)
    distance = static_cast<double>(selected(middleOf(positive), [&](const auto& use) {
      forEachTile([&](const TileDistances& of_tile) {
        for (const float d : of_tile.distances)
          if (d > 0.0f)
            use(d, 1);
      });
    }));
  // Points that are not finite count with the median, as in the whole cloud.
  const std::uint64_t unknown = unknownPlaces(cloud, resolution);
  const float middle = selected(middleOf(places + unknown), [&](const auto& use) {
    use(static_cast<float>(distance), unknown);
    forEachTile([&](const TileDistances& of_tile) {
      for (const float d : of_tile.distances)
        use(d, 1);
    });
  });
  const bool is_known = std::isfinite(distance);
  return {{"distance", is_known ? distance : 0.0},
          {"spacing", is_known ? pcl::spacingAt(middle, distance) : 0.0f},
          {"low", low},
          {"high", high},
          {"places", places}};
}

/** The numbers that distances give, with a reach that was far enough for them. */
TiledNumbers
mediansOf(TiledCloud& cloud, double resolution, unsigned threads)
{
  // Twelve neighbors of a mean are within some two voxels.
  constexpr double first_voxels = 8.0;
  double reach =
      std::max(first_reach * cloud.typicalDistance(), first_voxels * resolution);
  if (!(reach > 0.0))
    reach = 1.0; // all points in one cell: it grows if that is too little
  for (int round = 0;; ++round) {
    const std::string name = "distances_" + std::to_string(round);
    const double halo = haloOf(reach, resolution);
    cloud.run(name, halo, [&](std::size_t, const TilePoints& points) {
      return measuredDistances(points, cloud.offset(), reach, resolution, threads);
    });
    const Json medians =
        Json::parse(cloud.decide("medians_" + std::to_string(round), [&] {
          return mediansOf(cloud, name, resolution).dump();
        }));
    TiledNumbers numbers;
    numbers.of_cloud.distance = medians.at("distance");
    numbers.of_cloud.spacing = medians.at("spacing");
    numbers.of_cloud.low = medians.at("low");
    numbers.of_cloud.high = medians.at("high");
    numbers.places = medians.at("places");
    const double needed =
        pcl::reachOf(numbers.of_cloud, pcl::ShapeModel::defaultEdges()).spacing;
    if (needed > 0.0 && needed <= reach)
      return numbers;
    reach = first_reach * std::max(reach, numbers.of_cloud.distance);
  }
}

Bytes
toBytes(const pcl::NoiseMeasures& measures)
{
  Bytes bytes;
  putAll(measures.variations, bytes);
  for (const auto& angles : measures.angles)
    putAll(angles, bytes);
  return bytes;
}

pcl::NoiseMeasures
measuresOf(const Bytes& bytes)
{
  ByteReader reader(bytes);
  pcl::NoiseMeasures measures;
  measures.variations = reader.takeAll<float>();
  for (auto& angles : measures.angles)
    angles = reader.takeAll<float>();
  return measures;
}

} // namespace

TiledNumbers
numbersOf(TiledCloud& cloud, double resolution, unsigned threads)
{
  TiledNumbers numbers = mediansOf(cloud, resolution, threads);
  const double reach =
      pcl::reachOf(numbers.of_cloud, pcl::ShapeModel::defaultEdges()).noise;
  const double halo = haloOf(reach, resolution);
  cloud.run("noise", halo, [&](std::size_t, const TilePoints& points) {
    const TilePlaces places = placesOf(points, cloud.offset(), resolution);
    return toBytes(pcl::PartOfCloud(places.view(), places.is_own, threads)
                       .measureNoise(numbers.of_cloud, numbers.places));
  });
  const Json noise = Json::parse(cloud.decide("noise", [&] {
    pcl::NoiseMeasures measures;
    for (std::size_t tile = 0; tile < cloud.size(); ++tile)
      if (cloud.pointsOf(tile) > 0)
        measures.add(measuresOf(cloud.resultOf("noise", tile)));
    pcl::CloudNumbers found = numbers.of_cloud;
    pcl::setNoise(measures, found);
    return Json{{"noise", found.noise},
                {"noise_level", found.noise_level},
                {"noise_correlation", found.noise_correlation}}
        .dump();
  }));
  numbers.of_cloud.noise = noise.at("noise");
  numbers.of_cloud.noise_level = noise.at("noise_level");
  numbers.of_cloud.noise_correlation = noise.at("noise_correlation");
  return numbers;
}

} // namespace pcl::app
