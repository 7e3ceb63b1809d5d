// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Scans of a room or a house front from stations, from their options.

#pragma once

#include "cli/arguments.h"
#include "cli/report.h"
#include "io/cloud_file.h"
#include "scene/station_scan.h"

namespace pcl::app {

/** \brief What -seed, -stations, -step and -noise say. \throws UsageError that names
 * the option and what is expected */
pcl::scene::StationOptions stationOptions(const Arguments& arguments);

/** \brief Scan a random room or house front. The fields are those of a table scene.
 * Parameters, counts and time are reported. */
CloudFile roomCloud(const Arguments& arguments,
                    const pcl::scene::StationOptions& options,
                    Report& report);

} // namespace pcl::app
