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
    for (std::size_t i = 0; i * fields_ < values_.size(); ++i) {
      const auto of_point = value(i);
      static_assert(sizeof of_point == sizeof values_[0]);
      std::memcpy(&values_[i * fields_ + next_], &of_point, sizeof of_point);
    }
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
  TileComputation(const TiledCloud& cloud,
                  const TileWanted& wanted,
                  const std::optional<MeasuredCloud>& measured,
                  unsigned threads)
  : cloud_(cloud)
  , wanted_(wanted)
  , measured_(measured)
  , threads_(threads)
  {}

  /** Of its own points, or with a resolution of its own means. */
  Bytes
  operator()(std::size_t tile, const TilePoints& points) const
  {
    TileFaces faces;
    const Rows rows = rowsOf(tile, points, faces);
    if (!wanted_.needsSurfaces())
      return rows.toBytes(faces.unknown);
    faces.rows = rows.values();
    return toBytes(faces);
  }

  /** The fields with surfaces, which are found last. */
  Bytes
  withSurfaces(std::size_t tile,
               const TilePoints& points,
               const pcl::FacesAround::Noise& noise,
               const std::array<float, 3>& view_point) const
  {
    TileSurfaces surfaces =
        surfacesOf(*measured_, tile, points, noise, wanted_.instances);
    Rows rows(surfaces.surface.size(), fieldsBeforeInstances());
    rows.addRows(surfaces.rows, fieldsBeforeSurfaces());
    if (wanted_.surfaces) {
      rows.add([&](std::size_t i) { return surfaces.likelihood[i]; });
      rows.add([&](std::size_t i) { return surfaces.surface[i]; });
    }
    if (wanted_.instances.empty())
      return rows.toBytes(0);
    return instancePointsOf(std::move(surfaces.places),
                            surfaces.place_of_row,
                            rows.values(),
                            view_point,
                            *measured_);
  }

  /** All fields, after instances were found. */
  Bytes
  withInstances(std::size_t tile) const
  {
    const TileInstances instances = instancesOf(cloud_, tile);
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
  rowsOf(std::size_t tile, const TilePoints& points, TileFaces& faces) const
  {
    std::size_t size = points.own;
    TilePlaces places;
    if (measured_) {
      places = placesOf(*measured_, tile, points);
      size = places.own_places.size();
    }
    Rows rows(size, fieldsBeforeSurfaces());
    if (wanted_.normals)
      addNormals(places, rows);
    if (wanted_.needsEdges())
      addEdges(places, rows, faces);
    if (wanted_.inad_radius > 0.0)
      addInad(placesOf(points, cloud_.offset(), 0.0), rows);
    return rows;
  }

  void
  addNormals(const TilePlaces& places, Rows& rows) const
  {
    const pcl::CloudNumbers& numbers = measured_->numbers;
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
      rows.add([&](std::size_t i) { return normals[4 * places.placeOf(i) + c]; });
  }

  pcl::ShapeField::ConstPtr
  edgesOf(const TilePlaces& places) const
  {
    if (!places.distances.empty())
      return pcl::make_shared<const pcl::ShapeField>(
          pcl::edgesOf({places.view(), places.is_own, places.distances},
                       places.places,
                       measured_->numbers,
                       threads_));
    pcl::ShapeFieldEstimation<pcl::PointXYZ> estimation;
    estimation.setInputCloud(places.places);
    estimation.setCloudNumbers(measured_->numbers);
    estimation.setEdgesOnly(true);
    estimation.setNumberOfThreads(threads_);
    const auto field = pcl::make_shared<pcl::ShapeField>();
    withPclErrors("tile", [&] { return estimation.compute(*field); });
    return field;
  }

  /** And what the next steps need of the places. */
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
          pcl::facesOfPart(*field, measured_->numbers, places.is_own, threads_);
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
    for (std::size_t axis = 0; axis < 3; ++axis)
      rows.add([&](std::size_t i) {
        return (*places.places)[places.placeOf(i)].data[axis];
      });
    rows.add([&](std::size_t i) { return field.spacings[places.placeOf(i)]; });
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
      rows.add([&](std::size_t i) { return likelihoods[0][places.placeOf(i)]; });
      rows.add([&](std::size_t i) { return edge[places.placeOf(i)]; });
    }
    if (wanted_.types)
      rows.add([&](std::size_t i) {
        return static_cast<std::uint32_t>(edges.types[places.placeOf(i)]);
      });
  }

  void
  addInad(const TilePlaces& of_points, Rows& rows) const
  {
    const auto& points = of_points.places;
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
    rows.add([&](std::size_t i) { return inad[of_points.placeOf(i)].mu; });
    rows.add([&](std::size_t i) { return inad[of_points.placeOf(i)].sigma; });
  }

  const TiledCloud& cloud_;
  const TileWanted& wanted_;
  const std::optional<MeasuredCloud>& measured_;
  unsigned threads_;
};

