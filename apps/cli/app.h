// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What is around the main() of every app.

#pragma once

#include "cli/command_line.h"

namespace pcl::app {

/** \brief What every main() does: help, version, and from exceptions to one line on
 * standard error and the exit status. \param[in] run the app; its result is the exit
 * status */
int runApp(const CommandLine& command_line,
           int argc,
           const char* const* argv,
           int (*run)(const Arguments&));

/** \brief One line on standard error. */
void logLine(const std::string& line);

} // namespace pcl::app
