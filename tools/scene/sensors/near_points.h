// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Finds the points of a part that are near a place.

#pragma once

#include "scene/vec.h"

#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace pcl::scene {

/** \brief Points in cubes as long as the radius: those within it are in a cube or
 * beside it. */
class NearPoints {
public:
  explicit NearPoints(double radius) : radius_(radius) {}

  void
  add(const Vec3& p)
  {
    cubes_[key(cubeAt(p.x), cubeAt(p.y), cubeAt(p.z))].push_back(points_.size());
    points_.push_back(p);
  }

  bool
  hasNear(const Vec3& p) const
  {
    return findNear(p, [](std::size_t) { return true; });
  }

  /** \brief Calls with the number of each point that is near, the first added being 0.
   */
  template <class Function>
  void
  forEachNear(const Vec3& p, const Function& function) const
  {
    findNear(p, [&](std::size_t point) {
      function(point);
      return false;
    });
  }

private:
  /** Calls until the answer is true. \return whether it was */
  template <class Predicate>
  bool
  findNear(const Vec3& p, const Predicate& is_wanted) const
  {
    const std::int64_t i = cubeAt(p.x), j = cubeAt(p.y), k = cubeAt(p.z);
    for (std::int64_t x = i - 1; x <= i + 1; ++x)
      for (std::int64_t y = j - 1; y <= j + 1; ++y)
        for (std::int64_t z = k - 1; z <= k + 1; ++z) {
          const auto cube = cubes_.find(key(x, y, z));
          if (cube == cubes_.end())
            continue;
          for (const std::size_t point : cube->second)
            if (squaredNorm(points_[point] - p) < radius_ * radius_ && is_wanted(point))
              return true;
        }
    return false;
  }

  std::int64_t
  cubeAt(double x) const
  {
    return static_cast<std::int64_t>(std::floor(x / radius_));
  }

  static std::int64_t
  key(std::int64_t x, std::int64_t y, std::int64_t z)
  {
    constexpr std::int64_t cubes_a_side = 1 << 20; // parts have at most 20,000
    return (x * cubes_a_side + y) * cubes_a_side + z;
  }

  double radius_;
  std::vector<Vec3> points_;
  std::unordered_map<std::int64_t, std::vector<std::size_t>> cubes_;
};

} // namespace pcl::scene
