// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Makes a field stage by stage: what is measured, edges, surfaces.

#include "segmentation/field_stages.h"

#include "common/gathered.h"
#include "features/models/class_evidence.h"
#include "surfaces/surface_classification.h"

namespace pcl::detail {

Neighborhoods
neighborhoodsOf(const FieldRequest& request)
{
  Neighborhoods neighborhoods(request.surface, request.threads);
  if (request.makeFinder)
    neighborhoods.setFinder(request.makeFinder({}));
  neighborhoods.setIndex(request.index);
  return neighborhoods;
}

Neighborhoods
neighborhoodsOf(const FieldRequest& request, const std::vector<float>& others)
{
  Neighborhoods neighborhoods(viewOfPositions(others), request.threads);
  if (request.makeFinder && !others.empty())
    neighborhoods.setFinder(request.makeFinder(others));
  neighborhoods.setIndex(request.index);
  return neighborhoods;
}

ShapeField
fieldOf(const FieldRequest& request,
        const shared_ptr<const void>& owner,
        const Neighborhoods& neighborhoods,
        const Spacings& spacings,
        const Conditions& conditions)
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
  field.resolution = field.finest_resolution = request.resolution;
  const MeasuredCloud measured = spacings.known
                                     ? measureCloud(input, *spacings.known, field)
                                     : measureCloud(input, field);
  if (!conditions.to_edges(measured, field))
    return field;
  findEdges(input, measured, ShapeEvidence(request.edge_model), field);
  if (conditions.to_surfaces(field) && !request.edges_only)
    classifySurfaces(input, request.surface_model, field);
  return field;
}

} // namespace pcl::detail
