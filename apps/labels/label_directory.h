// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Labels all clouds of a directory, what is missing only.

#pragma once

#include "cli/arguments.h"

#include <string>

namespace pcl::app {

/** \brief Label every cloud of a directory into another, with a manifest there. What
 * the manifest lists is not done again. Progress goes to standard error. \return the
 * exit status: files that fail don't stop the others */
int labelDirectory(const Arguments& arguments,
                   const std::string& input,
                   const std::string& output);

} // namespace pcl::app
