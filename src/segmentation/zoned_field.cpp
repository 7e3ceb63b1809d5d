// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The field of a cloud whose zones have resolutions of their own.

#include "segmentation/zoned_field.h"

#include "common/gathered.h"
#include "common/statistics.h"
#include "geometry/point_grid.h"
#include "segmentation/field_stages.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

namespace pcl::detail {
namespace {

using namespace segmentation;

/** The field of a zone's places and of those around them: all that its edges depend on.
 * Faces end there; their classes do, too, but for windows that are cut. A zone is of a
 * few octaves of spacings, which is no uneven cloud (see fieldOfPoints()). */
ShapeField
fieldOfZone(const FieldRequest& request, const ResolutionZone& zone)
{
  FieldRequest of_zone = request;
  of_zone.resolution = zone.resolution;
  of_zone.of_cloud = zone.numbers;
  of_zone.index = nullptr;
  return fieldOf(of_zone, nullptr, neighborhoodsOf(of_zone, zone.points));
}

template <typename T>
void
append(const std::vector<T>& from, const std::vector<bool>& chosen, std::vector<T>& to)
{
  for (std::size_t i = 0; i < from.size(); ++i)
    if (chosen[i])
      to.push_back(from[i]);
}

/** The creases that have most of the places around them in the zone. */
void
appendCreases(const ShapeField& from,
              const std::vector<bool>& is_own,
              std::vector<CreasePoint>& to)
{
  const PointGrid grid(from.points, 2.0f * medianSpacing(from.spacings));
  for (const CreasePoint& crease : from.creases) {
    std::ptrdiff_t own = 0;
    grid.forEachWithin(Eigen::Map<const Eigen::Vector3f>(crease.position.data()),
                       crease.spacing,
                       [&](std::uint32_t i, float) { own += is_own[i] ? 1 : -1; });
    if (own > 0)
      to.push_back(crease);
  }
}

} // namespace

ShapeField
zonedField(const FieldRequest& request, const std::vector<ResolutionZone>& zones)
{
  ShapeField field;
  const auto positions = std::make_shared<std::vector<float>>();
  for (const ResolutionZone& zone : zones) {
    const ShapeField of_zone = fieldOfZone(request, zone);
    for (std::size_t i = 0; i < zone.is_own.size(); ++i)
      if (zone.is_own[i])
        positions->insert(positions->end(), of_zone.points[i], of_zone.points[i] + 3);
    append(of_zone.spacings, zone.is_own, field.spacings);
    append(of_zone.normals, zone.is_own, field.normals);
    append(of_zone.edge_likelihood, zone.is_own, field.edge_likelihood);
    appendCreases(of_zone, zone.is_own, field.creases);
    field.classes = of_zone.classes;
    field.likelihoods.resize(of_zone.likelihoods.size());
    for (std::size_t c = 0; c < of_zone.likelihoods.size(); ++c)
      append(of_zone.likelihoods[c], zone.is_own, field.likelihoods[c]);
    field.noise = std::max(field.noise, of_zone.noise);
    field.noise_level = std::max(field.noise_level, of_zone.noise_level);
    field.resolution = zone.resolution;
  }
  field.finest_resolution = zones.front().resolution;
  field.cloud = positions;
  field.points = viewOfPositions(*positions);
  return field;
}

} // namespace pcl::detail
