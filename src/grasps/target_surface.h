// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The known points of a target and the points around it, to look places up in.

#pragma once

#include "geometry/point_grid.h"
#include "grasps/suction_grasps.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::segmentation {

/** \brief Cosine of 45 degrees: normals that differ by less face the same way. */
constexpr float same_direction = 0.7071f;

/** \brief The positions that items begin with. */
template <typename Item>
XYZView
viewOf(const std::vector<Item>& items)
{
  static_assert(sizeof(Item) % sizeof(float) == 0, "items must be rows of floats");
  return {reinterpret_cast<const float*>(items.data()),
          sizeof(Item) / sizeof(float),
          items.size()};
}

/** \brief The known points of a target, and the points around it, to look places up in.
 *
 * Points are in the order of their coordinates: sums over them do not depend on the
 * order in the cloud. */
class TargetSurface {
public:
  struct Point {
    Eigen::Vector3f position;
    Eigen::Vector3f normal; ///< unit, outwards
    float spacing;
    bool is_edge;
    std::uint32_t source; ///< its entry in the target
  };

  /** \param[in] reach how far from the target its surroundings matter
   * \param[in] cell about the radius of the queries */
  TargetSurface(const detail::GraspTarget& target, float reach, float cell);

  const std::vector<Point>&
  points() const
  {
    return points_;
  }

  /** \brief The standard deviation of the points from a smooth surface, spacings. */
  float
  noise() const
  {
    return noise_;
  }

  /** \brief visit(position in points(), squared distance). */
  template <typename Visit>
  void
  forEachWithin(const Eigen::Vector3f& center, float radius, const Visit& visit) const
  {
    grid_.forEachWithin(center, radius, visit);
  }

  /** \brief visit(position) for points of the cloud that are not of the target. */
  template <typename Visit>
  void
  forEachOther(const Eigen::Vector3f& center, float radius, const Visit& visit) const
  {
    others_grid_.forEachWithin(
        center, radius, [&](std::uint32_t i, float) { visit(others_[i]); });
  }

private:
  std::vector<Point> points_;
  std::vector<Eigen::Vector3f> others_;
  float noise_;
  PointGrid grid_;
  PointGrid others_grid_;
};

} // namespace pcl::segmentation
