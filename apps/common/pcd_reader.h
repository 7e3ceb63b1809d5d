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

#include <string_view>

namespace pcl::app {

/** \brief Read a PCD file, strictly: everything is checked against the size of the file
 * before memory is taken for it. (pcl::PCDReader crashes on some malformed files, and
 * accepts others.)
 * \throws InputError that names the path, what is wrong, and what is allowed */
CloudFile readCloud(const std::string& path);

/** \brief The same of a file that was read already. */
CloudFile decodePcd(const std::string& path, std::string_view file);

/** \brief Fill a cloud whose fields and size are known: one row of text a point. */
void readAsciiPoints(CloudFile& cloud, std::string_view body);

/** \brief The same from packed bytes, little-endian. */
void readBinaryPoints(CloudFile& cloud, std::string_view body);

} // namespace pcl::app
