// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What the viewpoint sees of the space between two faces.

#pragma once

#include "geometry/point_grid.h"
#include "instances/instance_points.h"

#include <cstdint>
#include <vector>

namespace pcl::segmentation {

/** \brief The points of a cloud by their directions from the viewpoint. */
class SeenDirections {
public:
  explicit SeenDirections(const detail::InstanceInput& input);

  /** \brief The points less than an angle, in radians, from an axis.
   * \param[in] axis unit */
  std::vector<std::uint32_t> inCone(const Eigen::Vector3f& axis, float angle) const;

private:
  const detail::InstanceInput& input_;
  std::vector<Eigen::Vector3f> directions_; ///< unit; NaN if a point is not finite
  PointGrid grid_;
};

/** \brief Lines between the points of two faces that are nearest to each other. */
class LinesOfSight {
public:
  /** \param[in] from the points of a face, at least one; \param[in] to of the other */
  LinesOfSight(const detail::InstanceInput& input,
               const std::vector<std::uint32_t>& from,
               const std::vector<std::uint32_t>& to);

  /** \brief The length of the shortest line, in meters. */
  float
  gap() const
  {
    return gap_;
  }

  /** \brief Whether something nearer to the viewpoint hides what is between the faces.
   */
  bool areHidden(const SeenDirections& seen) const;

private:
  /** On a line. */
  struct Place {
    Eigen::Vector3f direction; ///< unit, from the viewpoint
    float distance;            ///< from it
    float spacing;
  };

  /** What the ray from the viewpoint to a place meets. */
  enum class Sight { Nothing, Nearer, There, Beyond };

  void addLine(std::uint32_t from, std::uint32_t to);
  std::vector<std::uint32_t> pointsInView(const SeenDirections& seen) const;
  Sight sightAt(const Place& place, const std::vector<std::uint32_t>& near) const;

  const detail::InstanceInput& input_;
  float gap_ = 0.0f;
  std::vector<Place> places_;
};

} // namespace pcl::segmentation
