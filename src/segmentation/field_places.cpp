// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A field with each place once, however many points are there.

#include "segmentation/field_places.h"

#include "common/finite.h"
#include "common/gathered.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace pcl::detail {
namespace {

/** At each place a point that is known, if there is one. */
std::vector<std::size_t>
knownPoints(const ShapeField& field, const DistinctPoints& distinct)
{
  std::vector<std::size_t> known(distinct.first.begin(), distinct.first.end());
  for (std::size_t i = 0; i < field.points.size; ++i) {
    std::size_t& at = known[static_cast<std::size_t>(distinct.place[i])];
    if (std::isnan(field.spacings[at]) && !std::isnan(field.spacings[i]))
      at = i;
  }
  return known;
}

/** Whether the base has this point there. */
bool
isAt(const ShapeField& field, std::size_t i, std::int32_t place)
{
  if (place < 0 || static_cast<std::size_t>(place) >= field.base->points.size)
    return false;
  const float* const p = field.points[i];
  const float* const there = field.base->points[static_cast<std::size_t>(place)];
  return kernels::isFinite(p) ? std::equal(p, p + 3, there) : !kernels::isFinite(there);
}

/** The places that the base has; nothing if its points are others: means. */
std::optional<DistinctPoints>
placesOfBase(const ShapeField& field)
{
  const std::size_t size = field.points.size;
  if (field.base_points.size() != size || field.base->points.size >= size)
    return std::nullopt;
  DistinctPoints distinct;
  distinct.place = field.base_points;
  distinct.first.assign(field.base->points.size, -1);
  for (std::size_t i = 0; i < size; ++i) {
    const std::int32_t place = distinct.place[i];
    if (!isAt(field, i, place))
      return std::nullopt;
    std::int32_t& first = distinct.first[static_cast<std::size_t>(place)];
    if (first < 0)
      first = static_cast<std::int32_t>(i);
  }
  const auto& first = distinct.first;
  const bool is_complete = first.empty() || first.front() >= 0;
  return is_complete && std::is_sorted(first.begin(), first.end())
             ? std::make_optional(std::move(distinct))
             : std::nullopt;
}

} // namespace

DistinctPoints
distinctPoints(const ShapeField& field)
{
  if (!field.base) // else equal points would have one
    return {};
  std::optional<DistinctPoints> places = placesOfBase(field);
  return places ? *std::move(places) : pcl::distinctPoints(field.points);
}

std::vector<float>
unsignedZeros(std::vector<float> values)
{
  for (float& value : values)
    value += 0.0f;
  return values;
}

FieldPlaces::FieldPlaces(const ShapeField& field)
: given_(field)
, distinct_(distinctPoints(field))
{
  if (!hasRepeats())
    return;
  const std::vector<std::size_t> from = knownPoints(field, distinct_);
  positions_ = unsignedZeros(positionsAt(field.points, from));
  of_places_.points = viewOfPositions(positions_);
  of_places_.noise = field.noise;
  of_places_.noise_level = field.noise_level;
  of_places_.creases = field.creases;
  of_places_.classes = field.classes;
  of_places_.resolution = field.resolution;
  of_places_.finest_resolution = field.finest_resolution;
  of_places_.base = field.base;
  of_places_.spacings = gathered(field.spacings, from);
  of_places_.normals = gathered(field.normals, from);
  of_places_.edge_likelihood = gathered(field.edge_likelihood, from);
  for (const std::vector<float>& of_class : field.likelihoods)
    of_places_.likelihoods.push_back(gathered(of_class, from));
  of_places_.base_points = gathered(field.base_points, from);
}

pcl::Indices
FieldPlaces::placesOf(const pcl::Indices& points) const
{
  if (!hasRepeats())
    return points;
  pcl::Indices places;
  std::vector<char> is_there(distinct_.first.size(), 0);
  for (const index_t point : points) {
    const std::size_t place = placeOf(static_cast<std::size_t>(point));
    if (is_there[place] == 0)
      places.push_back(static_cast<index_t>(place));
    is_there[place] = 1;
  }
  return places;
}

} // namespace pcl::detail
