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

/** What other tiles read is before the rest. */
void
takeLinked(ByteReader& reader, TileFaces& faces)
{
  pcl::LinkedPieces& linked = faces.part.linked;
  reader.take(
      faces.unknown, linked.pieces, linked.others, linked.link_begins, linked.links);
}

TileFaces
facesOf(const TiledCloud& cloud, std::size_t tile)
{
  ByteReader reader(cloud.resultOf(faces_name, tile));
  TileFaces faces;
  takeLinked(reader, faces);
  reader.take(faces.part.piece_of_place, faces.part.of_model, faces.rows, faces.places);
  return faces;
}

/** The same nodes each time: their windows are found in one pass and used in the next.
 */
std::unique_ptr<FacesAround>
facesAround(const MeasuredCloud& cloud, std::size_t tile, const pcl::PartOfFaces& own)
{
  const PointBox box = boxOfPlaces(cloud, tile);
  auto faces = std::make_unique<FacesAround>(
      own, FacesAround::Box{box.low, box.high}, cloud.numbers, cloud.threads);
  const double reach =
      pcl::reachOf(cloud.numbers, pcl::ShapeModel::defaultEdges()).surfaces;
  for (const std::size_t other : cloud.tilesAround(tile, reach)) {
    ByteReader reader(cloud.tiles.resultOf(faces_name, other));
    TileFaces of_other;
    takeLinked(reader, of_other);
    faces->add(of_other.part.linked);
  }
  return faces;
}

Bytes
windowsOf(const MeasuredCloud& cloud, std::size_t tile)
{
  const TileFaces own = facesOf(cloud.tiles, tile);
  Bytes bytes;
  for (const auto& of_level : facesAround(cloud, tile, own.part)->windows()) {
    put(of_level.nodes, bytes);
    put(of_level.windows, bytes);
  }
  return bytes;
}

FacesAround::Windows
takeWindows(const TiledCloud& cloud, std::size_t tile)
{
  ByteReader reader(cloud.resultOf(windows_name, tile));
  FacesAround::Windows windows;
  for (FacesAround::LevelWindows& of_level : windows)
    reader.take(of_level.nodes, of_level.windows);
  return windows;
}

FacesAround::Noise
noiseOfWindows(const TiledCloud& cloud)
{
  std::vector<Selection<float>> residuals(FacesAround::levels,
                                          Selection<float>(FacesAround::rankOfNoise));
  for (int pass = 0; pass < Selection<float>::passes; ++pass) {
    forEachTile(cloud, [&](std::size_t tile) {
      const FacesAround::Windows windows = takeWindows(cloud, tile);
      for (std::size_t level = 0; level < windows.size(); ++level)
        for (const FacesAround::Window& window : windows[level].windows)
          residuals[level].add(window.residual);
    });
    for (Selection<float>& of_level : residuals)
      of_level.endPass();
  }
  FacesAround::Noise noise{};
  for (std::size_t level = 0; level < noise.size(); ++level)
    if (residuals[level].count() > 0)
      noise[level] = residuals[level].value();
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

Bytes
toBytes(const TileFaces& faces)
{
  const pcl::LinkedPieces& linked = faces.part.linked;
  return bytesOf(faces.unknown,
                 linked.pieces,
                 linked.others,
                 linked.link_begins,
                 linked.links,
                 faces.part.piece_of_place,
                 faces.part.of_model,
                 faces.rows,
                 faces.places);
}

FacesAround::Noise
noiseOfFaces(const MeasuredCloud& cloud)
{
  cloud.tiles.runOnResults(windows_name,
                           [&](std::size_t tile) { return windowsOf(cloud, tile); });
  return Json::parse(cloud.tiles.decide(
      "noise_of_faces", [&] { return Json(noiseOfWindows(cloud.tiles)).dump(); }));
}

TileSurfaces
surfacesOf(const MeasuredCloud& cloud,
           std::size_t tile,
           const TilePoints& points,
           const FacesAround::Noise& noise,
           const std::string& instances)
{
  const TilePlaces places = ownPlacesOf(cloud, tile, points);
  TileFaces own = facesOf(cloud.tiles, tile);
  if (places.places->empty()) // the means of its voxels are of other tiles
    return {};
  const auto faces = facesAround(cloud, tile, own.part);
  const pcl::ShapeField::ConstPtr field = fieldOf(
      places, faces->likelihoods(places.view(), noise, takeWindows(cloud.tiles, tile)));
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
