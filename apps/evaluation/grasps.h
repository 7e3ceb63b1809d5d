// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Whether the first grasp of each object is on it, square to it, and free of holes.

#pragma once

#include "results/scene_files.h"

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace pcl::app {

constexpr double max_grasp_angle = 5.0; ///< degrees off the normal of the surface

/** \brief What became of one object. */
struct ObjectGrasp {
  std::uint32_t object = 0;
  std::uint64_t points = 0;
  /** A disc of twice the cup's area lies on it, no more bent than a cup can bend. */
  bool has_face = false;
  std::optional<Grasp> first; ///< its grasp ranked first, if it has one
  bool is_on_object = false;  ///< the point of the cloud nearest to it is the object's
  bool is_whole = false;      ///< the object is everywhere under the cup
  /** Degrees between the approach and the normal of the object; NaN without one. */
  double angle = 0.0;

  bool
  isRight() const
  {
    return first && first->seals && is_on_object && is_whole &&
           angle <= max_grasp_angle;
  }
};

/** \brief Judge grasps by fits and counts over the points of the truth alone.
 * \param[in] cloud the points of the truth
 * \param[in] labels of the objects, one a point; 0 is none
 * \param[in] grasps the best of each object first
 * \param[in] min_points of an object that is judged
 * \return one of each object with enough points, in the order of their numbers */
std::vector<ObjectGrasp> evaluateGrasps(const pcl::PointCloud<pcl::PointXYZ>& cloud,
                                        const std::vector<std::uint32_t>& labels,
                                        const GraspsOfObjects& grasps,
                                        std::uint64_t min_points);

} // namespace pcl::app
