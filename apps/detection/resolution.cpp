// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The option -resolution.

#include "detection/resolution.h"

#include "cli/app.h"
#include "cli/errors.h"

#include <sstream>

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

void
reportResolution(const std::string& path, double of_field, double given, Report& report)
{
  reportResolution(of_field, report);
  if (of_field == given)
    return;
  std::ostringstream text;
  text << path
       << ": note: neighbors share noise that is larger than the distances between "
          "points: the result is that of -resolution "
       << of_field;
  logLine(text.str());
}

} // namespace pcl::app
