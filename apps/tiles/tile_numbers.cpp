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

  Bytes
  toBytes() const
  {
    Bytes bytes;
    put(box, bytes);
    putAll(distances, bytes);
    putAll(repeats, bytes);
    putAll(places, bytes);
    return bytes;
  }
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
measuredDistances(const TilePoints& points,
                  const pcl::tiling::Position& offset,
                  double reach,
                  double resolution,
                  unsigned threads)
{
  const TilePlaces places = placesOf(points, offset, resolution);
  TileDistances distances;
  for (std::size_t i = 0; i < places.places->size(); ++i)
    if (places.is_own[i]) {
      const pcl::PointXYZ& place = (*places.places)[i];
      distances.box.add(PointBox::of({place.x, place.y, place.z}));
    }
  distances.distances =
      pcl::PartOfCloud(places.view(), places.is_own, threads).measureDistances(reach);
  if (resolution == 0.0)
    setRepeats(places.own_places, distances);
  return distances.toBytes();
}

TileDistances
distancesOf(const TiledCloud& cloud, const std::string& name, std::size_t tile)
{
  ByteReader reader(cloud.resultOf(name, tile));
  TileDistances distances;
  distances.box = reader.take<PointBox>();
  distances.distances = reader.takeAll<float>();
  distances.repeats = reader.takeAll<std::uint32_t>();
  distances.places = reader.takeAll<std::uint32_t>();
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

/** Of points that are not finite: no voxel mean stands for them. */
std::uint64_t
unknownPlaces(const TiledCloud& cloud, double resolution)
{
  return resolution > 0.0 ? 0 : cloud.countNotFinite();
}

/** use(distances) of each tile. */
template <typename Use>
void
forEachDistances(const TiledCloud& cloud, const std::string& name, const Use& use)
{
  forEachTile(cloud, [&](std::size_t tile) { use(distancesOf(cloud, name, tile)); });
}

/** The medians of the distances that are positive, and of all of them, in two passes
 * over the files of tiles. Points that are not finite count with the first one, as in
 * the whole cloud. */
class DistanceMedians {
  static_assert(Selection<float>::passes == 2, "choose() ends one, values() the other");

public:
  explicit DistanceMedians(std::uint64_t unknown) : unknown_(unknown) {}

  void
  add(const std::vector<float>& distances)
  {
    for (const float d : distances) {
      all_.add(d, 1);
      if (d > 0.0f)
        positive_.add(d, 1);
    }
  }

  /** After the first pass. */
  void
  choose()
  {
    has_positive_ = positive_.count() > 0;
    if (has_positive_)
      positive_.choose(middleOf(positive_.count()));
    all_.add(has_positive_ ? positive_.value() : 1.0f, unknown_);
    all_.choose(middleOf(all_.count()));
  }

  /** After the second one: of those that are positive, and of all. */
  std::pair<float, float>
  values()
  {
    if (has_positive_)
      positive_.endPass();
    const float distance = has_positive_ ? positive_.value() : 1.0f;
    all_.add(distance, unknown_);
    all_.endPass();
    return {distance, all_.value()};
  }

private:
  std::uint64_t unknown_;
  bool has_positive_ = false;
  Selection<float> positive_, all_;
};

/** Medians, the box and the number of places, of distances as far as the reach. */
Json
mediansOf(const TiledCloud& cloud, const std::string& name, double resolution)
{
  PointBox box;
  std::uint64_t places = 0;
  DistanceMedians medians(unknownPlaces(cloud, resolution));
  forEachDistances(cloud, name, [&](const TileDistances& of_tile) {
    places += of_tile.distances.size();
    medians.add(of_tile.distances);
    box.add(of_tile.box);
  });
  if (places < min_places)
    throw InputError("the cloud has " + std::to_string(places) +
                     " different places; expected at least " +
                     std::to_string(min_places) + " to divide it");
  medians.choose();
  forEachDistances(cloud, name, [&](const TileDistances& of_tile) {
    medians.add(of_tile.distances);
  });
  const auto [positive, middle] = medians.values();
  const double distance = positive;
  const bool is_known = std::isfinite(distance);
  return {{"distance", is_known ? distance : 0.0},
          {"spacing", is_known ? pcl::spacingAt(middle, distance) : 0.0f},
          {"low", box.low},
          {"high", box.high},
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
    numbers.distances = name;
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
  cloud.run("noise", halo, [&](std::size_t tile, const TilePoints& points) {
    if (resolution > 0.0) {
      const TilePlaces places = placesOf(points, cloud.offset(), resolution);
      return toBytes(pcl::PartOfCloud(places.view(), places.is_own, threads)
                         .measureNoise(numbers.of_cloud, numbers.places));
    }
    const TilePlaces places = measuredPlacesOf(cloud, tile, points, numbers);
    const pcl::KnownPart part{places.view(), places.is_own, places.distances};
    return toBytes(pcl::measureNoise(part, numbers.of_cloud, numbers.places, threads));
  });
  const Json noise = Json::parse(cloud.decide("noise", [&] {
    pcl::NoiseMeasures measures;
    forEachTile(cloud, [&](std::size_t tile) {
      measures.add(measuresOf(cloud.resultOf("noise", tile)));
    });
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

TilePlaces
measuredPlacesOf(const TiledCloud& cloud,
                 std::size_t tile,
                 const TilePoints& points,
                 const TiledNumbers& numbers)
{
  const auto all = floatsOf(points, cloud.offset());
  TilePlaces result =
      ownPlaces(distancesOf(cloud, numbers.distances, tile), *all, points.own);
  const std::size_t own_places = result.places->size();
  std::vector<float> of_tile;
  for (std::size_t k = 0; k < points.around.size(); ++k) {
    const auto& [other, row] = points.around[k];
    if (k == 0 || other != points.around[k - 1].tile)
      of_tile = distancesOfPoints(distancesOf(cloud, numbers.distances, other));
    if (std::isnan(of_tile[row]))
      continue;
    result.places->push_back((*all)[points.own + k]);
    result.distances.push_back(of_tile[row]);
  }
  result.is_own.assign(result.places->size(), false);
  std::fill_n(result.is_own.begin(), own_places, true);
  return result;
}

TilePlaces
ownMeasuredPlacesOf(const TiledCloud& cloud,
                    std::size_t tile,
                    const TilePoints& points,
                    const TiledNumbers& numbers)
{
  TilePlaces result = ownPlaces(distancesOf(cloud, numbers.distances, tile),
                                *floatsOf(points, cloud.offset()),
                                points.own);
  result.is_own.assign(result.places->size(), true);
  return result;
}

PointBox
boxOfPlaces(const TiledCloud& cloud, std::size_t tile, const TiledNumbers& numbers)
{
  return ByteReader(cloud.resultOf(numbers.distances, tile)).take<PointBox>();
}

} // namespace pcl::app
