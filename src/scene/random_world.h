/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include "layout.h"
#include "scene.h"
#include "world.h"

namespace pcl::scene {

struct RandomWorld {
  World world;
  std::vector<Body> bodies; /**< one a solid of the world, in its order */
};

/** \brief A camera, a table and objects on it; the options' noise has no influence. */
RandomWorld randomWorld(const SceneOptions& options);

} // namespace pcl::scene
