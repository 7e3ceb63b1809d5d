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

namespace pcl::app {

/** \brief All bytes of a regular file. \param[in] allowed what the file should be, for
 * messages, such as "a PCD file" \throws InputError that names the path */
std::string readFile(const std::string& path, const std::string& allowed);

} // namespace pcl::app
