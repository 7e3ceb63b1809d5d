// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Reads and writes PLY files.

#pragma once

#include "io/cloud_file.h"

#include <string>
#include <string_view>
#include <vector>

namespace pcl::app {

/** \brief The vertices of a PLY file, text or binary little-endian: one field a
 * property. What follows the vertices, such as faces, is left out.
 * \throws InputError that names the path, what is wrong, and what is expected */
CloudFile decodePly(const std::string& path, std::string_view file);

/** \brief The bytes of a binary little-endian PLY file with one element, vertex.
 *
 * A field becomes a property of the same name and type, one of several values
 * name_0, name_1 ..., and a packed color red, green, blue (and alpha). The viewpoint
 * is a comment, the layout of an organized cloud obj_info, as pcl::PLYWriter's. */
std::string encodePly(const CloudFile& cloud);

/** \brief The names of the fields that encodePly() leaves out: PLY has no 64-bit
 * integers. */
std::vector<std::string> fieldsWithoutPly(const CloudFile& cloud);

} // namespace pcl::app
