// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Why points got no answer: what is wrong with their neighborhoods.

#include "common/finite.h"
#include "common/gathered.h"
#include "common/statistics.h"
#include "features/spacing/local_spacing.h"
#include "features/spacing/some_points.h"
#include "segmentation/field_places.h"

#include <pcl/features/distinct_points.h>
#include <pcl/segmentation/unknown_points.h>
#include <pcl/features/impl/neighborhoods.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace pcl {
namespace {

using namespace segmentation;

// Rounding then moves points by .15 spacings (the standard deviation is .29 of what
// they are rounded to), the noise from which the thinnest neighborhoods grow by half.
constexpr float coarse_float = 0.5f;

/** How far apart floats are at the largest coordinate of a point. */
float
floatSpacingAt(const float* p)
{
  const float largest = std::max({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
  return std::nextafter(largest, std::numeric_limits<float>::infinity()) - largest;
}

/** The finite places of a cloud, and what is asked about them. */
struct Places {
  std::vector<float> positions;             ///< three each
  std::vector<std::size_t> points, unknown; ///< how many are there
  std::vector<float> radii;

  XYZView
  view() const
  {
    return {positions.data(), 3, points.size()};
  }
};

Places
placesOf(const XYZView& points,
         const DistinctPoints& distinct,
         const std::vector<float>& values,
         const NeighborhoodSize& size)
{
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> place_at(
      distinct.hasRepeats() ? distinct.first.size() : points.size, none);
  Places places;
  for (std::size_t i = 0; i < points.size; ++i) {
    if (!kernels::isFinite(points[i]))
      continue;
    std::size_t& at =
        place_at[distinct.hasRepeats() ? static_cast<std::size_t>(distinct.place[i])
                                       : i];
    if (at == none) {
      at = places.points.size();
      places.positions.insert(places.positions.end(), points[i], points[i] + 3);
      places.points.push_back(0);
      places.unknown.push_back(0);
      if (size.radii)
        places.radii.push_back(size.radii[i]);
    }
    ++places.points[at];
    places.unknown[at] += std::isnan(values[i]) ? 1 : 0;
  }
  return places;
}

/** The median of places' distances to the nearest other one. */
float
spacingOf(const Places& places, unsigned threads)
{
  constexpr std::size_t some = 20000; // their median is known to 1 %
  if (places.points.size() < 2)
    return 0.0f;
  const pcl::Indices of_places = detail::somePoints(places.view(), some);
  const std::vector<std::int32_t> chosen(of_places.begin(), of_places.end());
  std::vector<float> distances(chosen.size());
  NeighborhoodSweep sweep(places.view());
  sweep.setQueryIndices(chosen.data(), chosen.size());
  sweep.setNumberOfThreads(threads);
  sweep.computeDistanceToNearest(2, distances.data());
  distances = finiteOf(std::move(distances));
  return distances.empty() ? 0.0f : median(std::move(distances));
}

/** Count the places that a sweep is asked about by what is wrong with them. */
void
countReasons(const Places& places,
             const std::vector<std::int32_t>& asked,
             const NeighborhoodSize& size,
             unsigned threads,
             UnknownPoints& result)
{
  NeighborhoodSweep sweep(places.view());
  sweep.setNumberOfThreads(threads);
  sweep.setQueryIndices(asked.data(), asked.size());
  std::vector<std::uint32_t> neighbors(
      asked.size(), static_cast<std::uint32_t>(std::min(size.k, places.points.size())));
  if (size.k == 0)
    sweep.countNeighbors(size, neighbors.data());
  std::vector<float> normals(4 * asked.size());
  sweep.computeNormals(size, normals.data(), normals.data() + 3, 4);
  for (std::size_t q = 0; q < asked.size(); ++q) {
    const auto place = static_cast<std::size_t>(asked[q]);
    const bool is_alone = size.k == 0 ? neighbors[q] == 0 && places.points[place] > 1
                                      : places.points[place] >= size.k;
    std::size_t& reason = is_alone ? result.at_one_place
                          : neighbors[q] < NeighborhoodSweep::min_neighbors
                              ? result.few_neighbors
                          : std::isnan(normals[4 * q]) ? result.on_a_line
                                                       : result.unknown_neighbors;
    reason += places.unknown[place];
  }
}

UnknownPoints
unknownAmong(const XYZView& points,
             const DistinctPoints& distinct,
             const std::vector<float>& values,
             const NeighborhoodSize& size,
             unsigned threads)
{
  if (values.size() != points.size)
    throw std::invalid_argument("there are " + std::to_string(values.size()) +
                                " values of " + std::to_string(points.size) +
                                " points: one for each is needed");
  UnknownPoints result;
  const Places places = placesOf(points, distinct, values, size);
  for (std::size_t i = 0; i < places.points.size(); ++i) {
    result.finite += places.points[i];
    result.unknown += places.unknown[i];
  }
  if (result.unknown == 0)
    return result;
  result.spacing = spacingOf(places, threads);
  std::vector<std::int32_t> asked;
  std::vector<float> radii;
  for (std::size_t i = 0; i < places.points.size(); ++i) {
    if (places.unknown[i] == 0)
      continue;
    const float of_floats = floatSpacingAt(&places.positions[3 * i]);
    result.float_spacing = std::max(result.float_spacing, of_floats);
    if (size.radii)
      radii.push_back(places.radii[i]);
    if (of_floats >= coarse_float * result.spacing && result.spacing > 0.0f) {
      result.rounded += places.unknown[i];
      continue;
    }
    asked.push_back(static_cast<std::int32_t>(i));
  }
  result.radius = size.radii ? median(radii) : static_cast<float>(size.radius);
  if (asked.empty())
    return result;
  std::vector<float> radii_asked;
  NeighborhoodSize of_asked = size;
  of_asked.k = std::min(size.k, places.points.size());
  if (size.radii) {
    radii_asked = detail::gathered(places.radii, asked);
    of_asked.radii = radii_asked.data();
  }
  countReasons(places, asked, of_asked, threads, result);
  return result;
}

} // namespace

UnknownPoints
unknownPoints(const XYZView& points,
              const std::vector<float>& values,
              const NeighborhoodSize& size,
              unsigned threads)
{
  return unknownAmong(points, distinctPoints(points), values, size, threads);
}

UnknownPoints
unknownPoints(const XYZView& points,
              const std::vector<float>& values,
              const INADParameters& parameters,
              unsigned threads)
{
  if (parameters.k > 0)
    return unknownPoints(
        points,
        values,
        NeighborhoodSize::ofNearest(static_cast<std::size_t>(parameters.k)),
        threads);
  const double radius = std::min(parameters.normal_radius, parameters.radius);
  if (parameters.radius_mode == AdaptiveRadius::FIXED)
    return unknownPoints(points, values, NeighborhoodSize::ofRadius(radius), threads);
  const std::vector<float> radii = detail::adaptiveRadii(
      parameters.radius_mode, radius, detail::Neighborhoods(points, threads));
  return unknownPoints(
      points, values, NeighborhoodSize::ofRadii(radii.data()), threads);
}

UnknownPoints
unknownPoints(const ShapeField& field, unsigned threads)
{
  const bool has_classes = !field.likelihoods.empty();
  const std::vector<float>& values =
      has_classes ? field.likelihoods.front() : field.edge_likelihood;
  const ShapeModel& model =
      has_classes ? ShapeModel::defaultSurfaces() : ShapeModel::defaultEdges();
  const INADParameters parameters =
      detail::withNoise(model.parameters(), field.noise_level);
  const auto spacings =
      static_cast<float>(std::min(parameters.normal_radius, parameters.radius));
  const float usual = medianSpacing(field.spacings);
  std::vector<float> radii;
  radii.reserve(field.spacings.size());
  for (const float spacing : field.spacings)
    radii.push_back(std::max(spacings * (std::isfinite(spacing) ? spacing : usual),
                             std::numeric_limits<float>::min()));
  return unknownAmong(field.points,
                      detail::distinctPoints(field),
                      values,
                      NeighborhoodSize::ofRadii(radii.data()),
                      threads);
}

} // namespace pcl
