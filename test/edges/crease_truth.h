// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Where the creases of a generated scene are and meet.

#pragma once

#include "scene/creases.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace pcl::test {

/** \brief Where the creases of a world meet. The scene generator knows how far creases
 * are; where they meet follows from the world's geometry. */
class CreaseTruth {
public:
  /** \param[in] spacing mean distance of points, meters */
  CreaseTruth(const scene::World& world,
              const scene::Observer& observer,
              double spacing)
  {
    const scene::Creases creases(world, observer);
    for (const scene::Curve& part : creases.parts()) {
      constexpr int steps = 200;
      for (int s = 0; s <= steps; ++s) {
        const double parameter = part.parameter(static_cast<double>(s) / steps);
        points_.push_back({part.point(parameter), part.tangent(parameter)});
      }
    }
    for (const CurvePoint& a : points_)
      if (crosses(a.tangent, a.position, 0.5 * spacing))
        corners_.push_back(a.position);
  }

  double
  toCorner(const scene::Vec3& p) const
  {
    double nearest = std::numeric_limits<double>::infinity();
    for (const scene::Vec3& corner : corners_)
      nearest = std::min(nearest, norm(p - corner));
    return nearest;
  }

  /** \brief Whether creases of clearly different directions are that near, met or not.
   */
  bool
  creasesMeetWithin(const scene::Vec3& p, double reach) const
  {
    return std::any_of(points_.begin(), points_.end(), [&](const CurvePoint& one) {
      return norm(one.position - p) < reach && crosses(one.tangent, p, reach);
    });
  }

  std::size_t
  corners() const
  {
    return corners_.size();
  }

private:
  struct CurvePoint {
    scene::Vec3 position, tangent;
  };

  bool
  crosses(const scene::Vec3& tangent, const scene::Vec3& p, double reach) const
  {
    constexpr double other_direction = 0.7071; // cosine of 45 degrees
    return std::any_of(points_.begin(), points_.end(), [&](const CurvePoint& other) {
      return norm(other.position - p) < reach &&
             std::abs(dot(tangent, other.tangent)) < other_direction;
    });
  }

  std::vector<CurvePoint> points_; ///< of all creases
  std::vector<scene::Vec3> corners_;
};

} // namespace pcl::test
