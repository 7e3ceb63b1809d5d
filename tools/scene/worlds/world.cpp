// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Solids, a table and a camera, and what rays and the camera meet.

#include "scene/worlds/world.h"

#include "scene/parts/part.h"

#include <algorithm>
#include <cmath>

namespace pcl::scene {
namespace {

double
squaredXY(const Vec3& p)
{
  return p.x * p.x + p.y * p.y;
}

/** The outward normal at a point of a face, all in the solid's own frame. */
Vec3
localNormal(const Solid& solid, int face, const Vec3& p)
{
  const auto [a, b, c] = solid.size;
  switch (solid.shape) {
  case Shape::Box: {
    Vec3 normal;
    (face / 2 == 0 ? normal.x : face / 2 == 1 ? normal.y : normal.z) = face % 2 * 2 - 1;
    return normal;
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
  case Shape::Part:
    return solid.part->faces()[static_cast<std::size_t>(face)]->normal(p);
  }
  return {};
}

bool
anywhere(const Vec3&)
{
  return true;
}

/** Keeps the nearest of the places where a ray may enter a solid, in its own frame. */
struct Nearest {
  Ray ray;
  double t = std::numeric_limits<double>::infinity();
  int face = -1;
  Vec3 point;

  template <class Contains>
  void
  consider(double candidate, int candidate_face, const Contains& contains)
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

  /** Where the ray meets a plane of constant z. */
  double
  atHeight(double z) const
  {
    return (z - ray.origin.z) / ray.direction.z;
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
sphereRoots(const Ray& ray, const Vec3& center, double radius)
{
  const Vec3 from_center = ray.origin - center;
  return solveQuadratic(squaredNorm(ray.direction),
                        dot(from_center, ray.direction),
                        squaredNorm(from_center) - radius * radius);
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
    nearest.consider(enter, face, anywhere);
}

/** A cylinder or a cone. */
void
intersectRound(const Solid& solid, Nearest& nearest)
{
  const double radius = solid.size[0], height = solid.size[1];
  const auto [o, d] = nearest.ray;
  Roots roots;
  if (solid.shape == Shape::Cylinder)
    roots = solveQuadratic(
        squaredXY(d), o.x * d.x + o.y * d.y, squaredXY(o) - radius * radius);
  else {
    const double slope2 = radius * radius / (height * height);
    const double below_apex = height - o.z;
    roots = solveQuadratic(squaredXY(d) - slope2 * d.z * d.z,
                           o.x * d.x + o.y * d.y + slope2 * below_apex * d.z,
                           squaredXY(o) - slope2 * below_apex * below_apex);
  }
  const auto onSide = [&](const Vec3& p) { return p.z >= 0.0 && p.z <= height; };
  const auto onCap = [&](const Vec3& p) { return squaredXY(p) <= radius * radius; };
  nearest.consider(roots.first, SideFace, onSide);
  if (solid.shape == Shape::Cone) // the first may be on the cone's other half
    nearest.consider(roots.second, SideFace, onSide);
  if (d.z > 0.0)
    nearest.consider(nearest.atHeight(0.0), BaseFace, onCap);
  else if (solid.shape == Shape::Cylinder)
    nearest.consider(nearest.atHeight(height), TopFace, onCap);
}

void
intersectBowl(const Solid& bowl, Nearest& nearest)
{
  const double radius = bowl.size[0], height = bowl.size[1], wall = bowl.size[2];
  const Vec3 center{0.0, 0.0, radius};
  const BowlOpening opening = bowlOpening(bowl);
  const auto belowRim = [&](const Vec3& p) { return p.z <= height; };
  const auto onRim = [&](const Vec3& p) {
    const double rho2 = squaredXY(p);
    return rho2 >= opening.inner * opening.inner &&
           rho2 <= opening.outer * opening.outer;
  };
  const Roots outside = sphereRoots(nearest.ray, center, radius);
  const Roots inside = sphereRoots(nearest.ray, center, radius - wall);
  nearest.consider(outside.first, BowlOutside, belowRim);
  nearest.consider(inside.second, BowlInside, belowRim);
  if (nearest.ray.direction.z < 0.0)
    nearest.consider(nearest.atHeight(height), BowlRim, onRim);
}

} // namespace

const char*
name(Shape shape)
{
  constexpr const char* names[] = {"box", "cylinder", "sphere", "bowl", "cone", "part"};
  return names[static_cast<std::size_t>(shape)];
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
  case Shape::Part: {
    const Sphere own = solid.part->bounds();
    return {solid.pose.toWorld(own.center), own.radius};
  }
  }
  return {};
}

std::vector<FaceAt>
facesAt(const Solid& solid, const Vec3& point, double tolerance)
{
  const Vec3 p = solid.pose.toLocal(point);
  const auto [a, b, c] = solid.size;
  const double rho = std::sqrt(squaredXY(p));
  std::vector<FaceAt> faces;
  const auto addIf = [&](bool is_on_it, int face) {
    if (is_on_it)
      faces.push_back({face, solid.pose.directionToWorld(localNormal(solid, face, p))});
  };
  const auto isAt = [&](double value, double place) {
    return std::abs(value - place) <= tolerance;
  };
  const auto isWithin = [&](double value, double low, double high) {
    return value >= low - tolerance && value <= high + tolerance;
  };
  switch (solid.shape) {
  case Shape::Box: {
    const std::array<double, 3> position{p.x, p.y, p.z};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      const bool beside = std::abs(position[j]) <= 0.5 * solid.size[j] + tolerance &&
                          std::abs(position[k]) <= 0.5 * solid.size[k] + tolerance;
      const int face = static_cast<int>(2 * i);
      addIf(beside && isAt(-position[i], 0.5 * solid.size[i]), face);
      addIf(beside && isAt(position[i], 0.5 * solid.size[i]), face + 1);
    }
    break;
  }
  case Shape::Cylinder:
    addIf(isAt(rho, a) && isWithin(p.z, 0.0, b), SideFace);
    addIf(isAt(p.z, 0.0) && rho <= a + tolerance, BaseFace);
    addIf(isAt(p.z, b) && rho <= a + tolerance, TopFace);
    break;
  case Shape::Cone: {
    const double distance = (rho * b - a * (b - p.z)) / std::sqrt(a * a + b * b);
    addIf(isAt(distance, 0.0) && rho > 0.0 && isWithin(p.z, 0.0, b), SideFace);
    addIf(isAt(p.z, 0.0) && rho <= a + tolerance, BaseFace);
    break;
  }
  case Shape::Sphere:
    addIf(isAt(norm(p), a), SideFace);
    break;
  case Shape::Bowl: {
    const double distance = norm(p - Vec3{0.0, 0.0, a});
    const BowlOpening opening = bowlOpening(solid);
    addIf(p.z <= b + tolerance && isAt(distance, a), BowlOutside);
    addIf(p.z <= b + tolerance && isAt(distance, a - c), BowlInside);
    addIf(isAt(p.z, b) && isWithin(rho, opening.inner, opening.outer), BowlRim);
    break;
  }
  case Shape::Part:
    for (std::size_t i = 0; i < solid.part->faces().size(); ++i)
      if (solid.part->faces()[i]->isAt(p, tolerance))
        addIf(true, static_cast<int>(i));
    break;
  }
  return faces;
}

bool
isCurved(const Solid& solid, int face)
{
  if (solid.shape == Shape::Part)
    return !solid.part->faces()[static_cast<std::size_t>(face)]->isFlat();
  return solid.shape == Shape::Bowl ? face != BowlRim
                                    : solid.shape != Shape::Box && face == SideFace;
}

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
  case Shape::Cone:
    intersectRound(solid, nearest);
    break;
  case Shape::Sphere:
    nearest.consider(
        sphereRoots(nearest.ray, {}, solid.size[0]).first, SideFace, anywhere);
    break;
  case Shape::Bowl:
    intersectBowl(solid, nearest);
    break;
  case Shape::Part: {
    const Hit hit = solid.part->intersect(nearest.ray);
    if (hit.found())
      nearest.consider(hit.t, hit.face, anywhere);
    break;
  }
  }
  if (nearest.face < 0)
    return {};
  const Vec3 normal = localNormal(solid, nearest.face, nearest.point);
  return {nearest.t,
          nearest.face,
          ray.origin + ray.direction * nearest.t,
          solid.pose.directionToWorld(normal)};
}

