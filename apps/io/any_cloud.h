// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Reads a cloud of any known format.

#pragma once

#include "io/cloud_file.h"

#include <string>
#include <string_view>
#include <vector>

namespace pcl::app {

/** \brief The endings of the files that readAnyCloud() knows: .pcd, .ply, .bin. */
const std::vector<std::string>& cloudEndings();

/** \brief A cloud of the format that its path's ending says: PCD, PLY, or the
 * velodyne/NAME.bin of KITTI; any other ending is taken for PCD.
 * \throws InputError that names the path, what is wrong, and what is expected */
CloudFile decodeAnyCloud(const std::string& path, std::string_view file);

CloudFile readAnyCloud(const std::string& path);

} // namespace pcl::app
