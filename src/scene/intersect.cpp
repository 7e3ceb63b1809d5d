/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "solid.h"

#include <algorithm>
#include <cmath>

namespace pcl::scene {
namespace {

/** Keeps the nearest of the candidates, all in the solid's own frame. */
struct Nearest {
  Ray ray;
  double t = std::numeric_limits<double>::infinity();
  int face = -1;
  Vec3 point;

  template <class Contains>
  void
  consider(double candidate, int candidate_face, Contains contains)
  {
    if (!(candidate > 0.0 && candidate < t))
      return;
    const Vec3 at = ray.origin + ray.direction * candidate;
    if (!contains(at))
      return;
    t = candidate;
    face = candidate_face;
    point = at;
  }
};

struct Roots {
  double first = std::numeric_limits<double>::quiet_NaN();
  double second = std::numeric_limits<double>::quiet_NaN();
};

/** a t^2 + 2 b t + c = 0, ascending, without cancellation; NaN where there is none. */
Roots
solveQuadratic(double a, double b, double c)
{
  const double discriminant = b * b - a * c;
  if (!(discriminant >= 0.0))
    return {};
  const double q =
      b < 0.0 ? -b + std::sqrt(discriminant) : -b - std::sqrt(discriminant);
  const double r1 = q / a, r2 = c / q;
  return r1 < r2 ? Roots{r1, r2} : Roots{r2, r1};
}

Roots
sphereRoots(const Ray& ray, const Vec3& centre, double radius)
{
  const Vec3 from_centre = ray.origin - centre;
  return solveQuadratic(squaredNorm(ray.direction),
                        dot(from_centre, ray.direction),
                        squaredNorm(from_centre) - radius * radius);
}

double
squaredXY(const Vec3& p)
{
  return p.x * p.x + p.y * p.y;
}

double
planeRoot(const Ray& ray, double z)
{
  return (z - ray.origin.z) / ray.direction.z;
}

void
intersectBox(const Solid& box, Nearest& nearest)
{
  const Ray& ray = nearest.ray;
  const std::array<double, 3> o{ray.origin.x, ray.origin.y, ray.origin.z};
  const std::array<double, 3> d{ray.direction.x, ray.direction.y, ray.direction.z};
  double enter = 0.0, leave = std::numeric_limits<double>::infinity();
  int face = -1;
  for (std::size_t i = 0; i < 3; ++i) {
    const double half = 0.5 * box.size[i];
    if (d[i] == 0.0) {
      if (std::abs(o[i]) > half)
        return;
      continue;
    }
    const double towards = d[i] > 0.0 ? 1.0 : -1.0;
    const double slab_enter = (-towards * half - o[i]) / d[i];
    if (slab_enter > enter) {
      enter = slab_enter;
      face = static_cast<int>(2 * i) + (towards < 0.0);
    }
    leave = std::min(leave, (towards * half - o[i]) / d[i]);
  }
  if (face >= 0 && enter <= leave)
    nearest.consider(enter, face, [](const Vec3&) { return true; });
}

void
intersectCylinder(const Solid& cylinder, Nearest& nearest)
{
  const double radius = cylinder.size[0], height = cylinder.size[1];
  const auto [o, d] = nearest.ray;
  const Roots roots = solveQuadratic(
      squaredXY(d), o.x * d.x + o.y * d.y, squaredXY(o) - radius * radius);
  const auto betweenCaps = [&](const Vec3& p) { return p.z >= 0.0 && p.z <= height; };
  const auto onCap = [&](const Vec3& p) { return squaredXY(p) <= radius * radius; };
  nearest.consider(roots.first, SideFace, betweenCaps);
  if (d.z > 0.0)
    nearest.consider(planeRoot(nearest.ray, 0.0), BaseFace, onCap);
  else
    nearest.consider(planeRoot(nearest.ray, height), TopFace, onCap);
}

void
intersectCone(const Solid& cone, Nearest& nearest)
{
  const double radius = cone.size[0], height = cone.size[1];
  const double slope2 = radius * radius / (height * height);
  const auto [o, d] = nearest.ray;
  const double below_apex = height - o.z;
  const Roots roots = solveQuadratic(squaredXY(d) - slope2 * d.z * d.z,
                                     o.x * d.x + o.y * d.y + slope2 * below_apex * d.z,
                                     squaredXY(o) - slope2 * below_apex * below_apex);
  const auto onSide = [&](const Vec3& p) { return p.z >= 0.0 && p.z <= height; };
  const auto onBase = [&](const Vec3& p) { return squaredXY(p) <= radius * radius; };
  nearest.consider(roots.first, SideFace, onSide);
  nearest.consider(roots.second, SideFace, onSide);
  if (d.z > 0.0)
    nearest.consider(planeRoot(nearest.ray, 0.0), BaseFace, onBase);
}

void
intersectBowl(const Solid& bowl, Nearest& nearest)
{
  const double radius = bowl.size[0], height = bowl.size[1], wall = bowl.size[2];
  const Vec3 centre{0.0, 0.0, radius};
  const BowlOpening opening = bowlOpening(bowl);
  const auto belowRim = [&](const Vec3& p) { return p.z <= height; };
  const auto onRim = [&](const Vec3& p) {
    const double rho2 = squaredXY(p);
    return rho2 >= opening.inner * opening.inner &&
           rho2 <= opening.outer * opening.outer;
  };
  nearest.consider(
      sphereRoots(nearest.ray, centre, radius).first, BowlOutside, belowRim);
  nearest.consider(
      sphereRoots(nearest.ray, centre, radius - wall).second, BowlInside, belowRim);
  if (nearest.ray.direction.z < 0.0)
    nearest.consider(planeRoot(nearest.ray, height), BowlRim, onRim);
}

Vec3
localNormal(const Solid& solid, int face, const Vec3& p)
{
  const auto [a, b, c] = solid.size;
  switch (solid.shape) {
  case Shape::Box: {
    const double side = face % 2 == 1 ? 1.0 : -1.0;
    return {face / 2 == 0 ? side : 0.0,
            face / 2 == 1 ? side : 0.0,
            face / 2 == 2 ? side : 0.0};
  }
  case Shape::Sphere:
    return p * (1.0 / a);
  case Shape::Bowl:
    if (face == BowlRim)
      return {0.0, 0.0, 1.0};
    return normalized(p - Vec3{0.0, 0.0, a}) * (face == BowlInside ? -1.0 : 1.0);
  case Shape::Cylinder:
  case Shape::Cone:
    if (face != SideFace)
      return {0.0, 0.0, face == TopFace ? 1.0 : -1.0};
    if (solid.shape == Shape::Cylinder)
      return {p.x / a, p.y / a, 0.0};
    return normalized({p.x * b * b, p.y * b * b, a * a * (b - p.z)});
  }
  return {};
}

} // namespace

Hit
intersect(const Solid& solid, const Ray& ray)
{
  Nearest nearest;
  nearest.ray = {solid.pose.toLocal(ray.origin),
                 solid.pose.directionToLocal(ray.direction)};
  switch (solid.shape) {
  case Shape::Box:
    intersectBox(solid, nearest);
    break;
  case Shape::Cylinder:
    intersectCylinder(solid, nearest);
    break;
  case Shape::Sphere:
    nearest.consider(sphereRoots(nearest.ray, {}, solid.size[0]).first,
                     SideFace,
                     [](const Vec3&) { return true; });
    break;
  case Shape::Bowl:
    intersectBowl(solid, nearest);
    break;
  case Shape::Cone:
    intersectCone(solid, nearest);
    break;
  }
  if (nearest.face < 0)
    return {};
  const Vec3 normal = localNormal(solid, nearest.face, nearest.point);
  return {nearest.t, nearest.face, solid.pose.directionToWorld(normal)};
}

} // namespace pcl::scene
