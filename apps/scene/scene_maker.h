// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Makes scenes of each kind, as the options say.

#pragma once

#include "cli/command_line.h"
#include "cli/report.h"
#include "io/cloud_file.h"

#include <functional>

namespace pcl::app {

/** \brief Makes a random scene. Its parameters, counts and time are reported. */
using SceneMaker = std::function<CloudFile(Report& report)>;

/** \brief Objects on a table, as a depth camera sees them, or with -sampling points all
 * over their surfaces. The fields are x, y, z, the normals if -normals is given,
 * surface, edge, instance, crease_mm, and face if -faces is. \param[in] arguments must
 * outlive the result \throws UsageError that names an option and what is expected */
SceneMaker tableScene(const Arguments& arguments);

/** \brief A machined part, sampled all around or reconstructed from photographs. The
 * fields are those of a table, and crease_s, radius_s and thin_s in spacings. */
SceneMaker partScene(const Arguments& arguments);

/** \brief A room or a house front, scanned from stations. The fields are those of a
 * table. */
SceneMaker roomScene(const Arguments& arguments);

/** \brief A street, scanned by a laser scanner. The fields are x, y, z, the normals if
 * -normals is given, ground, surface, instance and ring. */
SceneMaker streetScene(const Arguments& arguments);

/** \brief The options of a laser scanner. */
void addLidarOptions(CommandLine& command_line);

} // namespace pcl::app
