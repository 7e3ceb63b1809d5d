// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include "cli/arguments.h"
#include "scene/scene.h"

namespace pcl::app {

/** \brief What the options of a table scene say: -seed, -objects, -shapes, -width,
 * -height, -turn and -noise. \throws UsageError that names the option and what is
 * allowed */
pcl::scene::SceneOptions tableOptions(const Arguments& arguments);

} // namespace pcl::app
