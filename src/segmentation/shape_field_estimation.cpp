// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Makes a field: at the places of a cloud's points, or at voxel means or a search
// surface that stand for them.

#include "common/finite.h"
#include "common/number_text.h"
#include "common/parallel.h"
#include "common/point_types.h"
#include "common/statistics.h"
#include "edges/edge_detection.h"
#include "features/even_sampling.h"
#include "features/some_points.h"
#include "geometry/point_grid.h"
#include "geometry/voxel_means.h"
#include "segmentation/uneven_field.h"
#include "surfaces/surface_classification.h"

#include <pcl/features/distinct_points.h>
#include <pcl/impl/instantiate.hpp>
#include <pcl/segmentation/cloud_reach.h>
#include <pcl/segmentation/means_of_parts.h>
#include <pcl/segmentation/impl/shape_field_estimation.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <tuple>

namespace pcl::detail {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

std::string
problemOfModel(const ShapeModel& model, const std::string& name, bool is_edge)
{
  const std::size_t classes = model.classes().size();
  if (model.parameters().radius_mode != AdaptiveRadius::DENSITY)
    return "the " + name +
           " model was not made in DENSITY mode: use one that was, or the paper's "
           "method";
  if (is_edge && classes != 2)
    return "the " + name + " model has " + std::to_string(classes) +
           " classes: it must have two, an edge and the rest";
  if (classes < 2)
    return "the " + name + " model has " + std::to_string(classes) +
           " classes: use one with several, or the paper's method";
  return {};
}

std::string
problemOfPart(const FieldRequest& request)
{
  const std::string given =
      "numbers of a cloud are set, of which the input is a part: ";
  if (!request.edges_only)
    return given +
           "classes of surfaces look too far for parts, call setEdgesOnly(true), then "
           "facesOfPart() for surfaces";
  if (request.resolution != 0.0)
    return given + "they are not those of voxel means, leave the resolution out";
  if (request.has_normals)
    return given + "they are of estimated normals, leave the normals out";
  return {};
}

// With more unknown points the spacing is looked at again: scans have as many strays.
constexpr double max_unknown = 0.02;
// Of 1,000 points 4.5 % are unknown where of all 2 % are: five times the deviation off.
constexpr std::size_t sample_size = 1000;
constexpr double surely_too_many = 0.045;

/** What is known of the spacings before a field is made. */
struct Spacings {
  bool are_even = false; ///< they change slowly: they are taken as they are
  const std::vector<float>* known = nullptr;
};

/** Whether a field goes on from one stage to the next; else it ends there. */
struct Conditions {
  std::function<bool(const MeasuredCloud& cloud)> to_edges =
      [](const MeasuredCloud& /*cloud*/) { return true; };
  std::function<bool(const ShapeField& edges)> to_surfaces =
      [](const ShapeField& /*edges*/) { return true; };
};

/** The points of a cloud among themselves. */
class Surroundings {
public:
  Surroundings(const FieldRequest& request,
               const XYZView& points,
               const NeighborFinder& finder)
  : all_(points.size)
  , neighborhoods_(points, points, all_, request.threads)
  {
    std::iota(all_.begin(), all_.end(), 0);
    neighborhoods_.setFinder(finder);
    neighborhoods_.setIndex(request.index);
  }

  Surroundings(const Surroundings&) = delete;
  Surroundings& operator=(const Surroundings&) = delete;

