// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Reads and writes a cloud of any known format.

#pragma once

#include "io/cloud_file.h"
#include "io/pcd.h"

#include <string>
#include <string_view>
#include <vector>

namespace pcl::app {

/** \brief The endings of the files that readAnyCloud() knows: .pcd, .ply, .bin. */
const std::vector<std::string>& cloudEndings();

/** \brief A path's ending in lower case, such as .pcd. */
std::string endingOf(const std::string& path);

enum class CloudFormat { pcd, ply, kitti };

/** \brief The format that the path's ending says, in whatever case: .bin is a
 * velodyne/NAME.bin of KITTI. With another ending a file is KITTI's if the floats of
 * a point are given, PLY if it begins so, else PCD. \param[in] head the first bytes of
 * the file. \throws InputError if it is a pointer of Git LFS */
CloudFormat
cloudFormatOf(const std::string& path, std::string_view head, unsigned floats);

/** \brief A cloud of one of these formats. \param[in] floats of a point of KITTI's, 4
 * or 5; 0 if the file's size says it \throws InputError that names the path, what is
 * wrong, and what is expected */
CloudFile
decodeAnyCloud(const std::string& path, std::string_view file, unsigned floats = 0);

/** \brief The same of a file, or of standard input if the path is "-". */
CloudFile readAnyCloud(const std::string& path, unsigned floats = 0);

/** \brief The bytes of a PLY file if the path's ending says so, else of a PCD file.
 * Text is text in both. */
std::string
encodeAnyCloud(const std::string& path, const CloudFile& cloud, PCDFormat format);

/** \brief The fields that encodeAnyCloud() leaves out. */
std::vector<std::string> fieldsLeftOut(const std::string& path, const CloudFile& cloud);

} // namespace pcl::app
