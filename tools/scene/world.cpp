// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Casting rays at a table and objects.

#include "scene/world.h"

#include <algorithm>
#include <cmath>

namespace pcl::scene {

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
