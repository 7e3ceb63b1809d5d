/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <string>
#include <vector>

namespace pcl_shape_test {

/** \brief What a finished process left. */
struct Outcome {
  int status = -1; ///< exit status, or minus the signal that ended it
  std::string out;
  std::string err;
};

using Words = std::vector<std::string>;

/** \brief Run one of the project's apps. \throws std::runtime_error if it does not
 * start */
Outcome runApp(const std::string& app, const Words& arguments);

/** \brief Where one of the apps is. */
std::string pathOf(const std::string& app);

/** \brief Run any program. */
Outcome runProgram(const std::string& path, const Words& arguments);

} // namespace pcl_shape_test
