// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Scenes of a laser scanner in a street, from their options.

#pragma once

#include "cli/command_line.h"
#include "cli/report.h"
#include "io/cloud_file.h"

namespace pcl::app {

/** \brief The options of a laser scanner. */
void addLidarOptions(CommandLine& command_line);

/** \brief Scan a random street. The fields are x, y, z, the normals if -normals is
 * given, ground, surface, instance and ring. Parameters, counts and time are reported.
 */
CloudFile lidarCloud(const Arguments& arguments, Report& report);

} // namespace pcl::app
