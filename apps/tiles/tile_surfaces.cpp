// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Surfaces of tiles, from the pieces of faces that tiles have written.

#include "tiles/tile_surfaces.h"

#include "cli/pcl_errors.h"
#include "detection/results.h"
#include "tiles/selection.h"
#include "tiles/tile_places.h"

#include <pcl/segmentation/cloud_reach.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>

namespace pcl::app {
namespace {

using pcl::FacesAround;
using pcl::tiling::TiledCloud;
using pcl::tiling::TilePoints;
using Json = nlohmann::ordered_json;

const std::string windows_name = "windows";

pcl::LinkedPieces
takeLinked(ByteReader& reader)
{
  pcl::LinkedPieces linked;
  linked.pieces = reader.takeAll<pcl::FacePiece>();
  linked.others = reader.takeAll<std::array<float, 3>>();
  linked.link_begins = reader.takeAll<std::uint32_t>();
  linked.links = reader.takeAll<std::uint32_t>();
  return linked;
}

TileFaces
facesOf(const TiledCloud& cloud, std::size_t tile)
{
  ByteReader reader(cloud.resultOf(facesName(), tile));
  TileFaces faces;
  faces.unknown = reader.take<std::uint64_t>();
  faces.part.linked = takeLinked(reader);
  faces.part.piece_of_place = reader.takeAll<std::uint32_t>();
  faces.part.of_model = reader.takeAll<float>();
  faces.rows = reader.takeAll<std::uint32_t>();
  faces.places = reader.takeAll<pcl::InstancePoint>();
  return faces;
}

/** The same nodes each time: their windows are found in one pass and used in the next.
 */
std::unique_ptr<FacesAround>
facesAround(const TiledCloud& cloud,
            std::size_t tile,
            const pcl::PartOfFaces& own,
            const TiledNumbers& numbers,
            double resolution,
            unsigned threads)
{
  const PointBox box = boxOfPlaces(cloud, tile, numbers);
  auto faces = std::make_unique<FacesAround>(
      own, FacesAround::Box{box.low, box.high}, numbers.of_cloud, threads);
  const double halo =
      haloOf(pcl::reachOf(numbers.of_cloud, pcl::ShapeModel::defaultEdges()).surfaces,
             resolution);
  for (const std::size_t other : cloud.tilesAround(tile, halo)) {
    ByteReader reader(cloud.resultOf(facesName(), other));
    reader.take<std::uint64_t>();
    faces->add(takeLinked(reader));
  }
  return faces;
}

Bytes
windowsOf(const TiledCloud& cloud,
          std::size_t tile,
          const TiledNumbers& numbers,
          double resolution,
          unsigned threads)
{
  const TileFaces own = facesOf(cloud, tile);
  const auto faces = facesAround(cloud, tile, own.part, numbers, resolution, threads);
  Bytes bytes;
  for (const FacesAround::LevelWindows& of_level : faces->windows()) {
    put(of_level.nodes, bytes);
    putAll(of_level.windows, bytes);
  }
  return bytes;
}

FacesAround::Windows
takeWindows(const TiledCloud& cloud, std::size_t tile)
{
  ByteReader reader(cloud.resultOf(windows_name, tile));
  FacesAround::Windows windows;
  for (FacesAround::LevelWindows& of_level : windows) {
    of_level.nodes = reader.take<std::uint64_t>();
    of_level.windows = reader.takeAll<FacesAround::Window>();
  }
  return windows;
}

/** The files are read twice: once for each digit of the values of all levels. */
FacesAround::Noise
noiseOfWindows(const TiledCloud& cloud)
{
  static_assert(Selection<float>::passes == 2, "addAll() is called twice");
  std::array<Selection<float>, FacesAround::levels> selections;
  const auto addAll = [&] {
    forEachTile(cloud, [&](std::size_t tile) {
      const FacesAround::Windows windows = takeWindows(cloud, tile);
      for (std::size_t level = 0; level < windows.size(); ++level)
        for (const FacesAround::Window& window : windows[level].windows)
          selections[level].add(window.residual, 1);
    });
  };
  addAll();
  for (Selection<float>& selection : selections)
    if (selection.count() > 0)
      selection.choose(FacesAround::rankOfNoise(selection.count()));
  addAll();
  FacesAround::Noise noise{};
  for (std::size_t level = 0; level < noise.size(); ++level)
    if (selections[level].count() > 0) {
      selections[level].endPass();
      noise[level] = selections[level].value();
    }
  return noise;
}

/** The likelihoods of places as a field, which detectors take. */
pcl::ShapeField::ConstPtr
fieldOf(const TilePlaces& places, std::vector<std::vector<float>> likelihoods)
{
  const auto field = pcl::make_shared<pcl::ShapeField>();
  field->cloud = places.places;
  field->points = places.view();
  for (const pcl::ShapeModel::Class& c : pcl::ShapeModel::defaultSurfaces().classes())
    field->classes.push_back(c.name);
  field->likelihoods = std::move(likelihoods);
  return field;
}

std::vector<pcl::InstancePoint>
withLikelihoods(std::vector<pcl::InstancePoint> places,
                const pcl::ShapeField& field,
                const std::string& name)
{
  const auto c = std::find(field.classes.begin(), field.classes.end(), name) -
                 field.classes.begin();
  const std::vector<float>& likelihoods =
      field.likelihoods.at(static_cast<std::size_t>(c));
  for (std::size_t i = 0; i < places.size(); ++i)
    places[i].likelihood = likelihoods[i];
  return places;
}

} // namespace

const std::string&
facesName()
{
  static const std::string name = "faces";
  return name;
}

Bytes
toBytes(const TileFaces& faces)
{
  Bytes bytes;
  put(faces.unknown, bytes);
  putAll(faces.part.linked.pieces, bytes);
  putAll(faces.part.linked.others, bytes);
  putAll(faces.part.linked.link_begins, bytes);
  putAll(faces.part.linked.links, bytes);
  putAll(faces.part.piece_of_place, bytes);
  putAll(faces.part.of_model, bytes);
  putAll(faces.rows, bytes);
  putAll(faces.places, bytes);
  return bytes;
}

FacesAround::Noise
noiseOfFaces(TiledCloud& cloud,
             const TiledNumbers& numbers,
             double resolution,
             unsigned threads)
{
  cloud.runOnResults(windows_name, [&](std::size_t tile) {
    return windowsOf(cloud, tile, numbers, resolution, threads);
  });
  return Json::parse(cloud.decide("noise_of_faces",
                                  [&] { return Json(noiseOfWindows(cloud)).dump(); }));
}

TileSurfaces
surfacesOf(const TiledCloud& cloud,
           std::size_t tile,
           const TilePoints& points,
           const TiledNumbers& numbers,
           const FacesAround::Noise& noise,
           const std::string& instances,
           double resolution,
           unsigned threads)
{
  const TilePlaces places = resolution > 0.0
                                ? ownMeansOf(points, cloud.offset(), resolution)
                                : ownMeasuredPlacesOf(cloud, tile, points, numbers);
  TileFaces own = facesOf(cloud, tile);
  if (places.places->empty()) // the means of its voxels are of other tiles
    return {};
  const auto faces = facesAround(cloud, tile, own.part, numbers, resolution, threads);
  const pcl::ShapeField::ConstPtr field = fieldOf(
      places, faces->likelihoods(places.view(), noise, takeWindows(cloud, tile)));
  SurfaceDetector detector;
  detector.setInputCloud(places.places);
  detector.setShapeField(field);
  std::vector<std::vector<float>> likelihoods;
  withPclErrors("tile", [&] {
    detector.compute(likelihoods);
    return !likelihoods.empty();
  });
  std::vector<std::uint32_t> surface(places.places->size(), 0);
  const std::vector<pcl::PointIndices> members = detector.classesOf(likelihoods);
  for (std::size_t c = 0; c < members.size(); ++c)
    for (const pcl::index_t i : members[c].indices)
      surface[static_cast<std::size_t>(i)] = static_cast<std::uint32_t>(c + 1);
  TileSurfaces result;
  result.rows = std::move(own.rows);
  for (const std::int32_t place : places.own_places) {
    result.likelihood.push_back(likelihoods.front()[static_cast<std::size_t>(place)]);
    result.surface.push_back(surface[static_cast<std::size_t>(place)]);
  }
  if (!instances.empty()) {
    result.places = withLikelihoods(std::move(own.places), *field, instances);
    result.place_of_row.assign(places.own_places.begin(), places.own_places.end());
  }
  return result;
}

} // namespace pcl::app