  const Neighborhoods&
  neighborhoods() const
  {
    return neighborhoods_;
  }

private:
  pcl::Indices all_;
  Neighborhoods neighborhoods_;
};

ShapeField
fieldOf(const FieldRequest& request,
        const shared_ptr<const void>& owner,
        const Neighborhoods& neighborhoods,
        const Spacings& spacings = {},
        const Conditions& conditions = {})
{
  const FieldInput input{neighborhoods,
                         neighborhoods.input(),
                         request.normals,
                         request.threads,
                         spacings.are_even,
                         request.of_cloud ? &*request.of_cloud : nullptr};
  ShapeField field;
  field.cloud = owner;
  field.points = input.points;
  field.resolution = request.resolution;
  const MeasuredCloud measured = spacings.known
                                     ? measureCloud(input, *spacings.known, field)
                                     : measureCloud(input, field);
  if (!conditions.to_edges(measured))
    return field;
  findEdges(input, measured, request.edge_model, field);
  if (conditions.to_surfaces(field) && !request.edges_only)
    classifySurfaces(input, request.surface_model, field);
  return field;
}

/** How many finite points are unknown. \param[in] stands_for the point of the field
 * that stands for each */
std::size_t
countUnknown(const XYZView& points,
             const ShapeField& field,
             const std::vector<std::int32_t>& stands_for)
{
  std::size_t unknown = 0;
  for (std::size_t i = 0; i < points.size; ++i) {
    const std::int32_t at = stands_for[i];
    const bool is_unknown =
        at < 0 || std::isnan(field.edge_likelihood[static_cast<std::size_t>(at)]);
    unknown += is_unknown && kernels::isFinite(points[i]) ? 1 : 0;
  }
  return unknown;
}

/** A field, and whether it is of other points than the surface's places. */
struct Base {
  ShapeField field;
  bool is_other = false;
};

XYZView
viewOf(const std::vector<float>& points)
{
  return {points.data(), 3, points.size() / 3};
}

NeighborFinder
finderAmong(const FieldRequest& request, const std::vector<float>& points)
{
  return request.makeFinder ? request.makeFinder(points) : NeighborFinder();
}

/** \param[in] toEdges whether the field goes on to edges */
Base
baseOfMeans(const FieldRequest& request,
            const std::function<bool(const MeasuredCloud& means)>& toEdges)
{
  const auto means = std::make_shared<const std::vector<float>>(
      voxelMeans(request.surface, request.resolution, request.threads));
  Conditions conditions;
  conditions.to_edges = toEdges;
  const Surroundings surroundings(
      request, viewOf(*means), finderAmong(request, *means));
  return {fieldOf(request, means, surroundings.neighborhoods(), {}, conditions), true};
}

void
setMeasured(const NoiseLevel& noise,
            const segmentation::Bounds& bounds,
            CloudNumbers& numbers)
{
  numbers.noise_level = noise.level;
  numbers.noise_correlation = noise.correlation;
  for (int axis = 0; axis < 3; ++axis) {
    numbers.low[static_cast<std::size_t>(axis)] = bounds.low[axis];
    numbers.high[static_cast<std::size_t>(axis)] = bounds.high[axis];
  }
}

CloudNumbers
numbersOf(const MeasuredCloud& measured)
{
  CloudNumbers numbers;
  numbers.spacing = measured.spacing;
  setMeasured(measured.noise, measured.bounds, numbers);
  return numbers;
}

/** Makes the field of a cloud from its points, or where these are too uneven from means
 * that even them out. */
class FieldOfPoints {
public:
  explicit FieldOfPoints(const FieldRequest& request)
  : request_(request)
  , surface_(request, request.surface, finderAmong(request, {}))
  , distances_(distancesToTwelfth(surface_.neighborhoods(), request.surface.size))
  {}

  /** \param[in] toEdges whether the field goes on to edges */
  ShapeField
  make(const std::function<bool(const MeasuredCloud& cloud)>& toEdges) const
  {
    const std::vector<float> spacings = spacingsOf(distances_);
    std::size_t unknown = 0;
    Conditions conditions;
    conditions.to_edges = [&](const MeasuredCloud& cloud) {
      if (!toEdges(cloud))
        return false;
      const double share = request_.has_normals ? 0.0
                                                : shareUnknown(surface_.neighborhoods(),
                                                               spacings,
                                                               sample_size,
                                                               cloud.noise.level,
                                                               request_.threads);
      if (share <= surely_too_many)
        return true;
      unknown = static_cast<std::size_t>(share * static_cast<double>(cloud.places));
      return false;
    };
    conditions.to_surfaces = [&](const ShapeField& edges) {
      unknown = countUnknown(request_.surface, edges, themselves());
      return !areTooMany(unknown);
    };
    ShapeField field = ofSurface({false, &spacings}, conditions);
    return areTooMany(unknown) ? ofEvenMeans(unknown, spacings) : std::move(field);
  }

private:
  bool
  areTooMany(std::size_t unknown) const
  {
    const auto finite = static_cast<double>(countFinite(request_.surface));
    return !request_.has_normals && static_cast<double>(unknown) > max_unknown * finite;
  }

