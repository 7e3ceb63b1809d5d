// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A room with furniture, stairs, pillars, moldings and pipes.

#pragma once

#include "scene/random.h"
#include "scene/world.h"

namespace pcl::scene {

struct Room {
  World world;                /**< without a table; z up, the floor at 0 */
  double length = 0.0;        /**< along x, which begins at 0 */
  double width = 0.0;         /**< along y, which begins at 0 */
  std::size_t shell = 0;      /**< the first solids are floor, walls and ceiling */
  std::vector<Vec3> stations; /**< where a scanner may stand, 1.5 m high */
};

/** \brief Of 4 to 8 m by 4 to 7 m and 2.4 to 3.2 m height. */
Room randomRoom(std::uint64_t seed);

} // namespace pcl::scene