double
haloOfFields(const TileWanted& wanted, const std::optional<MeasuredCloud>& measured)
{
  double halo = 2.0 * rounding * wanted.inad_radius; // INAD looks at neighbors' normals
  if (measured) {
    const pcl::CloudReach reach =
        pcl::reachOf(measured->numbers, pcl::ShapeModel::defaultEdges());
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
  explicit MeansAround(const TileWanted& wanted)
  : fields_(fieldsOf(wanted))
  , has_instances_(!wanted.instances.empty())
  {}

  /** \param[in] bytes a result of means */
  void
  add(const Bytes& bytes)
  {
    const std::size_t begin = values_.size();
    values_.resize(begin + (bytes.size() - result_header) / sizeof values_[0]);
    std::copy(bytes.begin() + result_header,
              bytes.end(),
              reinterpret_cast<std::uint8_t*>(values_.data() + begin));
    for (std::size_t at = begin; at < values_.size(); at += row()) {
      std::array<float, fields_of_means> mean{};
      std::memcpy(mean.data(), &values_[at], sizeof mean);
      positions_.insert(positions_.end(), mean.begin(), mean.begin() + 3);
      spacings_.push_back(mean[3]);
    }
  }

  Bytes
  rowsAt(const pcl::XYZView& points, double resolution, unsigned threads) const
  {
    const auto nearest = [&](const std::vector<float>& spacings) {
      return pcl::nearestMeans(points,
                               {positions_.data(), 3, spacings.size()},
                               spacings,
                               resolution,
                               threads);
    };
    Rows rows(points.size, fields_.size());
    const auto add = [&](std::size_t field, const std::vector<std::int32_t>& means) {
      rows.add([&](std::size_t i) {
        return means[i] < 0 ? fields_[field].unknown
                            : values_[static_cast<std::size_t>(means[i]) * row() +
                                      fields_of_means + field];
      });
    };
    const std::vector<std::int32_t> means = nearest(spacings_);
    const std::size_t before = fields_.size() - (has_instances_ ? 1 : 0);
    for (std::size_t f = 0; f < before; ++f)
      add(f, means);
    if (has_instances_) // of its voxel's mean, however wide the spacing of a mean is
      add(before, nearest(std::vector<float>(spacings_.size(), 0.0f)));
    return rows.toBytes(0);
  }

private:
  std::size_t
  row() const
  {
    return fields_of_means + fields_.size();
  }

  std::vector<TileField> fields_;
  bool has_instances_;
  std::vector<float> positions_, spacings_;
  std::vector<std::uint32_t> values_; ///< of each mean all of its row
};

/** From the fields of means to those of points. */
void
spreadMeans(const MeasuredCloud& cloud, const TileWanted& wanted)
{
  const double reach =
      rounding * pcl::reachOfMeans(cloud.numbers.distance, cloud.resolution);
  cloud.tiles.run(results_name, 0.0, [&](std::size_t tile, const TilePoints& points) {
    MeansAround means(wanted);
    means.add(cloud.tiles.resultOf(means_name, tile));
    for (const std::size_t other : cloud.tilesAround(tile, reach))
      means.add(cloud.tiles.resultOf(means_name, other));
    const auto places = floatsOf(points, cloud.tiles.offset());
    return means.rowsAt(pcl::detail::xyzOf(*places), cloud.resolution, cloud.threads);
  });
}

/** Of a cloud in which many points get no answer, the whole would be sampled evenly:
 * that looks too far for tiles. */
void
requireFew(std::uint64_t unknown, std::uint64_t places)
{
  constexpr double max_unknown = 0.02; // as ShapeFieldEstimation has it
  if (static_cast<double>(unknown) > max_unknown * static_cast<double>(places))
    throw InputError(
        std::to_string(unknown) + " of " + std::to_string(places) +
        " places got no edge likelihood, as in clouds of very uneven "
        "density; expected at most 2 %. Use pcl_shape_detect, which samples such "
        "a cloud evenly, or give a -resolution");
}

/** \param[in] name of results that begin with the number of their tile */
std::uint64_t
unknownOf(TiledCloud& cloud, const std::string& name)
{
  return std::stoull(cloud.decide("unknown", [&] {
    std::uint64_t count = 0;
    forEachTile(cloud, [&](std::size_t tile) {
      count += takeFrom<std::uint64_t>(cloud.resultOf(name, tile));
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

void
computeFields(TiledCloud& cloud,
              const TileWanted& wanted,
              const std::optional<MeasuredCloud>& measured,
              const std::array<float, 3>& view_point,
              unsigned threads)
{
  const TileComputation computation(cloud, wanted, measured, threads);
  const std::string last = wanted.resolution > 0.0 ? means_name : results_name;
  const std::string name = wanted.needsSurfaces() ? faces_name : last;
  cloud.run(name, haloOfFields(wanted, measured), computation);
  if (wanted.needsEdges() && wanted.resolution == 0.0)
    requireFew(unknownOf(cloud, name), measured->places);
  const bool has_instances = !wanted.instances.empty();
  if (wanted.needsSurfaces()) {
    const pcl::FacesAround::Noise noise = noiseOfFaces(*measured);
    cloud.run(has_instances ? instance_points_name : last,
              haloOf(0.0, wanted.resolution),
              [&](std::size_t tile, const TilePoints& points) {
                return computation.withSurfaces(tile, points, noise, view_point);
              });
  }
  if (has_instances) {
    findInstances(*measured);
    cloud.runOnResults(
        last, [&](std::size_t tile) { return computation.withInstances(tile); });
  }
  if (wanted.resolution > 0.0)
    spreadMeans(*measured, wanted);
}

} // namespace pcl::app
