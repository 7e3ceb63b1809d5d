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

namespace pcl::app {

/** \brief Read a PCD file, strictly: everything is checked against the size of the file
 * before memory is taken for it. (pcl::PCDReader crashes on some malformed files, and
 * accepts others.)
 * \throws InputError that names the path, what is wrong, and what is allowed */
CloudFile readCloud(const std::string& path);

} // namespace pcl::app