  std::vector<std::int32_t>
  themselves() const
  {
    std::vector<std::int32_t> points(request_.surface.size);
    std::iota(points.begin(), points.end(), 0);
    return points;
  }

  ShapeField
  ofSurface(const Spacings& spacings, const Conditions& conditions) const
  {
    return fieldOf(request_,
                   request_.surface_owner,
                   surface_.neighborhoods(),
                   spacings,
                   conditions);
  }

  /** The field of means if fewer are unknown then; else that of the points as they are.
   */
  ShapeField
  ofEvenMeans(std::size_t unknown, const std::vector<float>& spacings) const
  {
    const std::vector<float> even_spacings = evenSpacingsOf(distances_);
    const std::vector<float> even =
        evenSampling(request_.surface, even_spacings, request_.threads);
    const Surroundings of_means(request_, viewOf(even), finderAmong(request_, even));
    NoiseLevel noise;
    Conditions conditions;
    conditions.to_edges = [&](const MeasuredCloud& cloud) {
      noise = cloud.noise;
      return true;
    };
    const ShapeField means = fieldOf(
        request_, nullptr, of_means.neighborhoods(), {true, nullptr}, conditions);
    const std::vector<std::int32_t> stands_for = representatives(
        request_.surface, means.points, means.spacings, request_.threads);
    if (countUnknown(request_.surface, means, stands_for) >= unknown)
      return ofSurface({false, &spacings}, {});
    const std::vector<char> keeps_own = ownPoints(means, stands_for, even_spacings);
    ShapeField field;
    field.cloud = request_.surface_owner;
    field.points = request_.surface;
    field.spacings = even_spacings;
    field.noise = means.noise;
    field.noise_level = means.noise_level;
    findOwnEdges(keeps_own, noise, field);
    takeFromMeans(means, stands_for, keeps_own, field);
    return field;
  }

  /** Finds the edges where points keep their own.
   * \param[in] noise that of the means, of which most are points
   * \param[in,out] field with spacings */
  void
  findOwnEdges(const std::vector<char>& keeps_own,
               const NoiseLevel& noise,
               ShapeField& field) const
  {
    CloudNumbers numbers;
    numbers.spacing = segmentation::medianSpacing(field.spacings);
    numbers.distance = static_cast<double>(numbers.spacing);
    numbers.noise = field.noise;
    setMeasured(noise, segmentation::Bounds::of(request_.surface), numbers);
    const pcl::Indices near = pointsNearOwn(keeps_own, field.spacings, numbers);
    field.normals.assign(field.spacings.size(), Eigen::Vector3f::Constant(nan));
    field.edge_likelihood.assign(field.spacings.size(), nan);
    if (near.empty())
      return;
    std::vector<float> places, near_spacings;
    for (const pcl::index_t i : near) {
      const float* const p = request_.surface[static_cast<std::size_t>(i)];
      places.insert(places.end(), p, p + 3);
      near_spacings.push_back(field.spacings[static_cast<std::size_t>(i)]);
    }
    FieldRequest of_near = request_;
    of_near.of_cloud = numbers;
    of_near.edges_only = true;
    of_near.index = nullptr;
    const Surroundings surroundings(
        of_near, viewOf(places), finderAmong(request_, places));
    const ShapeField edges =
        fieldOf(of_near, nullptr, surroundings.neighborhoods(), {true, &near_spacings});
    for (std::size_t k = 0; k < near.size(); ++k) {
      const auto i = static_cast<std::size_t>(near[k]);
      field.normals[i] = edges.normals[k];
      field.edge_likelihood[i] = edges.edge_likelihood[k];
    }
    field.creases = edges.creases;
  }

