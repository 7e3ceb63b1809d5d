// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Chooses the reader by the ending of a file's name.

#include "io/any_cloud.h"

#include "cli/read_file.h"
#include "io/kitti_file.h"
#include "io/pcd.h"
#include "io/ply.h"

#include <filesystem>

namespace pcl::app {

const std::vector<std::string>&
cloudEndings()
{
  static const std::vector<std::string> endings{".pcd", ".ply", ".bin"};
  return endings;
}

CloudFile
decodeAnyCloud(const std::string& path, std::string_view file)
{
  const std::string ending = std::filesystem::path(path).extension();
  if (ending == ".ply")
    return decodePly(path, file);
  if (ending == ".bin")
    return decodeVelodyne(path, file);
  return decodePcd(path, file);
}

CloudFile
readAnyCloud(const std::string& path)
{
  return decodeAnyCloud(path, readFile(path, "a PCD, PLY or KITTI .bin file"));
}

} // namespace pcl::app
