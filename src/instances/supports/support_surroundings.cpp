// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What is around a flat part: things on it, its own sides, what is above and below.

#include "instances/supports/support_surroundings.h"

#include "common/parallel.h"
#include "geometry/point_grid.h"
#include "instances/extent.h"

#include <algorithm>
#include <cmath>

namespace pcl::segmentation {
namespace {

using Eigen::Vector3f;
using Nodes = std::vector<SurfaceNode>;

constexpr float max_cosine = 0.7f; // of 45 degrees: a side is steep
// Of the width of a part. The rim of a table is far thinner, a box as deep at least.
constexpr float side_depth = 0.25f;
// Half of that, and still deeper than a rim: the lower halves of a box's sides count.
constexpr float rim_depth = 0.125f;

/** What a node is to a part of a plane. */
struct Relation {
  bool is_on = false, is_side = false, is_lower = false;
  bool is_through = false;
  bool is_before = false, is_on_top = false, is_behind = false; ///< and near it
};

class Neighborhood {
public:
  Neighborhood(const SupportPart& part, float unit)
  : Neighborhood(part, placesOf(part.nodes), unit)
  {}

  Relation
  of(const SurfaceNode& node) const
  {
    Relation relation;
    relation.is_on = isOn(node, part_.support);
    const float height = heightOf(node, part_.support.plane);
    if (relation.is_on || std::abs(height) < band_)
      return relation;
    const bool is_low = height < 0.0f, is_steep = isSteep(node.normal, part_);
    const bool may_be_beside = is_low && isNear(node.position, places_, side_reach_);
    const bool is_near = isNear(node.position, nodes_, around_spacings * node.spacing);
    const bool is_inside =
        (may_be_beside || is_near) && extent_.isInside(node.position);
    const bool is_beside = may_be_beside && !is_inside;
    relation.is_through = is_low && is_inside;
    relation.is_side = is_beside && is_steep;
    relation.is_lower = is_beside && (!is_steep || -height * node.spacing > rim_depth_);
    relation.is_before = is_near && height > 0.0f;
    relation.is_on_top = relation.is_before && is_inside;
    relation.is_behind = is_near && is_low && !is_inside;
    return relation;
  }

private:
  Neighborhood(const SupportPart& part, const Nodes& some, float unit)
  : part_(part)
  , extent_(part.support.plane.normal, positionsOf(some))
  , side_reach_(side_depth * static_cast<float>(std::sqrt(part.area)))
  , rim_depth_(rim_depth * static_cast<float>(std::sqrt(part.area)))
  , places_(positionsOf(some), side_reach_)
  , nodes_(positionsOf(part.nodes), around_spacings * unit)
  , band_(bandOf(part))
  {}

  const SupportPart& part_;
  Extent extent_;
  float side_reach_, rim_depth_; ///< meters
  PointGrid places_, nodes_;     ///< of some nodes of the part, and of all
  float band_;
};

} // namespace

bool
isSteep(const Vector3f& normal, const SupportPart& part)
{
  return std::abs(normal.dot(part.support.plane.normal)) < max_cosine;
}

float
bandOf(const SupportPart& part)
{
  return std::max(max_ripple, part.support.offset);
}

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
    around.lower += relation.is_lower ? area : 0.0;
    around.through += relation.is_through ? area : 0.0;
    around.before += relation.is_before ? area : 0.0;
    around.on_top += relation.is_on_top ? area : 0.0;
    around.behind += relation.is_behind ? area : 0.0;
  }
  return around;
}

Levels
levelsOf(const SupportPart& part, const Nodes& nodes, float unit, unsigned threads)
{
  const Extent extent(part.support.plane.normal, positionsOf(placesOf(part.nodes)));
  const float band = bandOf(part);
  const Vector3f& center = part.support.plane.center;
  std::vector<char> is_above(nodes.size(), 0);
  kernels::parallelForEach(nodes.size(), threads, [&](std::size_t k) {
    is_above[k] = heightOf(nodes[k], part.support.plane) > band &&
                  extent.isInside(nodes[k].position);
  });
  Levels levels;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const double area = areaOf(nodes[k], unit);
    levels.above += is_above[k] ? area : 0.0;
    const float tilt = max_plane_tilt * (nodes[k].position - center).norm();
    const float below = -heightOf(nodes[k], part.support.plane) - band;
    levels.below += below * nodes[k].spacing > tilt ? area : 0.0;
  }
  return levels;
}

} // namespace pcl::segmentation
