// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Primitives fitted to the points of instances and faces.

#include "instances/primitives/instance_primitive.h"

#include "common/quiet.h"
#include "geometry/point_choice.h"
#include "geometry/point_grid.h"

#include <utility>

pcl::segmentation::SurfaceSample
pcl::segmentation::sampleOf(const detail::InstanceInput& input,
                            const std::vector<std::uint32_t>& members,
                            std::size_t max_points,
                            const Eigen::Vector3f& origin)
{
  const std::size_t step = (members.size() + max_points - 1) / max_points;
  std::vector<std::uint32_t> some;
  double spacings = 0.0;
  for (std::size_t k = 0; k < members.size(); k += step)
    if (normalOf(input, members[k]).allFinite()) {
      some.push_back(members[k]);
      spacings += input.spacings[members[k]];
    }
  SurfaceSample sample;
  sample.unit = static_cast<float>(spacings / static_cast<double>(some.size()));
  for (const std::uint32_t i : some)
    sample.add((positionOf(input.points, i) - origin) / sample.unit,
               normalOf(input, i));
  sample.tolerance = sample.first_tolerance = offsetLimit(input);
  return sample;
}

namespace pcl::detail {
namespace {

using namespace segmentation;
using Eigen::Vector3f;

constexpr std::size_t min_points = 20;   // three for each coefficient of a cylinder
constexpr std::size_t max_points = 2000; // more take time and change little
constexpr float simpler = 1.2f; // the one with more parameters must be clearly better

void
leaveEdgesOut(const InstanceInput& input, std::vector<std::uint32_t>& members)
{
  std::vector<std::uint32_t> inner;
  for (const std::uint32_t i : members)
    if (!(input.edge[i] > edge_threshold))
      inner.push_back(i);
  if (inner.size() >= min_points)
    members = std::move(inner);
}

/** The plane, unless another is clearly better: a large sphere is nearly one. */
ShapePrimitive
bestOf(const PrimitiveSample& sample)
{
  ShapePrimitive best = fitTo(sample, PrimitiveType::Plane);
  for (const PrimitiveType type : {PrimitiveType::Sphere, PrimitiveType::Cylinder}) {
    ShapePrimitive other = fitTo(sample, type);
    if (other.type != PrimitiveType::None &&
        (best.type == PrimitiveType::None || simpler * other.residual < best.residual))
      best = std::move(other);
  }
  return best;
}

void
translate(const Vector3f& offset, ShapePrimitive& primitive)
{
  std::vector<float>& c = primitive.coefficients;
  Eigen::Map<Vector3f> first(c.data());
  if (primitive.type == PrimitiveType::Plane)
    c[3] -= first.dot(offset);
  else
    first += offset;
}

} // namespace

ShapePrimitive
fitPrimitive(const InstanceInput& input,
             std::vector<std::uint32_t> members,
             PrimitiveType type)
{
  if (type == PrimitiveType::None || members.empty())
    return {};
  leaveEdgesOut(input, members);
  sortByPosition(input.points, members);
  const Vector3f origin = positionOf(input.points, members[members.size() / 2]);
  const SurfaceSample sample = sampleOf(input, members, max_points, origin);
  if (sample.points->size() < min_points || !(sample.unit > 0.0f))
    return {};
  const Quiet quiet;
  ShapePrimitive primitive =
      type == PrimitiveType::Auto ? bestOf(sample) : fitTo(sample, type);
  if (primitive.type != PrimitiveType::None) {
    enlarge(sample.unit, primitive);
    translate(origin, primitive);
  }
  return primitive;
}

} // namespace pcl::detail
