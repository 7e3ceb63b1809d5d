// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Grasps on a field: the target that they are looked for on.

#include "grasps/suction_grasps.h"
#include "segmentation/compiled_estimations.h"
#include "segmentation/field_places.h"

#include <pcl/segmentation/impl/suction_grasp_estimation.hpp>

namespace pcl::detail {
namespace {

/** \param[in] field of places \param[in] indices the target among them */
GraspTarget
targetOf(const ShapeField& field,
         const pcl::Indices& indices,
         const GraspRequest& request)
{
  GraspTarget target;
  target.cloud = field.points;
  target.noise = field.noise;
  for (const index_t index : indices) {
    const auto i = static_cast<std::size_t>(index);
    target.points.push_back(static_cast<std::uint32_t>(index));
    target.edge_likelihood.push_back(field.edge_likelihood[i]);
    target.spacings.push_back(field.spacings[i]);
    const Eigen::Vector3f& normal = field.normals[i];
    const Eigen::Vector3f away = Eigen::Vector3f(field.points[i]) - request.view_point;
    const float outwards = normal.dot(away) > 0.0f ? -1.0f : 1.0f;
    for (const float component : normal)
      target.normals.push_back(outwards * component);
  }
  return target;
}

GraspSurface
surfaceOf(const ShapeField& field, const pcl::Indices& indices, std::uint32_t surface)
{
  GraspSurface of;
  of.surface = surface;
  for (const index_t index : indices)
    of.likelihood.push_back(
        field.likelihoods[surface - 1][static_cast<std::size_t>(index)]);
  return of;
}

} // namespace

std::string
problemOf(const GraspRequest& request)
{
  if (request.field.classes != std::vector<std::string>{"planar", "curved"})
    return "the classes of the shape field are not planar and curved: compute it "
           "without "
           "a surface model of your own";
  const FieldPlaces places(request.field);
  return problemOfCup(
      request.cup, targetOf(places.field(), places.placesOf(request.indices), request));
}

std::vector<SuctionGrasp>
findGrasps(const GraspRequest& request)
{
  const FieldPlaces places(request.field);
  const pcl::Indices indices = places.placesOf(request.indices);
  std::vector<GraspSurface> surfaces;
  if (request.planar)
    surfaces.push_back(surfaceOf(places.field(), indices, 1));
  if (request.curved)
    surfaces.push_back(surfaceOf(places.field(), indices, 2));
  return findGrasps(targetOf(places.field(), indices, request),
                    surfaces,
                    request.cup,
                    request.threads);
}

} // namespace pcl::detail

PCL_INSTANTIATE(SuctionGraspEstimation, PCL_SHAPE_POINT_TYPES)
