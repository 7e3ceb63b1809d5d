// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Reads the input clouds of an app, with the options that apply to all of them.

#pragma once

#include "cli/command_line.h"
#include "cli/report.h"
#include "io/cloud_file.h"

#include <array>
#include <optional>
#include <string>

namespace pcl::app {

/** \brief -offset and -floats. */
void addInputOptions(CommandLine& command_line);

/** \brief -offset, if it is given. */
std::optional<std::array<double, 3>> givenOffset(const Arguments& arguments);

/** \brief Whether a coordinate has more digits than float: doubles, and integers of 32
 * bits or more. */
bool exceedFloats(const CloudFile& cloud);

/** \brief Throws a UsageError for what is wrong with these options. */
void checkInputOptions(const Arguments& arguments);

/** \brief Read a cloud of any format, from standard input for "-", and choose its
 * offset: -offset, or where its coordinates are doubles that float does not hold, one
 * near its middle. An offset is printed on standard error and noted in the report. A
 * warning says if float has destroyed the coordinates. */
CloudFile
readInput(const Arguments& arguments, const std::string& path, Report& report);

/** \brief Choose the offset of a cloud that was read already. */
void chooseOffset(const Arguments& arguments, CloudFile& cloud, Report& report);

/** \brief Print the offset of a cloud, if it has one. */
void logOffset(const Arguments& arguments,
               const std::string& cloud,
               const std::array<double, 3>& offset);

/** \brief -floats, or 0. */
unsigned floatsOfBin(const Arguments& arguments);

} // namespace pcl::app
