// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Runs over the files of a directory, of which some may fail.

#pragma once

#include "cli/arguments.h"
#include "cli/report.h"

#include <functional>
#include <string>
#include <vector>

namespace pcl::app {

/** \brief The files of a directory with one of these endings, in whatever case, sorted.
 * \throws InputError if there is none */
std::vector<std::string> cloudsIn(const std::string& directory,
                                  const std::vector<std::string>& endings);

/** \brief Create a directory unless it exists. \throws InputError if it cannot be made
 */
void makeDirectory(const std::string& directory);

/** \brief The same. \throws UsageError if it is the input directory */
void prepareOutputDirectory(const std::string& output, const std::string& input);

/** \brief \throws InputError if two inputs have the same output */
void requireDifferent(const std::vector<std::string>& inputs,
                      const std::vector<std::string>& outputs);

/** \brief Process a file; its report is printed and goes to the -json file. \return
 * false if there was nothing to do, because it was done before */
using FileJob = std::function<bool(const std::string& input, Report& report)>;

/** \brief Do a job for each file. Standard error shows which file is next and how long
 * the rest will take, estimated from their sizes. Files that fail do not stop the
 * others. The -json file lists all.
 * \param[in] finish called after the last file
 * \return the exit status */
int runBatch(
    const Arguments& arguments,
    const std::vector<std::string>& inputs,
    const FileJob& job,
    const std::function<void()>& finish = [] {});

} // namespace pcl::app
