// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Holes, slots and gaps between points that no even or random sampling leaves by
// chance.

#pragma once

#include <Eigen/Core>

#include <vector>

namespace pcl::segmentation {

/** \brief A disc without points in a hole, slot or gap, meters. */
struct Gap {
  Eigen::Vector2f center = Eigen::Vector2f::Zero();
  float radius = 0.0f;

  /** \brief How far it is from the middle to the rim; negative inside. */
  float
  distance() const
  {
    return center.norm() - radius;
  }
};

/** \brief The gaps between points of a plane that reach into a disc around its middle.
 *
 * A gap is what is wider than three mean distances between the points, unless their
 * own disorder leaves such places: the more of the disc is far from all points, the
 * larger a gap must be. doc/grasps.md has the smallest ones. What is wider than the
 * spacing is covered with discs of its radius, narrower gaps with discs of their own.
 * \param[in] points all of them within the radius and three spacings of the middle
 * \param[in] spacing of the points: distance to the 12th neighbor */
std::vector<Gap>
gapsWithin(float radius, const std::vector<Eigen::Vector2f>& points, float spacing);

} // namespace pcl::segmentation
