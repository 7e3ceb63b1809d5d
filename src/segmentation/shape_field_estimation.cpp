// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Makes a field: at the places of a cloud's points, or at voxel means or a search
// surface that stand for them.

#include "common/finite.h"
#include "common/gathered.h"
#include "common/number_text.h"
#include "common/point_types.h"
#include "geometry/voxel_means.h"
#include "segmentation/field_of_points.h"
#include "segmentation/field_places.h"
#include "segmentation/zoned_field.h"

#include <pcl/features/distinct_points.h>
#include <pcl/impl/instantiate.hpp>
#include <pcl/segmentation/means_of_parts.h>
#include <pcl/segmentation/impl/shape_field_estimation.hpp>

#include <algorithm>
#include <functional>
#include <limits>
#include <tuple>
#include <utility>

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

/** A field, and whether it is of other points than the surface's places. */
struct Base {
  ShapeField field;
  bool is_other = false;
};

/** \param[in] toEdges whether the field goes on to edges */
Base
baseOfMeans(const FieldRequest& request, const ToEdges& toEdges)
{
  const auto means = std::make_shared<const std::vector<float>>(
      voxelMeans(request.surface, request.resolution, request.threads));
  Conditions conditions;
  conditions.to_edges = toEdges;
  return {fieldOf(request, means, neighborhoodsOf(request, *means), {}, conditions),
          true};
}

CloudNumbers
numbersOf(const MeasuredCloud& measured)
{
  CloudNumbers numbers;
  numbers.spacing = measured.spacing;
  setNoiseLevel(measured.noise, numbers);
  return numbers;
}

/** Makes the field of the points, or of means that are coarse enough for the noise
 * which neighbors share: for that of all, or of each zone. */
class BaseMaker {
public:
  explicit BaseMaker(const FieldRequest& request) : request_(request), coarse_(request)
  {}

  Base
  make()
  {
    const auto toEdges = [this](const MeasuredCloud& measured,
                                const ShapeField& field) {
      return request_.has_normals || request_.of_cloud || isFineEnough(measured, field);
    };
    Base base = request_.resolution == 0.0
                    ? Base{fieldOfPoints(request_, toEdges), false}
                    : baseOfMeans(request_, toEdges);
    while (coarser_ > 0.0) {
      coarse_.resolution = coarser_;
      base = baseOfMeans(coarse_, toEdges);
    }
    return zones_.empty() ? std::move(base) : Base{zonedField(request_, zones_), true};
  }

private:
  /** Whether this resolution, of all of the cloud, is what it needs. */
  bool
  isFineEnough(const MeasuredCloud& measured, const ShapeField& field)
  {
    coarser_ =
        coarserResolution(numbersOf(measured), measured.places, coarse_.resolution);
    if (coarser_ > 0.0) {
      if (measured.distances)
        distances_ = *measured.distances;
      return false;
    }
    const bool was_noisy = coarse_.resolution > request_.resolution;
    if (!request_.one_resolution &&
        (was_noisy || mayHaveZones(field.points, field.spacings, request_.threads)))
      zones_ = resolutionZones(request_,
                               measured.distances ? *measured.distances : distances_,
                               was_noisy ? coarse_.resolution : 0.0);
    return zones_.empty();
  }

  const FieldRequest& request_;
  FieldRequest coarse_;
  double coarser_ = 0.0;         ///< than what was measured last, meters
  std::vector<float> distances_; ///< of points to their 12th neighbors, if known
  std::vector<ResolutionZone> zones_;
};

/** Of the normals that are given for a place the one with the least coordinates,
 * whatever their order; one that is finite if there is one. */
std::vector<float>
normalsOfPlaces(const XYZView& normals, const DistinctPoints& distinct)
{
  std::vector<float> result = unsignedZeros(positionsAt(normals, distinct.first));
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
    return BaseMaker(request).make();
  const auto places = std::make_shared<const std::vector<float>>(
      unsignedZeros(positionsAt(request.surface, distinct.first)));
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
  return BaseMaker(of_places).make();
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
  field.finest_resolution = base->finest_resolution;
  field.spacings = gathered(base->spacings, base_points, nan);
  field.normals = gathered(base->normals, base_points, Eigen::Vector3f::Constant(nan));
  field.edge_likelihood = gathered(base->edge_likelihood, base_points, nan);
  for (const auto& likelihood : base->likelihoods)
    field.likelihoods.push_back(gathered(likelihood, base_points, nan));
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
