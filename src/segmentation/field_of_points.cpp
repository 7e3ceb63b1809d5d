// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The field of a cloud at its points, however uneven it is.

#include "segmentation/field_of_points.h"

#include "common/finite.h"
#include "common/gathered.h"
#include "common/parallel.h"
#include "common/statistics.h"
#include "features/spacing/even_sampling.h"
#include "geometry/cells_around.h"
#include "geometry/point_grid.h"
#include "geometry/voxel_means.h"
#include "segmentation/uneven_field.h"

#include <pcl/segmentation/cloud_reach.h>

#include <cmath>
#include <limits>
#include <map>
#include <numeric>

namespace pcl::detail {
namespace {

using namespace segmentation;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
// With more unknown points the spacing is looked at again: scans have as many strays.
constexpr double max_unknown = 0.02;
// Of 1,000 points 4.5 % are unknown where of all 2 % are: five times the deviation off.
// Mostly none of a hundred is, and these are enough: the edges tell in the end.
constexpr std::size_t sample_size = 1000, first_sample = 100;
constexpr double surely_too_many = 0.045;

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

/** Makes the field of a cloud from its points, or where these are too uneven from means
 * that even them out. */
class FieldOfPoints {
public:
  explicit FieldOfPoints(const FieldRequest& request)
  : request_(request)
  , surface_(neighborhoodsOf(request))
  , distances_(distancesToTwelfth(surface_))
  {}

  /** \param[in] toEdges whether the field goes on to edges */
  ShapeField
  make(const ToEdges& toEdges) const
  {
    const std::vector<float> spacings = spacingsOf(distances_);
    std::size_t unknown = 0;
    Conditions conditions;
    conditions.to_edges = [&](const MeasuredCloud& cloud, const ShapeField& measured) {
      MeasuredCloud with_distances = cloud;
      with_distances.distances = &distances_;
      if (!toEdges(with_distances, measured))
        return false;
      const auto shareOf = [&](std::size_t sample) {
        return shareUnknown(
            surface_, spacings, sample, cloud.noise.level, request_.threads);
      };
      if (request_.has_normals || shareOf(first_sample) == 0.0)
        return true;
      const double share = shareOf(sample_size);
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
    return fieldOf(request_, request_.surface_owner, surface_, spacings, conditions);
  }

  /** The field of means if fewer are unknown then; else that of the points as they are.
   */
  ShapeField
  ofEvenMeans(std::size_t unknown, const std::vector<float>& spacings) const
  {
    const std::vector<float> even_spacings = evenSpacingsOf(distances_);
    const std::vector<float> even =
        evenSampling(request_.surface, even_spacings, request_.threads);
    NoiseLevel noise;
    Conditions conditions;
    conditions.to_edges = [&](const MeasuredCloud& cloud, const ShapeField&) {
      noise = cloud.noise;
      return true;
    };
    const ShapeField means = fieldOf(request_,
                                     nullptr,
                                     neighborhoodsOf(request_, even),
                                     {true, nullptr},
                                     conditions);
    const std::vector<std::int32_t> stands_for = representatives(
        request_.surface, means.points, means.spacings, request_.threads);
    // Where some points told it, `unknown` may be off by a tenth; means leave few.
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
    numbers.spacing = medianSpacing(field.spacings);
    numbers.distance = static_cast<double>(numbers.spacing);
    numbers.noise = field.noise;
    setNoiseLevel(noise, numbers);
    const pcl::Indices near = pointsNearOwn(keeps_own, field.spacings, numbers);
    field.normals.assign(field.spacings.size(), Eigen::Vector3f::Constant(nan));
    field.edge_likelihood.assign(field.spacings.size(), nan);
    if (near.empty())
      return;
    const std::vector<float> places = positionsAt(request_.surface, near);
    const std::vector<float> near_spacings = gathered(field.spacings, near);
    FieldRequest of_near = request_;
    of_near.of_cloud = numbers;
    of_near.edges_only = true;
    of_near.index = nullptr;
    const ShapeField edges = fieldOf(
        of_near, nullptr, neighborhoodsOf(of_near, places), {true, &near_spacings});
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
    // In spacings of the points that keep their own: these may differ a hundredfold.
    const double reach =
        reachOf(numbers, request_.edge_model).edges / mostSpacing(numbers.distance);
    std::map<int, std::vector<float>> own; // by the octave of their spacing
    std::vector<char> is_near(keeps_own.size(), 0);
    for (std::size_t i = 0; i < keeps_own.size(); ++i)
      if (const float* const p = request_.surface[i];
          keeps_own[i] && kernels::isFinite(p)) {
        std::vector<float>& of_octave = own[std::ilogb(spacings[i])];
        of_octave.insert(of_octave.end(), p, p + 3);
        is_near[i] = 1;
      }
    for (const auto& [octave, places] : own)
      markNear(places, static_cast<float>(std::ldexp(reach, octave + 1)), is_near);
    pcl::Indices near;
    for (std::size_t i = 0; i < is_near.size(); ++i)
      if (is_near[i])
        near.push_back(static_cast<pcl::index_t>(i));
    return near;
  }

  /** Marks the points that are nearer to some places than a reach. */
  void
  markNear(const std::vector<float>& places,
           float reach,
           std::vector<char>& is_near) const
  {
    const XYZView view = viewOfPositions(places);
    const PointGrid grid(view, reach, request_.threads);
    CellsAround cells(reach, 1, view.size);
    for (std::size_t k = 0; k < view.size; ++k)
      cells.add(positionOf(view, k));
    const auto any = [](std::uint32_t, const Eigen::Vector3f&) { return true; };
    kernels::parallelForEach(is_near.size(), request_.threads, [&](std::size_t i) {
      if (is_near[i] || !kernels::isFinite(request_.surface[i]))
        return;
      const Eigen::Vector3f place = positionOf(request_.surface, i);
      if (cells.mayHold(place) && grid.anyWithin(place, reach, any))
        is_near[i] = 1;
    });
  }

  const FieldRequest& request_;
  Neighborhoods surface_;
  std::vector<float> distances_; ///< of each point to its 12th neighbor
};

} // namespace

ShapeField
fieldOfPoints(const FieldRequest& request, const ToEdges& toEdges)
{
  if (!request.of_cloud)
    return FieldOfPoints(request).make(toEdges);
  Conditions conditions;
  conditions.to_edges = toEdges;
  return fieldOf(
      request, request.surface_owner, neighborhoodsOf(request), {}, conditions);
}

} // namespace pcl::detail
