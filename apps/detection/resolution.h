// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The option -resolution.

#pragma once

#include "cli/arguments.h"
#include "cli/command_line.h"
#include "cli/report.h"

namespace pcl::app {

void addResolutionOption(CommandLine& command_line);

/** \brief Meters, 0 if it is not given, for setResolution(). */
double resolutionOf(const Arguments& arguments);

/** \brief Note it among the parameters. */
void reportResolution(double resolution, Report& report);

} // namespace pcl::app
