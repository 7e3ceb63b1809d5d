// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Scenes of objects on a table, from their options.

#pragma once

#include "cli/arguments.h"
#include "cli/report.h"
#include "io/cloud_file.h"
#include "scene/scene.h"

namespace pcl::app {

/** \brief What the options of a table scene say: -seed, -objects, -shapes, -width,
 * -height, -turn and -noise. \throws UsageError that names the option and what is
 * expected */
pcl::scene::SceneOptions tableOptions(const Arguments& arguments);

/** \brief Make a random table scene: as a depth camera sees it, or with -sampling
 * points all over its surfaces. The fields are x, y, z, the normals if -normals is
 * given, surface, edge, instance, crease_mm, and face if -faces is. Parameters, counts
 * and time are reported. \param[in] options what the arguments say of the scene \throws
 * UsageError for options of a camera together with -sampling */
CloudFile tableCloud(const Arguments& arguments,
                     const pcl::scene::SceneOptions& options,
                     Report& report);

} // namespace pcl::app
