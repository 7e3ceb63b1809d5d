// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Scenes of tables, parts and rooms, from their options to a cloud with its truth.

#pragma once

#include "cli/command_line.h"
#include "cli/report.h"
#include "io/cloud_file.h"
#include "scene/part_samples.h"
#include "scene/scene.h"
#include "scene/station_scan.h"

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

/** \brief What -seed, -size, -sampling, -spread and -noise say. \throws UsageError that
 * names the option and what is expected */
pcl::scene::PartOptions partOptions(const Arguments& arguments);

/** \brief Sample a random part, or reconstruct it from photographs. The fields are
 * those of a table scene, and crease_s, radius_s and thin_s in spacings. Parameters,
 * counts and time are reported. */
CloudFile partCloud(const Arguments& arguments,
                    const pcl::scene::PartOptions& options,
                    Report& report);

/** \brief What -seed, -stations, -step and -noise say. \throws UsageError that names
 * the option and what is expected */
pcl::scene::StationOptions stationOptions(const Arguments& arguments);

/** \brief Scan a random room or house front. The fields are those of a table scene.
 * Parameters, counts and time are reported. */
CloudFile roomCloud(const Arguments& arguments,
                    const pcl::scene::StationOptions& options,
                    Report& report);

} // namespace pcl::app
