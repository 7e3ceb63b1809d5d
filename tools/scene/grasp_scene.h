// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Objects to grasp, and where a suction cup of some size would fit on them.

#pragma once

#include "scene/worlds/random_world.h"

#include <cstddef>
#include <vector>

namespace pcl::scene {

/** \brief Large objects to grasp, each with a smaller one on it (unless its top is
 * round) and one before it that hides a part of it. */
struct GraspScene {
  World world;
  Observer observer;       /**< what has to see a point for it to be measured */
  std::vector<float> xyz;  /**< of the measured points, 3 each, camera frame */
  std::vector<int> object; /**< at each: as Sight::object */
  std::vector<int> face;   /**< at each: as Sight::face */
  std::vector<std::size_t> targets; /**< as Sight::object */
};

/** \brief Two targets, seen by a depth camera. The same options give the same scene on
 * any machine; of the options the number of objects has no influence. */
GraspScene graspScene(const SceneOptions& options);

/** \brief True if a disc on the surface, seen from above along its normal, is on one
 * face of the object from rim to rim, with nothing in the way within `free_way` meters
 * above it. \param[in] position, approach world frame; unit, into the surface */
bool isOnOneFace(const World& world,
                 std::size_t object,
                 const Vec3& position,
                 const Vec3& approach,
                 double radius,
                 double free_way);

/** \brief True if a face of the object shows a disc of this radius: everywhere on one
 * face, and seen by the observer. \param[in] step meters between the discs tried */
bool showsDisc(const GraspScene& scene, std::size_t object, double radius, double step);

} // namespace pcl::scene
