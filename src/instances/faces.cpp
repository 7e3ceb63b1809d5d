// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "instances/faces.h"

#include "common/parallel.h"
#include "common/quiet.h"
#include "geometry/primitives.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace pcl::segmentation {
namespace {

using detail::InstanceInput;
using Members = std::vector<std::uint32_t>;

// doc/instances.md has the reason of each number.
constexpr std::size_t most_points = 500;
constexpr double area_per_point = 0.26; // 12 of 13 points are within one spacing
constexpr double planar_threshold = 0.5;

/** Some points of a face, evenly in the order of their coordinates. */
Members
someOf(const InstanceInput& input, Members members)
{
  std::sort(members.begin(), members.end(), [&](std::uint32_t a, std::uint32_t b) {
    const float* p = input.points[a];
    const float* q = input.points[b];
    return std::tie(p[0], p[1], p[2]) < std::tie(q[0], q[1], q[2]);
  });
  const std::size_t step = (members.size() + most_points - 1) / most_points;
  Members some;
  for (std::size_t k = 0; k < members.size(); k += step)
    some.push_back(members[k]);
  return some;
}

/** The simplest primitive that is as near to the points as their noise lets it. */
ShapePrimitive
surfaceOf(const InstanceInput& input, const Members& members, const Face& face)
{
  double spacings = 0.0;
  for (const std::uint32_t i : members)
    spacings += input.spacings[i];
  const auto unit = static_cast<float>(spacings / static_cast<double>(members.size()));
  PrimitiveSample sample;
  for (const std::uint32_t i : members) {
    const Eigen::Vector3f p = (positionOf(input.points, i) - face.origin) / unit;
    const Eigen::Vector3f n = normalOf(input, i);
    sample.points->push_back({p.x(), p.y(), p.z()});
    sample.normals->push_back({n.x(), n.y(), n.z()});
  }
  sample.tolerance = offsetLimit(input);
  sample.first_tolerance = sample.tolerance;
  for (const PrimitiveType type :
       {PrimitiveType::Plane, PrimitiveType::Cylinder, PrimitiveType::Sphere}) {
    ShapePrimitive surface = fitTo(sample, type);
    if (surface.type != PrimitiveType::None && surface.residual < stepLimit(input)) {
      enlarge(unit, surface);
      return surface;
    }
    if (face.planar > planar_threshold)
      break;
  }
  return {};
}

} // namespace

std::vector<Face>
facesOf(const InstanceInput& input, const Labels& labels)
{
  const std::int32_t most = *std::max_element(labels.begin(), labels.end());
  std::vector<Face> faces(static_cast<std::size_t>(most + 1));
  std::vector<Members> members(faces.size());
  const double median = medianSpacing(input);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] < 0)
      continue;
    Face& face = faces[static_cast<std::size_t>(labels[i])];
    members[static_cast<std::size_t>(labels[i])].push_back(
        static_cast<std::uint32_t>(i));
    const double d = input.spacings[i] / median;
    face.area += area_per_point * d * d;
    face.planar += std::isnan(input.likelihood[i]) ? 0.0 : input.likelihood[i];
    ++face.points;
  }
  const detail::Quiet quiet;
  kernels::parallelFor(faces.size(), input.threads, [&](std::size_t f) {
    Face& face = faces[f];
    face.planar /= static_cast<double>(face.points);
    const Members some = someOf(input, std::move(members[f]));
    face.origin = positionOf(input.points, some.front());
    face.surface = surfaceOf(input, some, face);
  });
  return faces;
}

} // namespace pcl::segmentation