  /** The points that keep their own edges, and those that these depend on. */
  pcl::Indices
  pointsNearOwn(const std::vector<char>& keeps_own,
                const std::vector<float>& spacings,
                const CloudNumbers& numbers) const
  {
    const double reach = reachOf(numbers, request_.edge_model).edges /
                         mostSpacing(numbers.distance); // in spacings
    std::vector<float> own;
    for (std::size_t i = 0; i < keeps_own.size(); ++i)
      if (keeps_own[i] && kernels::isFinite(request_.surface[i]))
        own.insert(own.end(), request_.surface[i], request_.surface[i] + 3);
    const segmentation::PointGrid grid(
        viewOf(own), static_cast<float>(reach) * numbers.spacing, request_.threads);
    std::vector<char> is_near(keeps_own.size(), 0);
    kernels::parallelForEach(is_near.size(), request_.threads, [&](std::size_t i) {
      const float* const p = request_.surface[i];
      is_near[i] =
          kernels::isFinite(p) &&
          grid.anyWithin(Eigen::Map<const Eigen::Vector3f>(p),
                         static_cast<float>(reach) * spacings[i],
                         [](std::uint32_t, const Eigen::Vector3f&) { return true; });
    });
    pcl::Indices near;
    for (std::size_t i = 0; i < is_near.size(); ++i)
      if (is_near[i])
        near.push_back(static_cast<pcl::index_t>(i));
    return near;
  }

  const FieldRequest& request_;
  Surroundings surface_;
  std::vector<float> distances_; ///< of each point to its 12th neighbor
};

/** \param[in] toEdges whether the field goes on to edges */
ShapeField
fieldOfPoints(const FieldRequest& request,
              const std::function<bool(const MeasuredCloud& cloud)>& toEdges)
{
  if (!request.of_cloud)
    return FieldOfPoints(request).make(toEdges);
  Conditions conditions;
  conditions.to_edges = toEdges;
  const Surroundings surface(request, request.surface, finderAmong(request, {}));
  return fieldOf(
      request, request.surface_owner, surface.neighborhoods(), {}, conditions);
}

/** The field of the points, or of means that are coarse enough for the noise which
 * neighbors share. */
Base
baseOf(FieldRequest request)
{
  const bool may_be_coarser = !request.has_normals && !request.of_cloud;
  double coarser = 0.0; // than what was measured last
  const auto toEdges = [&](const MeasuredCloud& measured) {
    if (may_be_coarser)
      coarser =
          coarserResolution(numbersOf(measured), measured.places, request.resolution);
    return coarser == 0.0;
  };
  Base base = request.resolution == 0.0 ? Base{fieldOfPoints(request, toEdges), false}
                                        : baseOfMeans(request, toEdges);
  while (coarser > 0.0) {
    request.resolution = coarser;
    base = baseOfMeans(request, toEdges);
  }
  return base;
}

/** Three numbers of each place, those of its first point; zeros are positive. */
std::vector<float>
gathered(const XYZView& values, const DistinctPoints& distinct)
{
  std::vector<float> result;
  result.reserve(3 * distinct.first.size());
  for (const std::int32_t i : distinct.first)
    for (int axis = 0; axis < 3; ++axis)
      result.push_back(values[static_cast<std::size_t>(i)][axis] + 0.0f);
  return result;
}

/** Of the normals that are given for a place the one with the least coordinates,
 * whatever their order; one that is finite if there is one. */
std::vector<float>
normalsOfPlaces(const XYZView& normals, const DistinctPoints& distinct)
{
  std::vector<float> result = gathered(normals, distinct);
  const auto order = [](const float* n) {
    return std::make_tuple(!kernels::isFinite(n), n[0], n[1], n[2]);
  };
  for (std::size_t i = 0; i < normals.size; ++i) {
    float* const least = &result[3 * static_cast<std::size_t>(distinct.place[i])];
    if (kernels::isFinite(normals[i]) && order(normals[i]) < order(least))
      std::copy_n(normals[i], 3, least);
  }
  return result;
}

/** The field of the surface as it is if no two of its points are equal. */
Base
baseOf(const FieldRequest& request, const DistinctPoints& distinct)
{
  if (!distinct.hasRepeats())
    return baseOf(request);
  const auto places =
      std::make_shared<const std::vector<float>>(gathered(request.surface, distinct));
  std::vector<float> normals;
  FieldRequest of_places = request;
  of_places.surface = {places->data(), 3, distinct.first.size()};
  of_places.surface_owner = places;
  if (request.has_normals) {
    normals = normalsOfPlaces(request.normals, distinct);
    of_places.normals = {normals.data(), 3, distinct.first.size()};
  }
  if (request.makeFinder)
    of_places.makeFinder = [&](const std::vector<float>& means) {
      return request.makeFinder(means.empty() ? *places : means);
    };
  return baseOf(of_places);
}

/** Values of points that stand for others, where they are known. */
template <typename T>
std::vector<T>
taken(const std::vector<T>& values,
      const std::vector<std::int32_t>& from,
      const T& unknown)
{
  std::vector<T> result;
  result.reserve(from.size());
  for (const std::int32_t i : from)
    result.push_back(i < 0 ? unknown : values[static_cast<std::size_t>(i)]);
  return result;
}

/** The field of points with the values of others that they stand for. */
ShapeField
scattered(const ShapeField::ConstPtr& base, std::vector<std::int32_t> base_points)
{
  ShapeField field;
  field.noise = base->noise;
  field.noise_level = base->noise_level;
  field.creases = base->creases;
  field.classes = base->classes;
  field.resolution = base->resolution;
  field.spacings = taken(base->spacings, base_points, nan);
  field.normals = taken<Eigen::Vector3f>(
      base->normals, base_points, Eigen::Vector3f::Constant(nan));
  field.edge_likelihood = taken(base->edge_likelihood, base_points, nan);
  for (const auto& likelihood : base->likelihoods)
    field.likelihoods.push_back(taken(likelihood, base_points, nan));
  field.base = base;
  field.base_points = std::move(base_points);
  return field;
}

/** Make all points unknown that are not among the indices. */
void restrict(ShapeField& field, const pcl::Indices& indices)
{
  std::vector<bool> is_wanted(field.points.size, false);
  for (const pcl::index_t index : indices)
    is_wanted[static_cast<std::size_t>(index)] = true;
  for (std::size_t i = 0; i < is_wanted.size(); ++i) {
    if (is_wanted[i])
      continue;
    field.spacings[i] = field.edge_likelihood[i] = nan;
    field.normals[i].setConstant(nan);
    for (auto& likelihood : field.likelihoods)
      likelihood[i] = nan;
    if (field.base)
      field.base_points[i] = -1;
  }
}

} // namespace

