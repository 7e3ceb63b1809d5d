// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A generated scene as a cloud with the fields of its truth.

#pragma once

#include "cli/arguments.h"
#include "cli/report.h"
#include "io/cloud_file.h"
#include "scene/scene.h"

#include <string>
#include <vector>

namespace pcl::app {

/** \brief A list of points with the fields x, y, z, and their normals if -normals is
 * given. \param[in] xyz, normals three floats for each point */
CloudFile cloudOf(const std::string& name,
                  const std::vector<float>& xyz,
                  const std::vector<float>& normals,
                  const Arguments& arguments);

/** \brief The fields are x, y, z, the normals if -normals is given, surface, edge,
 * instance, crease_mm, and face if -faces is. An image without -organized loses its
 * pixels without depth. */
CloudFile sceneCloud(const pcl::scene::Scene& scene, const Arguments& arguments);

/** \brief Report how many points and objects of each kind there are. */
void
reportScene(const pcl::scene::Scene& scene, const CloudFile& cloud, Report& report);

} // namespace pcl::app
