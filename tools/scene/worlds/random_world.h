// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A random camera, a table or a bin, and objects on it.

#pragma once

#include "scene/scene.h"
#include "scene/worlds/body.h"
#include "scene/worlds/world.h"

namespace pcl::scene {

struct RandomWorld {
  World world;
  std::vector<Body> bodies; /**< one a solid of the world, in its order; then come
                               solids that are no objects */
};

/** \brief A camera, a table or a bin, and objects on it; the options' noise has no
 * influence. */
RandomWorld randomWorld(const SceneOptions& options);

} // namespace pcl::scene
