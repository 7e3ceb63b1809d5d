// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Faces as a whole: how large they are, whether planar, and their primitives.

#include "instances/faces/faces.h"

#include "common/parallel.h"
#include "common/quiet.h"
#include "geometry/point_grid.h"
#include "geometry/principal_axes.h"
#include "instances/primitives/instance_primitive.h"

#include <algorithm>
#include <cmath>

namespace pcl::segmentation {
namespace {

using detail::InstanceInput;

constexpr std::size_t max_points = 500; // to fit: there may be hundreds of faces
constexpr double area_per_point = 0.26; // 12 of 13 points are within one spacing

/** Of a strip with points at these places: that of an even one is so many standard
 * deviations. */
double
lengthOf(const SurfaceSample& sample)
{
  const auto& points = sample.points->points;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto& point : points)
    mean += point.getVector3fMap().cast<double>();
  mean /= static_cast<double>(points.size());
  Scatter<double> sums;
  for (const auto& point : points)
    sums.add(point.getVector3fMap().cast<double>() - mean);
  const Eigen::Matrix3d scatter = sums.matrix();
  const Eigen::Vector3d axis = principalAxis(scatter, 2);
  const double variance = axis.dot(scatter * axis) / static_cast<double>(points.size());
  return std::sqrt(12.0 * variance) * sample.unit;
}

/** The simplest primitive that is as near to the points as their noise lets it. */
ShapePrimitive
surfaceOf(const InstanceInput& input, const SurfaceSample& sample, double planar)
{
  for (const PrimitiveType type :
       {PrimitiveType::Plane, PrimitiveType::Cylinder, PrimitiveType::Sphere}) {
    ShapePrimitive surface = fitTo(sample, type);
    if (surface.type != PrimitiveType::None && surface.residual < stepLimit(input)) {
      enlarge(sample.unit, surface);
      return surface;
    }
    if (planar > planar_threshold)
      break;
  }
  return {};
}

} // namespace

std::vector<Face>
facesOf(const InstanceInput& input, const Labels& labels)
{
  const std::int32_t last = *std::max_element(labels.begin(), labels.end());
  std::vector<Face> faces(static_cast<std::size_t>(last + 1));
  const double usual = medianSpacing(input);
  for (std::uint32_t i = 0; i < labels.size(); ++i) {
    if (labels[i] < 0)
      continue;
    const auto label = static_cast<std::size_t>(labels[i]);
    Face& face = faces[label];
    const double d = input.spacings[i] / usual;
    face.area += area_per_point * d * d;
    face.planar += std::isnan(input.likelihood[i]) ? 0.0 : input.likelihood[i];
    ++face.points;
  }
  const std::vector<std::vector<std::uint32_t>> members =
      membersInOrder(input, labels, faces.size(), [](std::uint32_t) { return true; });
  const detail::Quiet quiet;
  kernels::parallelFor(faces.size(), input.threads, [&](std::size_t f) {
    Face& face = faces[f];
    face.planar /= static_cast<double>(face.points);
    face.origin = positionOf(input.points, members[f].front());
    const SurfaceSample sample = sampleOf(input, members[f], max_points, face.origin);
    face.surface = surfaceOf(input, sample, face.planar);
    face.length = lengthOf(sample) / usual;
  });
  return faces;
}

} // namespace pcl::segmentation
