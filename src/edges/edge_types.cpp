// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What kind of edge each point is: a crease, a corner or an open boundary.

#include "edges/edge_types.h"

#include "common/finite.h"
#include "common/parallel.h"
#include "common/statistics.h"
#include "edges/crease_votes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl::detail {
namespace {

using namespace segmentation;
using Eigen::Vector3f;

// A corner needs creases that differ near it: within half a fit, where fits see all of
// its faces, and a spacing more, for in the middle no two planes explain three faces
// ...
constexpr float near_fits = 0.5f, near_spacings_more = 1.0f;
// ... and creases that differ leading there from one to two fits away, where fits see
// two faces and directions are right,
constexpr float far_fits = 2.0f;
// within the width of a crease's places.
constexpr float line_spacings = 1.5f;
constexpr float other_direction = 0.7071f; // cosine of 45 degrees
constexpr std::size_t min_places = 3;      // of each direction: fewer are chance
// 6 of 16 sectors are 135 degrees: a straight end of the surface leaves 180 degrees
// empty, random gaps inside about 30.
constexpr float boundary_spacings = 2.5f;
constexpr float near_spacings = 1.1f; // some 14 neighbors
constexpr unsigned sectors = 16, empty_sectors = 6;

using Directions = std::vector<Vector3f>;

/** Whether all are so near the first one that no two differ by 45 degrees: along most
 * creases, where comparing each with each would take long. */
bool
areAlike(const Directions& directions)
{
  constexpr float within = 0.927f; // cosine of 22 degrees
  return std::all_of(directions.begin(), directions.end(), [&](const Vector3f& one) {
    return std::abs(one.dot(directions.front())) > within;
  });
}

/** True if so many of them are more than 45 degrees from so many others. */
bool
differ(const Directions& directions)
{
  return !areAlike(directions) &&
         std::any_of(directions.begin(), directions.end(), [&](const Vector3f& one) {
           std::size_t along = 0, across = 0;
           for (const Vector3f& other : directions)
             ++(std::abs(one.dot(other)) > other_direction ? along : across);
           return std::min(along, across) >= min_places;
         });
}

/** True where creases of clearly different directions meet.
 * \param[in] creases grid of the places of edges.creases */
bool
isCorner(const ShapeField& edges, const PointGrid& creases, std::size_t i)
{
  const Vector3f center = positionOf(edges.points, i);
  const float fit = fitSpacings(edges.noise_level) * edges.spacings[i];
  const float near_reach = near_fits * fit + near_spacings_more * edges.spacings[i];
  const float off = line_spacings * edges.spacings[i];
  const auto direction = [&](std::uint32_t k) {
    return Vector3f(Eigen::Map<const Vector3f>(edges.creases[k].direction.data()));
  };
  Directions near;
  creases.forEachWithin(center, near_reach, [&](std::uint32_t k, float) {
    near.push_back(direction(k));
  });
  if (!differ(near))
    return false;
  Directions leading;
  creases.forEachWithin(center, far_fits * fit, [&](std::uint32_t k, float d2) {
    const Vector3f position =
        Eigen::Map<const Vector3f>(edges.creases[k].position.data());
    const Vector3f along = direction(k);
    if (d2 > fit * fit && along.cross(position - center).squaredNorm() < off * off)
      leading.push_back(along);
  });
  return differ(leading);
}

/** Which of the sectors around the origin a direction is in: quarter turns bring it
 * into the first quadrant, whose sectors end where tangents do. */
unsigned
sectorOf(float x, float y)
{
  constexpr float tangent = 0.41421356f; // of 22.5 degrees, one sector
  const unsigned quadrant = y < 0.0f ? (x < 0.0f ? 0 : 1) : (x > 0.0f ? 2 : 3);
  const float along = quadrant % 2 == 0 ? std::abs(x) : std::abs(y);
  const float across = quadrant % 2 == 0 ? std::abs(y) : std::abs(x);
  const unsigned within = unsigned{across >= tangent * along} +
                          unsigned{across >= along} +
                          unsigned{tangent * across >= along};
  return sectors / 4 * quadrant + within;
}

/** True if enough sectors in a row are empty. \param[in] taken a bit for each sector */
bool
hasGap(std::uint32_t taken)
{
  const std::uint32_t empty = ~(taken | taken << sectors); // twice around
  std::uint32_t run = empty;
  for (unsigned s = 1; s < empty_sectors; ++s)
    run &= empty >> s;
  return (run & ((1U << sectors) - 1)) != 0;
}

/** True where the neighbors leave a wide sector of the tangent plane empty. The nearest
 * ones close the circle of most points: the others are looked at where they do not. */
bool
isOnBoundary(const ShapeField& edges, const PointGrid& grid, std::size_t i)
{
  const Vector3f normal = edges.normals[i];
  const Vector3f x = normal.unitOrthogonal(), y = normal.cross(x);
  const Vector3f center = positionOf(edges.points, i);
  std::uint32_t taken = 0;
  const auto closes = [&](std::uint32_t, const Vector3f& position) {
    const Vector3f d = position - center;
    if (d.squaredNorm() == 0.0f)
      return false;
    taken |= 1U << sectorOf(d.dot(x), d.dot(y));
    return !hasGap(taken);
  };
  return !grid.anyWithin(center, near_spacings * edges.spacings[i], closes) &&
         !grid.anyWithin(center, boundary_spacings * edges.spacings[i], closes);
}

} // namespace

double
cornerSpacings(double noise_level)
{
  return static_cast<double>(far_fits) * fitSpacings(noise_level);
}

double
boundarySpacings()
{
  return boundary_spacings;
}

std::vector<EdgeType>
edgeTypes(const ShapeField& edges, double threshold, unsigned threads)
{
  const float spacing = medianSpacing(edges.spacings);
  const PointGrid grid(edges.points, 2.0f * near_spacings * spacing);
  const PointGrid creases(positionsOf(edges.creases),
                          fitSpacings(edges.noise_level) * spacing);
  std::vector<EdgeType> types(edges.points.size, EdgeType::None);
  kernels::parallelForEach(types.size(), threads, [&](std::size_t i) {
    if (!kernels::isFinite(edges.points[i]) || std::isnan(edges.edge_likelihood[i]))
      return;
    if (edges.edge_likelihood[i] > 1.0 - threshold)
      types[i] = isCorner(edges, creases, i) ? EdgeType::Corner : EdgeType::Crease;
    else if (isOnBoundary(edges, grid, i))
      types[i] = EdgeType::OpenBoundary;
  });
  return types;
}

} // namespace pcl::detail
