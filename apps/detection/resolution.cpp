// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The option -resolution.

#include "detection/resolution.h"

#include "cli/errors.h"

namespace pcl::app {

void
addResolutionOption(CommandLine& command_line)
{
  command_line.option(
      "resolution", "L", "look no finer than L meters, in clouds with many points");
}

double
resolutionOf(const Arguments& arguments)
{
  return arguments.number("resolution", positive_length).value_or(0.0);
}

void
reportResolution(double resolution, Report& report)
{
  report.setNumber("parameters", "resolution", resolution);
}

} // namespace pcl::app
