// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The fields that are computed of each tile.

#include "tiles/tile_fields.h"

#include "cli/pcl_errors.h"
#include "detection/results.h"
#include "io/errors.h"
#include "tiles/bytes.h"
#include "tiles/tile_instances.h"
#include "tiles/tile_places.h"
#include "tiles/tile_surfaces.h"

#include <pcl/features/inad.h>
#include <pcl/features/normal_3d_sweep.h>
#include <pcl/segmentation/cloud_reach.h>
#include <pcl/segmentation/known_parts.h>
#include <pcl/segmentation/means_of_parts.h>
#include <pcl/segmentation/shape_field_estimation.h>
#include <pcl/features/impl/neighborhoods.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <sstream>

namespace pcl::app {
namespace {

using pcl::tiling::TiledCloud;
using pcl::tiling::TilePoints;

// Sums of floats are rounded; a neighbor at the very border must not be missed.
constexpr double rounding = 1.001;
constexpr std::size_t fields_of_surfaces = 2;
constexpr std::size_t fields_of_instances = 1; // the last one
constexpr std::size_t fields_of_means = 4;     // before all others: place and spacing
const std::string means_name = "means";
constexpr std::uint32_t nan_bits = 0x7fc00000U; // as std::numeric_limits<float> has it

std::uint32_t
bitsOf(float value)
{
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

/** The fields of a tile's points, row by row. */
class Rows {
public:
  Rows(std::size_t points, std::size_t fields)
  : fields_(fields)
  , values_(points * fields)
  {}

  /** The fields that were added to other rows. */
  void
  addRows(const std::vector<std::uint32_t>& rows, std::size_t fields)
  {
    for (std::size_t f = 0; f < fields; ++f)
      add([&](std::size_t i) { return rows[i * fields + f]; });
  }

  const std::vector<std::uint32_t>&
  values() const
  {
    return values_;
  }

  /** The next field of every point. \param[in] value of a point, float or number */
  template <typename Value>
  void
  add(const Value& value)
  {
    for (std::size_t i = 0; i * fields_ < values_.size(); ++i)
      values_[i * fields_ + next_] = value(i);
    ++next_;
  }

  Bytes
  toBytes(std::uint64_t unknown) const
  {
    Bytes bytes;
    bytes.reserve(sizeof unknown + values_.size() * sizeof values_[0]);
    put(unknown, bytes);
    const auto* const from = reinterpret_cast<const std::uint8_t*>(values_.data());
    bytes.insert(bytes.end(), from, from + values_.size() * sizeof values_[0]);
    return bytes;
  }

private:
  std::size_t fields_, next_ = 0;
  std::vector<std::uint32_t> values_;
};

/** Computes the fields of one tile. */
class TileComputation {
public:
  TileComputation(const TileWanted& wanted,
                  const std::optional<TiledNumbers>& numbers,
                  unsigned threads)
  : wanted_(wanted)
  , numbers_(numbers)
  , threads_(threads)
  {}

  /** Of its own points, or with a resolution of its own means. */
  Bytes
  operator()(const TiledCloud& cloud, std::size_t tile, const TilePoints& points) const
  {
    TileFaces faces;
    const Rows rows = rowsOf(cloud, tile, points, faces);
    if (!wanted_.needsSurfaces())
      return rows.toBytes(faces.unknown);
    faces.rows = rows.values();
    return toBytes(faces);
  }

  /** The fields with surfaces, which are found last. */
  Bytes
  withSurfaces(const TiledCloud& cloud,
               std::size_t tile,
               const TilePoints& points,
               const pcl::FacesAround::Noise& noise,
               const std::array<float, 3>& view_point) const
  {
    TileSurfaces surfaces = surfacesOf(cloud,
                                       tile,
                                       points,
                                       *numbers_,
                                       noise,
                                       wanted_.instances,
                                       wanted_.resolution,
                                       threads_);
    const std::size_t before = fieldsBeforeSurfaces();
    Rows rows(surfaces.surface.size(), fieldsBeforeInstances());
    rows.addRows(surfaces.rows, before);
    if (wanted_.surfaces) {
      rows.add([&](std::size_t i) { return bitsOf(surfaces.likelihood[i]); });
      rows.add([&](std::size_t i) { return surfaces.surface[i]; });
    }
    if (wanted_.instances.empty())
      return rows.toBytes(0);
    return instancePointsOf(std::move(surfaces.places),
                            surfaces.place_of_row,
                            rows.values(),
                            view_point,
                            numbers_->of_cloud,
                            threads_);
  }

  /** All fields, after instances were found. */
  Bytes
  withInstances(const TiledCloud& cloud, std::size_t tile) const
  {
    const TileInstances instances = instancesOf(cloud, tile);
    Rows rows(instances.of_row.size(), fieldsBeforeInstances() + fields_of_instances);
    rows.addRows(instances.rows, fieldsBeforeInstances());
    rows.add([&](std::size_t i) { return instances.of_row[i]; });
    return rows.toBytes(0);
  }

private:
  std::size_t
  fieldsBeforeInstances() const
  {
    return (wanted_.resolution > 0.0 ? fields_of_means : 0) + fieldsOf(wanted_).size() -
           (wanted_.instances.empty() ? 0 : fields_of_instances);
  }

  std::size_t
  fieldsBeforeSurfaces() const
  {
    return fieldsBeforeInstances() - (wanted_.surfaces ? fields_of_surfaces : 0);
  }

  /** All fields but those of surfaces. */
  Rows
  rowsOf(const TiledCloud& cloud,
         std::size_t tile,
         const TilePoints& points,
         TileFaces& faces) const
  {
    if (wanted_.resolution > 0.0) {
      const TilePlaces places = placesOf(points, cloud.offset(), wanted_.resolution);
      Rows rows(places.own_places.size(), fieldsBeforeSurfaces());
      addEdges(places, rows, faces);
      return rows;
    }
    Rows rows(points.own, fieldsBeforeSurfaces());
    if (wanted_.needsNumbers()) {
      const TilePlaces places = measuredPlacesOf(cloud, tile, points, *numbers_);
      if (wanted_.normals)
        addNormals(places, rows);
      if (wanted_.needsEdges())
        addEdges(places, rows, faces);
    }
    if (wanted_.inad_radius > 0.0)
      addInad(floatsOf(points, cloud.offset()), rows);
    return rows;
  }

  void
  addNormals(const TilePlaces& places, Rows& rows) const
  {
    const pcl::CloudNumbers& numbers = numbers_->of_cloud;
    const pcl::ShapeModel& model = wanted_.needsSurfaces()
                                       ? pcl::ShapeModel::defaultSurfaces()
                                       : pcl::ShapeModel::defaultEdges();
    const pcl::INADParameters radii = model.parameters();
    const std::vector<float> normals =
        pcl::PartOfCloud(places.view(), places.is_own, threads_)
            .normals(numbers,
                     radii.normal_radius +
                         radii.normal_radius_noise * numbers.noise_level);
    for (std::size_t c = 0; c < 4; ++c)
      rows.add([&](std::size_t i) {
        return bitsOf(normals[4 * static_cast<std::size_t>(places.own_places[i]) + c]);
      });
  }

  pcl::ShapeField::ConstPtr
  edgesOf(const TilePlaces& places) const
  {
    if (!places.distances.empty())
      return pcl::make_shared<const pcl::ShapeField>(
          pcl::edgesOf({places.view(), places.is_own, places.distances},
                       places.places,
                       numbers_->of_cloud,
                       threads_));
    pcl::ShapeFieldEstimation<pcl::PointXYZ> estimation;
    estimation.setInputCloud(places.places);
    estimation.setCloudNumbers(numbers_->of_cloud);
    estimation.setEdgesOnly(true);
    estimation.setNumberOfThreads(threads_);
    const auto field = pcl::make_shared<pcl::ShapeField>();
    withPclErrors("tile", [&] { return estimation.compute(*field); });
    return field;
  }

  void
  addEdges(const TilePlaces& places, Rows& rows, TileFaces& faces) const
  {
    const pcl::ShapeField::ConstPtr field = edgesOf(places);
    for (std::size_t i = 0; i < places.is_own.size(); ++i)
      faces.unknown +=
          places.is_own[i] && std::isnan(field->edge_likelihood[i]) ? 1 : 0;
    if (wanted_.resolution > 0.0)
      addMeans(places, *field, rows);
    if (wanted_.needsSurfaces())
      faces.part =
          pcl::facesOfPart(*field, numbers_->of_cloud, places.is_own, threads_);
    if (!wanted_.instances.empty())
      faces.places = ownPlaces(places, *field);
    if (wanted_.edges || wanted_.types)
      addEdges(places, field, rows);
  }

  /** What instances need of the tile's own places. */
  static std::vector<pcl::InstancePoint>
  ownPlaces(const TilePlaces& places, const pcl::ShapeField& field)
  {
    std::vector<pcl::InstancePoint> own;
    for (std::size_t i = 0; i < places.is_own.size(); ++i)
      if (places.is_own[i]) {
        pcl::InstancePoint& place = own.emplace_back();
        std::copy_n((*places.places)[i].data, 3, place.position.begin());
        std::copy_n(field.normals[i].data(), 3, place.normal.begin());
        place.spacing = field.spacings[i];
        place.edge = field.edge_likelihood[i];
      }
    return own;
  }

  /** What points need to find the mean that stands for them. */
  static void
  addMeans(const TilePlaces& places, const pcl::ShapeField& field, Rows& rows)
  {
    const auto placeOf = [&](std::size_t i) {
      return static_cast<std::size_t>(places.own_places[i]);
    };
    for (std::size_t axis = 0; axis < 3; ++axis)
      rows.add([&](std::size_t i) {
        return bitsOf((*places.places)[placeOf(i)].data[axis]);
      });
    rows.add([&](std::size_t i) { return bitsOf(field.spacings[placeOf(i)]); });
  }

  void
  addEdges(const TilePlaces& places,
           const pcl::ShapeField::ConstPtr& field,
           Rows& rows) const
  {
    EdgeDetector detector;
    detector.setInputCloud(places.places);
    detector.setShapeField(field);
    detector.setNumberOfThreads(threads_);
    const auto placeOf = [&](std::size_t i) {
      return static_cast<std::size_t>(places.own_places[i]);
    };
    std::vector<std::vector<float>> likelihoods;
    pcl::Edges edges;
    withPclErrors("tile", [&] {
      if (wanted_.types)
        detector.detect(edges);
      detector.compute(likelihoods);
      return !likelihoods.empty() && likelihoods[0].size() == places.places->size();
    });
    if (wanted_.edges) {
      std::vector<std::uint32_t> edge(places.places->size(), 0);
      const std::vector<pcl::PointIndices> members = detector.classesOf(likelihoods);
      for (const pcl::index_t i : members.front().indices)
        edge[static_cast<std::size_t>(i)] = 1;
      rows.add([&](std::size_t i) { return bitsOf(likelihoods[0][placeOf(i)]); });
      rows.add([&](std::size_t i) { return edge[placeOf(i)]; });
    }
    if (wanted_.types)
      rows.add([&](std::size_t i) {
        return static_cast<std::uint32_t>(edges.types[placeOf(i)]);
      });
  }

  void
  addInad(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& points, Rows& rows) const
  {
    pcl::NormalEstimationSweep<pcl::PointXYZ, pcl::Normal> normal_estimation(threads_);
    normal_estimation.setInputCloud(points);
    normal_estimation.setRadiusSearch(wanted_.inad_radius);
    const auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
    pcl::INADEstimation<pcl::PointXYZ, pcl::Normal> estimation(threads_);
    estimation.setInputCloud(points);
    estimation.setInputNormals(normals);
    estimation.setOutlierRate(pcl::INADParameters().outlier_rate);
    estimation.setRadiusSearch(wanted_.inad_radius);
    pcl::PointCloud<pcl::INAD> inad;
    withPclErrors("tile", [&] {
      normal_estimation.compute(*normals);
      estimation.compute(inad);
      return inad.size() == points->size();
    });
    rows.add([&](std::size_t i) { return bitsOf(inad[i].mu); });
    rows.add([&](std::size_t i) { return bitsOf(inad[i].sigma); });
  }

  const TileWanted& wanted_;
  const std::optional<TiledNumbers>& numbers_;
  unsigned threads_;
};

double
haloOfFields(const TileWanted& wanted, const std::optional<TiledNumbers>& numbers)
{
  double halo = 2.0 * rounding * wanted.inad_radius; // INAD looks at neighbors' normals
  if (numbers) {
    const pcl::CloudReach reach =
        pcl::reachOf(numbers->of_cloud, pcl::ShapeModel::defaultEdges());
    halo = std::max({halo,
                     wanted.normals ? reach.normals : 0.0,
                     wanted.edges ? reach.edges : 0.0,
                     wanted.types ? reach.types : 0.0,
                     wanted.needsSurfaces() ? reach.faces : 0.0});
  }
  return haloOf(halo, wanted.resolution);
}

/** Means of some tiles with their fields. */
class MeansAround {
public:
  MeansAround(const TileWanted& wanted)
  : fields_(fieldsOf(wanted))
  , has_instances_(!wanted.instances.empty())
  {}

  /** \param[in] bytes a result of means */
  void
  add(const Bytes& bytes)
  {
    const std::size_t row = fields_of_means + fields_.size();
    std::vector<std::uint32_t> values((bytes.size() - result_header) /
                                      sizeof(std::uint32_t));
    if (!values.empty())
      std::memcpy(
          values.data(), bytes.data() + result_header, bytes.size() - result_header);
    for (std::size_t at = 0; at < values.size(); at += row) {
      std::array<float, fields_of_means> mean{};
      std::memcpy(mean.data(), &values[at], sizeof mean);
      positions_.insert(positions_.end(), mean.begin(), mean.begin() + 3);
      spacings_.push_back(mean[3]);
      for (std::size_t f = 0; f < fields_.size(); ++f)
        values_.push_back(values[at + fields_of_means + f]);
    }
  }

  Bytes
  rowsAt(const pcl::XYZView& points, double resolution, unsigned threads) const
  {
    const std::vector<std::int32_t> means =
        nearest(points, spacings_, resolution, threads);
    Rows rows(points.size, fields_.size());
    const std::size_t of_all =
        fields_.size() - (has_instances_ ? fields_of_instances : 0);
    for (std::size_t f = 0; f < of_all; ++f)
      rows.add([&](std::size_t i) { return valueOf(f, means[i]); });
    if (has_instances_) {
      // However wide the spacing of a mean is: its instance is that of its voxel.
      const std::vector<std::int32_t> near = nearest(
          points, std::vector<float>(spacings_.size(), 0.0f), resolution, threads);
      rows.add([&](std::size_t i) { return valueOf(of_all, near[i]); });
    }
    return rows.toBytes(0);
  }

private:
  std::vector<std::int32_t>
  nearest(const pcl::XYZView& points,
          std::vector<float> spacings,
          double resolution,
          unsigned threads) const
  {
    return pcl::nearestMeans(points,
                             {positions_.data(), 3, positions_.size() / 3},
                             std::move(spacings),
                             resolution,
                             threads);
  }

  std::uint32_t
  valueOf(std::size_t field, std::int32_t mean) const
  {
    return mean < 0 ? fields_[field].unknown
                    : values_[static_cast<std::size_t>(mean) * fields_.size() + field];
  }

  std::vector<TileField> fields_;
  bool has_instances_;
  std::vector<float> positions_, spacings_;
  std::vector<std::uint32_t> values_;
};

/** From the fields of means to those of points. */
void
spreadMeans(TiledCloud& cloud,
            const TileWanted& wanted,
            const pcl::CloudNumbers& numbers,
            unsigned threads)
{
  const double halo =
      haloOf(rounding * pcl::reachOfMeans(numbers.distance, wanted.resolution),
             wanted.resolution);
  cloud.run(resultsName(), 0.0, [&](std::size_t tile, const TilePoints& points) {
    MeansAround means(wanted);
    means.add(cloud.resultOf(means_name, tile));
    for (const std::size_t other : cloud.tilesAround(tile, halo))
      means.add(cloud.resultOf(means_name, other));
    const auto places = floatsOf(points, cloud.offset());
    return means.rowsAt(pcl::detail::xyzOf(*places), wanted.resolution, threads);
  });
}

/** Of a cloud in which many points get no answer, the whole would be sampled evenly:
 * that looks too far for tiles. */
void
requireFew(std::uint64_t unknown, std::uint64_t places)
{
  constexpr double max_unknown = 0.02; // as ShapeFieldEstimation has it
  if (static_cast<double>(unknown) > max_unknown * static_cast<double>(places))
    throw InputError(std::to_string(unknown) + " of " + std::to_string(places) +
                     " places got no edge likelihood, as in clouds of very uneven "
                     "density: pcl_shape_detect samples such a cloud evenly, which "
                     "cannot be done in tiles; expected at most 2 %");
}

/** A coarser resolution needs other halos: the tiles that there are cannot be used. */
void
requireNoiseWithinRadii(const TileWanted& wanted, const TiledNumbers& numbers)
{
  const double coarser =
      pcl::coarserResolution(numbers.of_cloud, numbers.places, wanted.resolution);
  if (coarser == 0.0)
    return;
  std::ostringstream text;
  text << "neighbors share noise that is larger than the distances between points: "
          "pcl_shape_detect goes on to a resolution of "
       << coarser << " m there; expected -resolution " << coarser
       << (wanted.normals ? " without -normals, which are of the points themselves,"
                          : ",")
       << " and another output directory";
  throw InputError(text.str());
}

/** \param[in] name of results that begin with the number of their tile */
std::uint64_t
unknownOf(TiledCloud& cloud, const std::string& name)
{
  return std::stoull(cloud.decide("unknown", [&] {
    std::uint64_t count = 0;
    forEachTile(cloud, [&](std::size_t tile) {
      count += ByteReader(cloud.resultOf(name, tile)).take<std::uint64_t>();
    });
    return std::to_string(count);
  }));
}

} // namespace

bool
TileWanted::needsNumbers() const
{
  return normals || needsEdges();
}

bool
TileWanted::needsEdges() const
{
  return edges || types || needsSurfaces();
}

bool
TileWanted::needsSurfaces() const
{
  return surfaces || !instances.empty();
}

std::vector<TileField>
fieldsOf(const TileWanted& wanted)
{
  std::vector<TileField> fields;
  if (wanted.normals)
    for (const char* const name : {"normal_x", "normal_y", "normal_z", "curvature"})
      fields.push_back({name, true, nan_bits});
  if (wanted.edges) {
    fields.push_back({"edge_likelihood", true, nan_bits});
    fields.push_back({"edge", false, 0});
  }
  if (wanted.types)
    fields.push_back({"edge_type", false, 0});
  if (wanted.inad_radius > 0.0)
    for (const char* const name : {"mu", "sigma"})
      fields.push_back({name, true, nan_bits});
  if (wanted.surfaces) {
    fields.push_back({"likelihood", true, nan_bits});
    fields.push_back({"surface", false, 0});
  }
  if (!wanted.instances.empty())
    fields.push_back({"instance", false, 0});
  return fields;
}

const std::string&
resultsName()
{
  static const std::string name = "fields";
  return name;
}

void
computeFields(TiledCloud& cloud,
              const TileWanted& wanted,
              const std::optional<TiledNumbers>& numbers,
              const std::array<float, 3>& view_point,
              unsigned threads)
{
  if (wanted.needsNumbers())
    requireNoiseWithinRadii(wanted, *numbers);
  const TileComputation computation(wanted, numbers, threads);
  const std::string last = wanted.resolution > 0.0 ? means_name : resultsName();
  const std::string name = wanted.needsSurfaces() ? facesName() : last;
  cloud.run(name,
            haloOfFields(wanted, numbers),
            [&](std::size_t tile, const TilePoints& points) {
              return computation(cloud, tile, points);
            });
  if (wanted.needsEdges() && wanted.resolution == 0.0)
    requireFew(unknownOf(cloud, name), numbers->places);
  const bool has_instances = !wanted.instances.empty();
  if (wanted.needsSurfaces()) {
    const pcl::FacesAround::Noise noise =
        noiseOfFaces(cloud, *numbers, wanted.resolution, threads);
    const double halo = haloOf(0.0, wanted.resolution);
    cloud.run(has_instances ? instancePointsName() : last,
              halo,
              [&](std::size_t tile, const TilePoints& points) {
                return computation.withSurfaces(cloud, tile, points, noise, view_point);
              });
  }
  if (has_instances) {
    findInstances(cloud, numbers->of_cloud, wanted.resolution, threads);
    cloud.runOnResults(
        last, [&](std::size_t tile) { return computation.withInstances(cloud, tile); });
  }
  if (wanted.resolution > 0.0)
    spreadMeans(cloud, wanted, numbers->of_cloud, threads);
}

} // namespace pcl::app
