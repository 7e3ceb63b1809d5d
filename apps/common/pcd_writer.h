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
#include "pcd_types.h"

#include <string>

namespace pcl::app {

/** \brief The bytes of a PCD file. Numbers in text read back as the same numbers. */
std::string encodeCloud(const CloudFile& cloud, PCDFormat format);

} // namespace pcl::app
