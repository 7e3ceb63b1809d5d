/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include "arguments.h"
#include "command_line.h"
#include "report.h"

namespace pcl::app {

void addResolutionOption(CommandLine& command_line);

/** \brief Metres, 0 if it is not given, for setResolution(). */
double resolutionOf(const Arguments& arguments);

/** \brief Note it among the parameters. */
void reportResolution(double resolution, Report& report);

} // namespace pcl::app
