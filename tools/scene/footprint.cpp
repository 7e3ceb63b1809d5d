// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "scene/footprint.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::scene {
namespace {

Point2
operator-(Point2 a, Point2 b)
{
  return {a.x - b.x, a.y - b.y};
}

double
dot(Point2 a, Point2 b)
{
  return a.x * b.x + a.y * b.y;
}

double
distanceToSegment(Point2 p, Point2 a, Point2 b)
{
  const Point2 along = b - a;
  const double length2 = dot(along, along);
  const double s =
      length2 > 0.0 ? std::clamp(dot(p - a, along) / length2, 0.0, 1.0) : 0.0;
  const Point2 nearest{a.x + s * along.x, a.y + s * along.y};
  return std::sqrt(dot(p - nearest, p - nearest));
}

/** True if a side of `a` has all of `b` on its outer side. */
bool
hasSeparatingSide(const std::vector<Point2>& a, const std::vector<Point2>& b)
{
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Point2 side = a[(i + 1) % a.size()] - a[i];
    const Point2 outward{side.y, -side.x};
    if (std::all_of(b.begin(), b.end(), [&](Point2 corner) {
          return dot(corner - a[i], outward) > 0.0;
        }))
      return true;
  }
  return false;
}

double
cornersToSides(const std::vector<Point2>& corners, const std::vector<Point2>& sides)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (const Point2 corner : corners)
    for (std::size_t i = 0; i < sides.size(); ++i)
      nearest = std::min(
          nearest, distanceToSegment(corner, sides[i], sides[(i + 1) % sides.size()]));
  return nearest;
}

} // namespace

Footprint
disc(Point2 centre, double radius)
{
  return {{centre}, radius};
}

Footprint
rectangle(Point2 centre, Point2 direction, double length, double width)
{
  const Point2 half{0.5 * length * direction.x, 0.5 * length * direction.y};
  const Point2 side{-0.5 * width * direction.y, 0.5 * width * direction.x};
  return {{{centre.x - half.x - side.x, centre.y - half.y - side.y},
           {centre.x + half.x - side.x, centre.y + half.y - side.y},
           {centre.x + half.x + side.x, centre.y + half.y + side.y},
           {centre.x - half.x + side.x, centre.y - half.y + side.y}},
          0.0};
}

Footprint
moved(const Footprint& footprint, Point2 by)
{
  Footprint result = footprint;
  for (auto& corner : result.corners)
    corner = {corner.x + by.x, corner.y + by.y};
  return result;
}

double
distance(const Footprint& a, const Footprint& b)
{
  const double grown = a.radius + b.radius;
  const bool both_discs = a.corners.size() == 1 && b.corners.size() == 1;
  if (!both_discs && !hasSeparatingSide(a.corners, b.corners) &&
      !hasSeparatingSide(b.corners, a.corners))
    return -grown;
  return std::min(cornersToSides(a.corners, b.corners),
                  cornersToSides(b.corners, a.corners)) -
         grown;
}

double
slideToContact(const Footprint& mover, Point2 direction, const Footprint& other)
{
  const auto overlaps = [&](double by) {
    return distance(moved(mover, {by * direction.x, by * direction.y}), other) <= 0.0;
  };
  double overlapping = 0.0, apart = 0.05;
  while (overlaps(apart))
    apart *= 2.0;
  while (apart - overlapping > 1e-13) {
    const double middle = 0.5 * (overlapping + apart);
    (overlaps(middle) ? overlapping : apart) = middle;
  }
  return apart;
}

} // namespace pcl::scene
