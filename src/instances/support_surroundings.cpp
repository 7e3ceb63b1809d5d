// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What is around a flat part: things on it, its own sides.

#include "instances/support_surroundings.h"

#include "common/parallel.h"
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
// Of 16 directions along the plane, in which there are nodes of the part. Beside a
// straight border there are 8, beside a round one fewer; 9 or 10 with ripple.
constexpr int directions = 16, min_directions_inside = 11;

/** Where a part of a plane is, by some of its nodes. */
class Extent {
public:
  explicit Extent(const SupportPart& part)
  : x_(part.support.plane.normal.unitOrthogonal())
  , y_(part.support.plane.normal.cross(x_))
  , positions_(placesOf(part.nodes))
  {
    for (const Vector3f& position : positions_)
      places_.push_back(along(position));
  }

  bool
  isNear(const Vector3f& position, float reach) const
  {
    return segmentation::isNear(position, positions_, reach);
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

/** What a node is to a part of a plane. */
struct Relation {
  bool is_on = false, is_side = false;
  bool is_before = false, is_on_top = false, is_behind = false; ///< and near it
};

class Neighborhood {
public:
  explicit Neighborhood(const SupportPart& part, float unit)
  : support_(part.support)
  , extent_(part)
  , nodes_(positionsOf(part.nodes), around_spacings * unit)
  , side_reach_(side_depth * static_cast<float>(std::sqrt(part.area)))
  , band_(std::max(max_ripple, part.support.offset))
  {}

  Relation
  of(const SurfaceNode& node) const
  {
    Relation relation;
    relation.is_on = isOn(node, support_);
    const float height = heightOf(node, support_.plane);
    if (relation.is_on || std::abs(height) < band_)
      return relation;
    relation.is_side = height < 0.0f && isSteep(node) &&
                       extent_.isNear(node.position, side_reach_) &&
                       !extent_.isInside(node.position);
    if (!isNear(node))
      return relation;
    const bool is_inside = extent_.isInside(node.position);
    relation.is_before = height > 0.0f;
    relation.is_on_top = relation.is_before && is_inside;
    // Inside it is noise: nobody sees through a support.
    relation.is_behind = height < 0.0f && !is_inside;
    return relation;
  }

private:
  bool
  isSteep(const SurfaceNode& node) const
  {
    return std::abs(node.normal.dot(support_.plane.normal)) < max_cosine;
  }

  bool
  isNear(const SurfaceNode& node) const
  {
    return nodes_.anyWithin(node.position,
                            around_spacings * node.spacing,
                            [](std::uint32_t, const Vector3f&) { return true; });
  }

  SupportPlane support_;
  Extent extent_;
  PointGrid nodes_; ///< of the part
  float side_reach_, band_;
};

} // namespace

Surroundings
surroundingsOf(const SupportPart& part,
               const Nodes& nodes,
               float unit,
               unsigned threads)
{
  const Neighborhood neighborhood(part, unit);
  std::vector<Relation> relations(nodes.size());
  kernels::parallelForEach(nodes.size(), threads, [&](std::size_t k) {
    relations[k] = neighborhood.of(nodes[k]);
  });
  Surroundings around;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const Relation& relation = relations[k];
    const double area = areaOf(nodes[k], unit);
    around.others += relation.is_on ? 0.0 : area;
    around.sides += relation.is_side ? area : 0.0;
    around.before += relation.is_before ? area : 0.0;
    around.on_top += relation.is_on_top ? area : 0.0;
    around.behind += relation.is_behind ? area : 0.0;
  }
  return around;
}

} // namespace pcl::segmentation
