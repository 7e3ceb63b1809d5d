// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "edges/edge_types.h"

#include "common/finite.h"
#include "common/parallel.h"
#include "edges/crease_votes.h"
#include "geometry/point_grid.h"

#include "features/adaptive_inad.h"

#include <pcl/segmentation/shape_field.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <bitset>
#include <cmath>

namespace pcl::segmentation {
namespace {

using Eigen::Vector3f;

// doc/method.md has the reason of each number.
constexpr float around_fits = 0.75f; // where fits see all faces of a corner
constexpr float ring_fits = 2.0f;    // and one to two, where they see two
constexpr float line_spacings = 1.5f;
constexpr float other_direction = 0.7071f; // cosine of 45 degrees
constexpr std::size_t least_points = 3;    // of each of a corner's creases

/** True if so many of them are more than 45 degrees from so many others. */
bool
differ(const std::vector<Vector3f>& directions)
{
  return std::any_of(directions.begin(), directions.end(), [&](const Vector3f& one) {
    std::size_t along = 0, across = 0;
    for (const Vector3f& other : directions)
      ++(std::abs(one.dot(other)) > other_direction ? along : across);
    return std::min(along, across) >= least_points;
  });
}

} // namespace

CreaseCorners::CreaseCorners(const ShapeField& edges)
: creases_(edges.creases)
, fit_(fitSpacings(edges.noise))
, grid_(positionsOf(creases_),
        fit_ * *std::max_element(edges.spacings.begin(), edges.spacings.end()))
{}

CreaseCorners::Directions
CreaseCorners::around(const Vector3f& center, float reach) const
{
  Directions directions;
  grid_.forEachWithin(center, reach, [&](std::uint32_t k, float) {
    directions.push_back(Eigen::Map<const Vector3f>(creases_[k].direction.data()));
  });
  return directions;
}

CreaseCorners::Directions
CreaseCorners::leadingTo(const Vector3f& center, float spacing) const
{
  const float inner = fit_ * spacing;
  const float off = line_spacings * spacing;
  Directions directions;
  grid_.forEachWithin(center, ring_fits * inner, [&](std::uint32_t k, float d2) {
    const Vector3f direction = Eigen::Map<const Vector3f>(creases_[k].direction.data());
    const Vector3f position = Eigen::Map<const Vector3f>(creases_[k].position.data());
    const bool leads = direction.cross(position - center).squaredNorm() < off * off;
    if (d2 > inner * inner && leads)
      directions.push_back(direction);
  });
  return directions;
}

bool
CreaseCorners::areAt(const Vector3f& center, float spacing) const
{
  return differ(around(center, around_fits * fit_ * spacing)) &&
         differ(leadingTo(center, spacing));
}

} // namespace pcl::segmentation

namespace pcl::detail {
namespace {

using namespace segmentation;
using Eigen::Vector3f;

// doc/method.md has the reason of each number.
constexpr float boundary_spacings = 2.5f;
constexpr unsigned sectors = 16;
constexpr unsigned empty_sectors = 6; // 135 degrees

/** Which of the sectors around the origin a direction is in. */
unsigned
sectorOf(float x, float y)
{
  constexpr float pi = 3.14159265f;
  const float turn = (std::atan2(y, x) + pi) / (2.0f * pi);
  return std::min(sectors - 1, static_cast<unsigned>(turn * sectors));
}

/** True if so many sectors in a row are empty. */
bool
hasGap(const std::bitset<sectors>& taken)
{
  unsigned run = 0;
  for (unsigned s = 0; s < 2 * sectors; ++s) {
    run = taken[s % sectors] ? 0 : run + 1;
    if (run >= empty_sectors)
      return true;
  }
  return false;
}

/** True where the neighbors leave a wide sector of the tangent plane empty. */
bool
isOnBoundary(const ShapeField& edges,
             const PointGrid& grid,
             std::size_t i)
{
  const Vector3f normal = edges.normals[i];
  const Vector3f x = normal.unitOrthogonal(), y = normal.cross(x);
  const Vector3f center = positionOf(edges.points, i);
  std::bitset<sectors> taken;
  grid.forEachWithin(
      center, boundary_spacings * edges.spacings[i], [&](std::uint32_t j, float d2) {
        const Vector3f d = positionOf(edges.points, j) - center;
        if (d2 > 0.0f)
          taken.set(sectorOf(d.dot(x), d.dot(y)));
      });
  return hasGap(taken);
}

} // namespace

std::vector<EdgeType>
edgeTypes(const ShapeField& edges, double threshold, unsigned threads)
{
  const std::size_t size = edges.points.size;
  const float most = *std::max_element(edges.spacings.begin(), edges.spacings.end());
  const PointGrid grid(edges.points, most);
  const CreaseCorners corners(edges);
  std::vector<EdgeType> types(size, EdgeType::None);
  kernels::parallelForRanges(
      size, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          if (!kernels::isFinite(edges.points[i]) || std::isnan(edges.edge_likelihood[i]))
            continue;
          if (edges.edge_likelihood[i] > 1.0 - threshold)
            types[i] = corners.areAt(positionOf(edges.points, i), edges.spacings[i])
                           ? EdgeType::Corner
                           : EdgeType::Crease;
          else if (isOnBoundary(edges, grid, i))
            types[i] = EdgeType::OpenBoundary;
        }
      });
  return types;
}

} // namespace pcl::detail
