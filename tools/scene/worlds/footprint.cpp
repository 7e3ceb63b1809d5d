// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Distances between convex polygons with rounded corners, and sliding one to another.

#include "scene/worlds/footprint.h"

#include <algorithm>
#include <limits>

namespace pcl::scene {
namespace {

double
distanceToSegment(const Vec3& p, const Vec3& a, const Vec3& b)
{
  const Vec3 along = b - a;
  const double length2 = squaredNorm(along);
  const double s =
      length2 > 0.0 ? std::clamp(dot(p - a, along) / length2, 0.0, 1.0) : 0.0;
  return norm(p - (a + along * s));
}

/** True if a side of `a` has all of `b` on its outer side. */
bool
hasSeparatingSide(const std::vector<Vec3>& a, const std::vector<Vec3>& b)
{
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vec3 outward = -leftOf(a[(i + 1) % a.size()] - a[i]);
    if (std::all_of(b.begin(), b.end(), [&](const Vec3& corner) {
          return dot(corner - a[i], outward) > 0.0;
        }))
      return true;
  }
  return false;
}

double
cornersToSides(const std::vector<Vec3>& corners, const std::vector<Vec3>& sides)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (const Vec3& corner : corners)
    for (std::size_t i = 0; i < sides.size(); ++i)
      nearest = std::min(
          nearest, distanceToSegment(corner, sides[i], sides[(i + 1) % sides.size()]));
  return nearest;
}

} // namespace

Footprint
rectangle(const Vec3& center, const Vec3& direction, double length, double width)
{
  const Vec3 half = direction * (0.5 * length);
  const Vec3 side = leftOf(direction) * (0.5 * width);
  return {{center - half - side,
           center + half - side,
           center + half + side,
           center - half + side},
          0.0};
}

Footprint
moved(Footprint footprint, const Vec3& by)
{
  for (Vec3& corner : footprint.corners)
    corner = corner + Vec3{by.x, by.y, 0.0};
  return footprint;
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
slideToContact(const Footprint& mover, const Vec3& direction, const Footprint& other)
{
  const auto overlaps = [&](double by) {
    return distance(moved(mover, direction * by), other) <= 0.0;
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
