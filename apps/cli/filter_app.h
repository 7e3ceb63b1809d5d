// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Apps that add fields to one cloud or all clouds of a directory; options of all apps.

#pragma once

#include "cli/command_line.h"
#include "cli/input.h"
#include "cli/report.h"
#include "io/cloud_file.h"
#include "io/files.h"
#include "io/pcd.h"

#include <functional>
#include <string>
#include <vector>

namespace pcl::app {

/** \brief Add fields to a cloud and report what was done. */
using Filter = std::function<void(CloudFile& cloud, Report& report)>;

/** \brief The options of runFilter(). */
void addFilterOptions(CommandLine& command_line);

/** \brief -format. */
void addFormatOption(CommandLine& command_line);

PCDFormat outputFormat(const Arguments& arguments);

/** \brief What a step or a tile has freed is for the next one. Large blocks would go
 * back to the system, which clears each of their pages when it gives them again. */
void keepFreedMemory();

/** \brief -threads and -json, which every app has. \param[in] is_parallel whether
 * -threads has an effect */
void addCommonOptions(CommandLine& command_line, bool is_parallel = true);

/** \brief A warning, if there are such fields. */
void warnOfFieldsLeftOut(const Arguments& arguments,
                         const std::string& path,
                         const std::vector<std::string>& fields);

/** \brief The bytes of a cloud file for a path, and a warning where a field is left out
 * because its format cannot hold it. */
std::string encodeOutput(const Arguments& arguments,
                         const std::string& path,
                         const CloudFile& cloud,
                         PCDFormat format);

/** \brief Read a cloud, filter it and write it; or every cloud of -input_dir to
 * -output_dir. Keeps freed memory for the next cloud. A summary of each goes to
 * standard output, and to the -json file.
 * \return the exit status: in a directory, files that fail don't stop the others */
int runFilter(const Arguments& arguments, const Filter& filter);

/** \brief Note the sizes of a cloud. */
void reportPoints(const pcl::PointCloud<pcl::PointXYZ>& points, Report& report);

/** \brief One line with the counts and the time of a file. */
void printSummary(const std::string& path, const Report& report);

/** \brief The same on standard error if the output file is standard output. */
void
printSummary(const std::string& path, const Report& report, const std::string& output);

/** \brief Throws if the -json file cannot be written, or is one of the given files or
 * the -model file. */
void checkJsonPath(const Arguments& arguments, const std::vector<std::string>& others);

/** \brief The same for another option whose value is a file to write. */
void checkOutputPath(const Arguments& arguments,
                     const std::string& option,
                     const std::vector<std::string>& others);

/** \brief Throws if one of the files to write is the -model file. */
void checkOutputs(const Arguments& arguments, const std::vector<std::string>& outputs);

/** \brief The same for one cloud; also throws if its ending is KITTI's .bin, or
 * known as that of another format. */
void checkCloudOutput(const Arguments& arguments, const std::string& output);

/** \brief Make the output and the -json file appear, once both are written. */
void commitWithJson(const Arguments& arguments,
                    const std::string& contents,
                    AtomicFile& output);

/** \brief Write the -json file, if there is one. */
void writeJson(const Arguments& arguments, const std::string& contents);

} // namespace pcl::app