bool
Table::contains(const Vec3& p) const
{
  const Vec3 from_center = p - center;
  return std::abs(dot(from_center, along)) <= half_length &&
         std::abs(dot(from_center, across)) <= half_width;
}

RayCaster::RayCaster(const World& world) : world_(world)
{
  for (const Solid& solid : world.solids)
    bounds_.push_back(boundingSphere(solid));
}

bool
RayCaster::mayHit(std::size_t solid, const Ray& ray) const
{
  const Vec3 to_center = bounds_[solid].center - ray.origin;
  const double along = dot(to_center, ray.direction);
  const double radius = 1.001 * bounds_[solid].radius;
  return squaredNorm(to_center) - along * along / squaredNorm(ray.direction) <=
         radius * radius;
}

Sight
RayCaster::cast(const Ray& ray) const
{
  Sight sight;
  double nearest = std::numeric_limits<double>::infinity();
  if (ray.direction.z < 0.0) {
    const double t = -ray.origin.z / ray.direction.z;
    const Vec3 point = ray.origin + ray.direction * t;
    if (world_.table.contains(point)) {
      nearest = t;
      sight = {table_index, 0, t, point, {0.0, 0.0, 1.0}};
    }
  }
  for (std::size_t i = 0; i < world_.solids.size(); ++i) {
    if (!mayHit(i, ray))
      continue;
    const Hit hit = intersect(world_.solids[i], ray);
    if (hit.t < nearest) {
      nearest = hit.t;
      sight = {static_cast<int>(i) + 1, hit.face, hit.t, hit.point, hit.normal};
    }
  }
  return sight;
}

bool
RayCaster::seen(const Observer& observer, const Vec3& point, const Vec3& normal) const
{
  constexpr double before_the_point = 1.0 - 1e-5;
  return std::all_of(observer.eyes.begin(), observer.eyes.end(), [&](const Vec3& eye) {
    const Vec3 to_eye = eye - point;
    if (dot(to_eye, normal) <= observer.min_cosine * norm(to_eye))
      return false;
    const Ray ray{eye, point - eye};
    for (std::size_t i = 0; i < world_.solids.size(); ++i)
      if (mayHit(i, ray) && intersect(world_.solids[i], ray).t < before_the_point)
        return false;
    return true;
  });
}

View
look(const World& world)
{
  const Camera& camera = world.camera;
  const RayCaster caster(world);
  View view{camera.width, camera.height, {}};
  for (std::size_t i = 0; i < std::size_t{camera.width} * camera.height; ++i)
    view.sights.push_back(caster.cast(
        {camera.pose.origin, camera.pose.directionToWorld(camera.direction(i))}));
  return view;
}

bool
isCurved(const World& world, const Sight& sight)
{
  return sight.object > table_index &&
         isCurved(world.solids[static_cast<std::size_t>(sight.object - 1)], sight.face);
}

} // namespace pcl::scene