std::string
problemOf(const FieldRequest& request)
{
  constexpr double any_radius = 1.0;
  std::string problem =
      problemOf({request.input, request.surface, request.indices, any_radius, 0});
  if (problem.empty() && request.has_normals)
    problem = request.resolution != 0.0
                  ? "normals and a resolution are set: voxel means have normals of "
                    "their own, leave one of the two out"
                  : problemOfNormals(request.normals.size, request.surface.size);
  if (problem.empty())
    problem = problemOfModel(request.edge_model, "edge", true);
  if (problem.empty() && !request.edges_only)
    problem = problemOfModel(request.surface_model, "surface", false);
  if (problem.empty() && request.of_cloud)
    problem = problemOfPart(request);
  if (problem.empty() && request.resolution != 0.0)
    problem = problemOfResolution(request.resolution, request.surface);
  return problem;
}

std::string
problemOfField(const ShapeField& field, const void* cloud, std::size_t size)
{
  if (field.isOf(cloud, size))
    return {};
  return "the shape field is of another cloud (of " +
         std::to_string(field.points.size) + " points, the input has " +
         std::to_string(size) + "): compute it for the input";
}

std::vector<std::string>
classNames(const ShapeModel& model)
{
  std::vector<std::string> names;
  for (const ShapeModel::Class& c : model.classes())
    names.push_back(c.name);
  return names;
}

ShapeField
estimateField(const FieldRequest& request)
{
  const DistinctPoints distinct = distinctPoints(request.surface);
  Base base = baseOf(request, distinct);
  ShapeField field = std::move(base.field);
  if (field.points.first != request.input.first) {
    const bool is_of_input =
        request.surface.first == request.input.first && !base.is_other;
    std::vector<std::int32_t> base_points = is_of_input ? distinct.place
                                                        : nearestMeans(request.input,
                                                                       field.points,
                                                                       field.spacings,
                                                                       field.resolution,
                                                                       request.threads);
    field = scattered(pcl::make_shared<const ShapeField>(std::move(field)),
                      std::move(base_points));
    field.cloud = request.input_owner;
    field.points = request.input;
  }
  if (request.indices->size() != request.input.size)
    restrict(field, *request.indices);
  return field;
}

} // namespace pcl::detail

PCL_INSTANTIATE(ShapeFieldEstimation, PCL_SHAPE_POINT_TYPES)
