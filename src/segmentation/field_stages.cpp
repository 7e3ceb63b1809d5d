// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Makes a field stage by stage: what is measured, edges, surfaces.

#include "segmentation/field_stages.h"

#include "features/part_noise.h"
#include "surfaces/surface_classification.h"

namespace pcl::detail {
namespace {

/** \param[in] points that are not the surface's, or none */
NeighborFinder
finderAmong(const FieldRequest& request, const std::vector<float>& points)
{
  return request.makeFinder ? request.makeFinder(points) : NeighborFinder();
}

} // namespace

Surroundings::Surroundings(const FieldRequest& request,
                           const XYZView& points,
                           const NeighborFinder& finder)
: all_(allOf(points))
, neighborhoods_(points, points, all_, request.threads)
{
  neighborhoods_.setFinder(finder);
  neighborhoods_.setIndex(request.index);
}

Surroundings::Surroundings(const FieldRequest& request, const XYZView& points)
: Surroundings(request, points, finderAmong(request, {}))
{}

Surroundings::Surroundings(const FieldRequest& request,
                           const std::vector<float>& points)
: Surroundings(
      request, {points.data(), 3, points.size() / 3}, finderAmong(request, points))
{}

ShapeField
fieldOf(const FieldRequest& request,
        const shared_ptr<const void>& owner,
        const Surroundings& surroundings,
        const Spacings& spacings,
        const Conditions& conditions)
{
  const Neighborhoods& neighborhoods = surroundings.neighborhoods();
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

} // namespace pcl::detail
