// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The option -resolution.

#pragma once

#include "cli/arguments.h"
#include "cli/command_line.h"
#include "cli/report.h"

#include <string>

namespace pcl::app {

void addResolutionOption(CommandLine& command_line);

/** \brief Meters, 0 if it is not given, for setResolution(). */
double resolutionOf(const Arguments& arguments);

/** \brief Note it among the parameters. */
void reportResolution(double resolution, Report& report);

/** \brief Note the one that a field has. If it is not the given one it is said why. */
void reportResolution(const std::string& path,
                      double of_field,
                      double given,
                      Report& report);

} // namespace pcl::app
