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

#include <limits>
#include <string_view>

namespace pcl::app {

/** \brief What is read of one cloud at most. */
constexpr std::uint64_t most_points = std::uint64_t{1} << 28;
constexpr std::uint64_t most_bytes = std::numeric_limits<std::uint32_t>::max();

/** \brief A PCD header that is consistent in itself. */
struct PCDHeader {
  CloudFile cloud; ///< fields, size, viewpoint; no data yet
  PCDFormat format = PCDFormat::ascii;
  std::size_t body = 0; ///< offset of the data in the file
};

/** \brief Read the header at the begin of a file.
 * \throws InputError that names the path, what is wrong, and what is allowed */
PCDHeader parseHeader(const std::string& path, std::string_view file);

} // namespace pcl::app
