/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include "cloud_file.h"
#include "command_line.h"
#include "report.h"

namespace pcl::app {

/** \brief -sensor and the options of a laser scanner. */
void addLidarOptions(CommandLine& command_line);

/** \brief Whether the scene is to be a street that a laser scanner sees.
 * \throws UsageError for options of the one sensor with the other */
bool isLidar(const Arguments& arguments);

/** \brief Scan a random street. The fields are x, y, z, the normals if -normals is
 * given, ground, surface, instance and ring. Parameters, counts and time are reported.
 */
CloudFile lidarCloud(const Arguments& arguments, Report& report);

} // namespace pcl::app
