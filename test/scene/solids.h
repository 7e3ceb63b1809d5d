// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Signed distances to the objects of a scene, written independently of the generator.

#pragma once

#include "scene/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

/** Signed distances to the objects of a scene, written independently of the generator.
 */
namespace solids {

using Point = std::array<double, 3>;

inline Point
toLocal(const pcl::scene::SceneObject& object, const Point& p)
{
  Point local{};
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t axis = 0; axis < 3; ++axis)
      local[row] += object.axes[row][axis] * (p[axis] - object.origin[axis]);
  return local;
}

inline Point
toCamera(const pcl::scene::SceneObject& object, const Point& local)
{
  Point p = object.origin;
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t axis = 0; axis < 3; ++axis)
      p[axis] += object.axes[row][axis] * local[row];
  return p;
}

/** Negative inside, zero on the surface; beside edges a bound of the distance. */
inline double
signedDistance(const pcl::scene::SceneObject& object, const Point& p)
{
  const auto [x, y, z] = toLocal(object, p);
  const auto [a, b, c] = object.size;
  const double rho = std::hypot(x, y);
  switch (object.shape) {
  case pcl::scene::Shape::Box:
    return std::max({std::abs(x) - a / 2, std::abs(y) - b / 2, std::abs(z) - c / 2});
  case pcl::scene::Shape::Cylinder:
    return std::max({rho - a, -z, z - b});
  case pcl::scene::Shape::Sphere:
    return std::hypot(rho, z) - a;
  case pcl::scene::Shape::Cone:
    return std::max((rho * b - a * (b - z)) / std::hypot(a, b), -z);
  case pcl::scene::Shape::Bowl: {
    const double distance = std::hypot(rho, z - a);
    return std::max({distance - a, a - c - distance, z - b});
  }
  case pcl::scene::Shape::Part: // its faces are tested by themselves
    break;
  }
  return 0.0;
}

/** Points on the surface of an object, about `step` apart. */
inline std::vector<Point>
surfacePoints(const pcl::scene::SceneObject& object, double step)
{
  // Those points of a fine grid that are nearest to the surface, pulled onto it
  const auto [a, b, c] = object.size;
  const bool box = object.shape == pcl::scene::Shape::Box;
  const bool ball = object.shape == pcl::scene::Shape::Sphere;
  const double rx = box ? a / 2 : a, ry = box ? b / 2 : a;
  const double low = box ? -c / 2 : (ball ? -a : 0.0);
  const double high = box ? c / 2 : (ball ? a : b);
  std::vector<Point> points;
  for (double x = -rx; x <= rx; x += step)
    for (double y = -ry; y <= ry; y += step)
      for (double z = low; z <= high; z += step) {
        const Point p = toCamera(object, {x, y, z});
        const double distance = signedDistance(object, p);
        if (distance <= 0.0 && distance > -step)
          points.push_back(p);
      }
  return points;
}

} // namespace solids
