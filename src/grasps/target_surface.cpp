// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The known points of a target and the points around it, to look places up in.

#include "grasps/target_surface.h"

#include "common/finite.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <tuple>

namespace pcl::segmentation {
namespace {

using Eigen::Vector3f;
using Point = TargetSurface::Point;

std::vector<Point>
knownPoints(const detail::GraspTarget& target)
{
  std::vector<Point> points;
  for (std::size_t k = 0; k < target.points.size(); ++k) {
    const Point point{positionOf(target.cloud, target.points[k]),
                      Eigen::Map<const Vector3f>(&target.normals[3 * k]),
                      target.spacings[k],
                      target.edge_likelihood[k] > 0.5f,
                      static_cast<std::uint32_t>(k)};
    if (point.position.allFinite() && point.normal.allFinite())
      points.push_back(point);
  }
  std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) {
    const Vector3f &p = a.position, &q = b.position;
    return std::tie(p.z(), p.y(), p.x(), a.source) <
           std::tie(q.z(), q.y(), q.x(), b.source);
  });
  return points;
}

/** Points of the cloud, but not of the target, that are near it. */
std::vector<Vector3f>
pointsAround(const detail::GraspTarget& target,
             const std::vector<Point>& points,
             float reach)
{
  Eigen::AlignedBox3f box;
  for (const Point& point : points)
    box.extend(point.position);
  std::vector<char> is_target(target.cloud.size, 0);
  for (const std::uint32_t i : target.points)
    is_target[i] = 1;
  std::vector<Vector3f> others;
  for (std::size_t i = 0; i < target.cloud.size; ++i) {
    if (is_target[i] || !kernels::isFinite(target.cloud[i]))
      continue;
    const Vector3f position = positionOf(target.cloud, i);
    if (box.squaredExteriorDistance(position) < reach * reach)
      others.push_back(position);
  }
  return others;
}

} // namespace

TargetSurface::TargetSurface(const detail::GraspTarget& target, float reach, float cell)
: points_(knownPoints(target))
, others_(pointsAround(target, points_, reach))
, noise_(static_cast<float>(target.noise))
, grid_(viewOf(points_), cell)
, others_grid_(viewOf(others_), cell)
{}

} // namespace pcl::segmentation
