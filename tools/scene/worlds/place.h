// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Where a scanner on a tripod may stand: rooms and house fronts.

#pragma once

#include "scene/worlds/world.h"

namespace pcl::scene {

constexpr unsigned max_stations = 4;

struct Place {
  World world;         /**< without a table; z up, the floor or ground at 0 */
  double length = 0.0; /**< of the room or front along x, which begins at 0 */
  double width =
      0.0; /**< of the room along y, which begins at 0; height of the front */
  std::size_t shell = 0; /**< the first solids are floor, walls and ceiling, or ground
                            and front */
  std::vector<Vec3> stations; /**< max_stations, in a room fewer if there is no
                                 space for them */
};

/** \brief A box along the axes, from one corner to the opposite one. */
Solid boxBetween(const Vec3& low, const Vec3& high);

/** \brief A solid with an upright profile, x to the right and y up, that is moved.
 * \param[in] pose of the profile; it is moved along its z
 * \param[in] by meters */
Solid extrusion(const std::vector<Vec3>& profile, const Pose& pose, double by);

/** \brief Of 4 to 8 m by 4 to 7 m and 2.4 to 3.2 m height. The scanner stands 1.5 m
 * high. */
Place randomRoom(std::uint64_t seed);

/** \brief A house front of 8 to 14 m and two to four floors, in the plane y = 0, with
 * windows (some with arches), a bay, moldings, a downpipe, steps, and the ground before
 * it. The scanner stands 4 to 9 m before it, 1.6 m high. */
Place randomFacade(std::uint64_t seed);

} // namespace pcl::scene
