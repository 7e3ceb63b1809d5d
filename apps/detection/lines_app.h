// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Creases as lines in a JSON file beside the output, complete or not at all.

#pragma once

#include "cli/arguments.h"
#include "cli/report.h"
#include "io/cloud_file.h"

#include <pcl/segmentation/shape_edge_detection.h>

#include <functional>
#include <vector>

namespace pcl::app {

/** \brief Adds fields to a cloud. \return its creases, if -lines is given */
using LineFilter =
    std::function<std::vector<pcl::CreaseLine>(CloudFile& cloud, Report& report)>;

/** \brief runFilter() that also writes the -lines file, if it is asked for. */
int runFilterWithLines(const Arguments& arguments, const LineFilter& filter);

} // namespace pcl::app
