// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A scene as a cloud with its truth in fields.

#pragma once

#include "cli/arguments.h"
#include "cli/report.h"
#include "io/cloud_file.h"
#include "scene/scene.h"

namespace pcl::app {

/** \brief The fields are x, y, z, the normals if -normals is given, surface, edge,
 * instance, crease_mm, and face if -faces is. An image without -organized loses its
 * pixels without depth. */
CloudFile sceneCloud(const pcl::scene::Scene& scene, const Arguments& arguments);

/** \brief Report how many points and objects of each kind there are. */
void
reportScene(const pcl::scene::Scene& scene, const CloudFile& cloud, Report& report);

} // namespace pcl::app
