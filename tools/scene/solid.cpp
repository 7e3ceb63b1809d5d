// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "scene/solid.h"

#include <algorithm>
#include <cmath>

namespace pcl::scene {
namespace {

double
lengthXY(const Vec3& p)
{
  return std::sqrt(p.x * p.x + p.y * p.y);
}

bool
within(double value, double low, double high, double tolerance)
{
  return value >= low - tolerance && value <= high + tolerance;
}

std::vector<FaceAt>
boxFacesAt(const Solid& box, const Vec3& p, double tolerance)
{
  const std::array<double, 3> position{p.x, p.y, p.z};
  std::array<bool, 3> inside{};
  for (std::size_t i = 0; i < 3; ++i)
    inside[i] = std::abs(position[i]) <= 0.5 * box.size[i] + tolerance;
  std::vector<FaceAt> faces;
  for (std::size_t i = 0; i < 3; ++i)
    for (const int side : {-1, 1}) {
      const bool on_plane =
          std::abs(side * position[i] - 0.5 * box.size[i]) <= tolerance;
      if (on_plane && inside[(i + 1) % 3] && inside[(i + 2) % 3])
        faces.push_back(
            {static_cast<int>(2 * i) + (side > 0), box.pose.axes[i] * side});
    }
  return faces;
}

std::vector<FaceAt>
cylinderFacesAt(const Solid& cylinder, const Vec3& p, double tolerance)
{
  const double radius = cylinder.size[0], height = cylinder.size[1];
  const double rho = lengthXY(p);
  const Vec3& axis = cylinder.pose.axes[2];
  std::vector<FaceAt> faces;
  if (std::abs(rho - radius) <= tolerance && within(p.z, 0.0, height, tolerance))
    faces.push_back(
        {SideFace, cylinder.pose.directionToWorld({p.x / rho, p.y / rho, 0.0})});
  if (std::abs(p.z) <= tolerance && rho <= radius + tolerance)
    faces.push_back({BaseFace, -axis});
  if (std::abs(p.z - height) <= tolerance && rho <= radius + tolerance)
    faces.push_back({TopFace, axis});
  return faces;
}

std::vector<FaceAt>
coneFacesAt(const Solid& cone, const Vec3& p, double tolerance)
{
  const double radius = cone.size[0], height = cone.size[1];
  const double rho = lengthXY(p);
  const double slant = std::sqrt(radius * radius + height * height);
  const double distance = (rho * height - radius * (height - p.z)) / slant;
  std::vector<FaceAt> faces;
  if (std::abs(distance) <= tolerance && rho > 0.0 &&
      within(p.z, 0.0, height, tolerance)) {
    const double outward = height / slant / rho;
    faces.push_back(
        {SideFace,
         cone.pose.directionToWorld({p.x * outward, p.y * outward, radius / slant})});
  }
  if (std::abs(p.z) <= tolerance && rho <= radius + tolerance)
    faces.push_back({BaseFace, -cone.pose.axes[2]});
  return faces;
}

std::vector<FaceAt>
bowlFacesAt(const Solid& bowl, const Vec3& p, double tolerance)
{
  const double radius = bowl.size[0], height = bowl.size[1], wall = bowl.size[2];
  const Vec3 from_centre = p - Vec3{0.0, 0.0, radius};
  const double distance = norm(from_centre);
  const Vec3 outward = bowl.pose.directionToWorld(from_centre * (1.0 / distance));
  std::vector<FaceAt> faces;
  if (p.z <= height + tolerance) {
    if (std::abs(distance - radius) <= tolerance)
      faces.push_back({BowlOutside, outward});
    if (std::abs(distance - (radius - wall)) <= tolerance)
      faces.push_back({BowlInside, -outward});
  }
  const BowlOpening opening = bowlOpening(bowl);
  if (std::abs(p.z - height) <= tolerance &&
      within(lengthXY(p), opening.inner, opening.outer, tolerance))
    faces.push_back({BowlRim, bowl.pose.axes[2]});
  return faces;
}

} // namespace

const char*
name(Shape shape)
{
  switch (shape) {
  case Shape::Box:
    return "box";
  case Shape::Cylinder:
    return "cylinder";
  case Shape::Sphere:
    return "sphere";
  case Shape::Bowl:
    return "bowl";
  case Shape::Cone:
    return "cone";
  }
  return "";
}

BowlOpening
bowlOpening(const Solid& bowl)
{
  const double radius = bowl.size[0], height = bowl.size[1], wall = bowl.size[2];
  const double up = height - radius;
  const auto atHeight = [up](double r) { return std::sqrt(r * r - up * up); };
  return {atHeight(radius - wall), atHeight(radius)};
}

Sphere
boundingSphere(const Solid& solid)
{
  const auto [a, b, c] = solid.size;
  const Vec3& up = solid.pose.axes[2];
  switch (solid.shape) {
  case Shape::Box:
    return {solid.pose.origin, 0.5 * std::sqrt(a * a + b * b + c * c)};
  case Shape::Cylinder:
  case Shape::Cone:
    return {solid.pose.origin + up * (0.5 * b), std::sqrt(a * a + 0.25 * b * b)};
  case Shape::Sphere:
    return {solid.pose.origin, a};
  case Shape::Bowl:
    return {solid.pose.origin + up * a, a};
  }
  return {};
}

std::vector<FaceAt>
facesAt(const Solid& solid, const Vec3& point, double tolerance)
{
  const Vec3 local = solid.pose.toLocal(point);
  switch (solid.shape) {
  case Shape::Box:
    return boxFacesAt(solid, local, tolerance);
  case Shape::Cylinder:
    return cylinderFacesAt(solid, local, tolerance);
  case Shape::Cone:
    return coneFacesAt(solid, local, tolerance);
  case Shape::Bowl:
    return bowlFacesAt(solid, local, tolerance);
  case Shape::Sphere: {
    const double distance = norm(local);
    if (std::abs(distance - solid.size[0]) > tolerance)
      return {};
    return {{SideFace, solid.pose.directionToWorld(local * (1.0 / distance))}};
  }
  }
  return {};
}

bool
isCurved(Shape shape, int face)
{
  switch (shape) {
  case Shape::Box:
    return false;
  case Shape::Sphere:
    return true;
  case Shape::Cylinder:
  case Shape::Cone:
    return face == SideFace;
  case Shape::Bowl:
    return face != BowlRim;
  }
  return false;
}

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
