// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Labels those clouds of a directory that have no labels yet.

#pragma once

#include "cli/arguments.h"

#include <string>

namespace pcl::app {

/** \brief Label every cloud of a directory into another, with a manifest there. Clouds
 * in the manifest are skipped. Progress goes to standard error. \return the exit
 * status: files that fail don't stop the others */
int labelDirectory(const Arguments& arguments,
                   const std::string& input,
                   const std::string& output);

} // namespace pcl::app
