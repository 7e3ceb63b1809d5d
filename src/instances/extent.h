// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Whether a place is inside of others, in a plane or in an image.

#pragma once

#include "geometry/point_grid.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace pcl::segmentation {

/** \brief What some places surround, seen along a direction: where they are in 11 of 16
 * directions or more. */
class Extent {
public:
  /** \param[in] normal of the plane or image that the places are in, a unit vector
   * \param[in] places what surrounds */
  Extent(const Eigen::Vector3f& normal, const XYZView& places)
  : x_(normal.unitOrthogonal())
  , y_(normal.cross(x_))
  {
    for (std::size_t k = 0; k < places.size; ++k)
      places_.push_back(along(positionOf(places, k)));
  }

  /** \brief Whether there are places in 11 of the 16 directions from a position. */
  bool
  isInside(const Eigen::Vector3f& position) const
  {
    const Eigen::Vector2f from = along(position);
    std::array<char, directions> seen{};
    int count = 0;
    return std::any_of(places_.begin(), places_.end(), [&](const auto& place) {
      char& is_seen = seen[directionOf(place - from)];
      count += is_seen ? 0 : 1;
      is_seen = 1;
      return count >= min_directions;
    });
  }

private:
  // Of 16 directions, in which there are places. Beside a straight border there are 8,
  // beside a round one fewer; 9 or 10 with ripple.
  static constexpr std::size_t directions = 16;
  static constexpr int min_directions = 11;

  Eigen::Vector2f
  along(const Eigen::Vector3f& position) const
  {
    return {x_.dot(position), y_.dot(position)};
  }

  static std::size_t
  directionOf(const Eigen::Vector2f& offset)
  {
    constexpr auto pi = static_cast<float>(M_PI);
    const float turns = (std::atan2(offset.y(), offset.x()) + pi) / (2.0f * pi);
    const auto last = static_cast<float>(directions - 1);
    return static_cast<std::size_t>(std::clamp(turns * directions, 0.0f, last));
  }

  Eigen::Vector3f x_, y_;
  std::vector<Eigen::Vector2f> places_; ///< across the normal
};

} // namespace pcl::segmentation
