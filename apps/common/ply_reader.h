/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include "cloud_file.h"

#include <string>
#include <string_view>

namespace pcl::app {

/** \brief The vertices of a PLY file, text or binary little-endian: one field a
 * property. What follows the vertices, such as faces, is left out.
 * \throws InputError that names the path, what is wrong, and what is allowed */
CloudFile decodePly(const std::string& path, std::string_view file);

} // namespace pcl::app
