// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What is around a flat part: things on it, its own sides.

#include "instances/support_surroundings.h"

#include "geometry/point_grid.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pcl::segmentation {
namespace {

using Eigen::Vector3f;
using Nodes = std::vector<SurfaceNode>;

constexpr float max_cosine = 0.7f; // of 45 degrees: a side is steep
// Of the width of a part. The rim of a table is far thinner, a box as deep at least.
constexpr float side_depth = 0.25f;
constexpr std::size_t max_looked_at = 500; // nodes of a part: enough for directions
// Of 16 directions along the plane, in which there are nodes of the part. Beside a
// straight border there are 8, beside a round one fewer; 9 or 10 with ripple.
constexpr int directions = 16, min_directions_inside = 11;

/** Where a part of a plane is, by some of its nodes. */
class Extent {
public:
  explicit Extent(const SupportPart& part)
  : x_(part.support.plane.normal.unitOrthogonal())
  , y_(part.support.plane.normal.cross(x_))
  {
    const std::size_t step = (part.nodes.size() + max_looked_at - 1) / max_looked_at;
    for (std::size_t k = 0; k < part.nodes.size(); k += step) {
      positions_.push_back(part.nodes[k].position);
      places_.push_back(along(part.nodes[k].position));
    }
  }

  bool
  isNear(const Vector3f& position, float reach) const
  {
    return std::any_of(positions_.begin(), positions_.end(), [&](const Vector3f& of) {
      return (of - position).squaredNorm() < reach * reach;
    });
  }

  /** Whether the part is on most sides of a place. */
  bool
  isInside(const Vector3f& position) const
  {
    const Eigen::Vector2f from = along(position);
    std::uint32_t seen = 0;
    for (const Eigen::Vector2f& place : places_)
      seen |= 1U << directionOf(place - from);
    int count = 0;
    for (; seen != 0; seen &= seen - 1)
      ++count;
    return count >= min_directions_inside;
  }

private:
  Eigen::Vector2f
  along(const Vector3f& position) const
  {
    return {x_.dot(position), y_.dot(position)};
  }

  static int
  directionOf(const Eigen::Vector2f& offset)
  {
    constexpr auto pi = static_cast<float>(M_PI);
    const float turns = (std::atan2(offset.y(), offset.x()) + pi) / (2.0f * pi);
    return std::clamp(static_cast<int>(turns * directions), 0, directions - 1);
  }

  Vector3f x_, y_;
  std::vector<Vector3f> positions_;
  std::vector<Eigen::Vector2f> places_; ///< likewise, along the plane
};

} // namespace

Surroundings
surroundingsOf(const SupportPart& part, const Nodes& nodes, float unit)
{
  const SupportPlane& support = part.support;
  const PointGrid grid(positionsOf(part.nodes), around_spacings * unit);
  const Extent extent(part);
  const float reach = side_depth * static_cast<float>(std::sqrt(part.area));
  const float band = std::max(max_ripple, support.offset);
  Surroundings around;
  for (const SurfaceNode& node : nodes) {
    if (isOn(node, support))
      continue;
    const double area = areaOf(node, unit);
    around.others += area;
    const float height = heightOf(node, support.plane);
    if (std::abs(height) < band)
      continue;
    const auto is_side = [&] {
      return std::abs(node.normal.dot(support.plane.normal)) < max_cosine &&
             extent.isNear(node.position, reach) && !extent.isInside(node.position);
    };
    around.sides += height < 0.0f && is_side() ? area : 0.0;
    if (!grid.anyWithin(node.position,
                        around_spacings * node.spacing,
                        [](std::uint32_t, const Vector3f&) { return true; }))
      continue;
    const bool is_inside = extent.isInside(node.position);
    if (height > 0.0f)
      around.before += area;
    if (height > 0.0f && is_inside)
      around.on_top += area;
    if (height < 0.0f &&
        !is_inside) // inside it is noise: nobody sees through a support
      around.behind += area;
  }
  return around;
}

} // namespace pcl::segmentation
