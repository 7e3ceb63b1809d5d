// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "common/quiet.h"
#include "geometry/primitives.h"

#include <algorithm>
#include <tuple>

namespace pcl::detail {
namespace {

using Eigen::Vector3f;
using segmentation::enlarge;
using segmentation::fitTo;
using segmentation::PrimitiveSample;

// doc/instances.md has the reason of each number.
constexpr std::size_t least_points = 20;
constexpr std::size_t most_points = 2000;
constexpr float simpler = 1.2f;

struct Sample : PrimitiveSample {
  Vector3f origin = Vector3f::Zero(); ///< of the points
  float unit = 0.0f;                  ///< metres, the mean spacing
};

/** The order of the points must not matter to what RANSAC draws. */
void
sortByPosition(const InstanceInput& input, std::vector<std::uint32_t>& members)
{
  std::sort(members.begin(), members.end(), [&](std::uint32_t a, std::uint32_t b) {
    const float* p = input.points[a];
    const float* q = input.points[b];
    return std::tie(p[0], p[1], p[2]) < std::tie(q[0], q[1], q[2]);
  });
}

void
leaveEdgesOut(const InstanceInput& input, std::vector<std::uint32_t>& members)
{
  std::vector<std::uint32_t> inner;
  for (const std::uint32_t i : members)
    if (!(input.edge[i] > segmentation::edge_threshold))
      inner.push_back(i);
  if (inner.size() >= least_points)
    members = std::move(inner);
}

Sample
sampleOf(const InstanceInput& input, const std::vector<std::uint32_t>& members)
{
  Sample sample;
  const std::size_t step = (members.size() + most_points - 1) / most_points;
  sample.origin = segmentation::positionOf(input.points, members[members.size() / 2]);
  std::vector<std::uint32_t> some;
  double spacings = 0.0;
  for (std::size_t k = 0; k < members.size(); k += step)
    if (segmentation::normalOf(input, members[k]).allFinite()) {
      some.push_back(members[k]);
      spacings += input.spacings[members[k]];
    }
  sample.unit = static_cast<float>(spacings / static_cast<double>(some.size()));
  for (const std::uint32_t i : some) {
    const Vector3f p =
        (segmentation::positionOf(input.points, i) - sample.origin) / sample.unit;
    const Vector3f n = segmentation::normalOf(input, i);
    sample.points->push_back({p.x(), p.y(), p.z()});
    sample.normals->push_back({n.x(), n.y(), n.z()});
  }
  sample.tolerance = segmentation::offsetLimit(input);
  sample.first_tolerance = sample.tolerance;
  return sample;
}

/** From the sample's origin and unit to the cloud's. */
void
moveToCloud(const Vector3f& origin, float unit, ShapePrimitive& primitive)
{
  enlarge(unit, primitive);
  std::vector<float>& c = primitive.coefficients;
  Eigen::Map<Vector3f> first(c.data());
  if (primitive.type == PrimitiveType::Plane) {
    c[3] -= first.dot(origin);
    return;
  }
  first += origin;
}

/** The plane, unless another is clearly better: a large sphere is nearly one. */
ShapePrimitive
bestOf(const Sample& sample)
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

} // namespace

ShapePrimitive
fitPrimitive(const InstanceInput& input,
             std::vector<std::uint32_t> members,
             PrimitiveType type)
{
  if (type == PrimitiveType::None || members.empty())
    return {};
  leaveEdgesOut(input, members);
  sortByPosition(input, members);
  const Sample sample = sampleOf(input, members);
  if (sample.points->size() < least_points || !(sample.unit > 0.0f))
    return {};
  const Quiet quiet;
  ShapePrimitive primitive =
      type == PrimitiveType::Auto ? bestOf(sample) : fitTo(sample, type);
  if (primitive.type != PrimitiveType::None)
    moveToCloud(sample.origin, sample.unit, primitive);
  return primitive;
}

} // namespace pcl::detail
