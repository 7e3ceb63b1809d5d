// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Reads and writes PLY files.

#pragma once

#include "io/cloud_file.h"
#include "io/pcd.h"

#include <string>
#include <string_view>
#include <vector>

namespace pcl::app {

/** \brief The vertices of a PLY file, text or binary of either order of bytes: one
 * field a property, with PCL's names (see usePclNamesOfPly()). Lists are left out, and
 * all elements but a camera, which gives the viewpoint and the size of an image, and a
 * range_grid, which says where the vertices are in it. \throws InputError that names
 * the path, what is wrong, and what is expected */
CloudFile decodePly(const std::string& path, std::string_view file);

/** \brief The header of a PLY file, of any number of points; nothing unless the points
 * come first, without lists, as text or little-endian, and without a camera or
 * range_grid. \param[in] head the first bytes of the file, with all of the header */
std::optional<PointRows> rowsOfPly(const std::string& path, std::string_view head);

/** \brief What is before the points in encodePly(), and the points. */
std::string encodePlyHeader(const CloudFile& cloud, bool is_text);
std::string encodePlyPoints(const CloudFile& cloud, bool is_text);

/** \brief The bytes of a PLY file with one element, vertex, binary little-endian or
 * text.
 *
 * A field becomes a property of the same name and type, one of several values
 * name_0, name_1 ..., normal_x and so on nx ny nz, a packed color red, green, blue (and
 * alpha), so that it reads back as it was. The viewpoint
 * is a comment, the layout of an organized cloud obj_info, as pcl::PLYWriter's. */
std::string encodePly(const CloudFile& cloud, bool is_text = false);

/** \brief The names of the fields that encodePly() leaves out: PLY has no 64-bit
 * integers. */
std::vector<std::string> fieldsWithoutPly(const CloudFile& cloud);

} // namespace pcl::app
