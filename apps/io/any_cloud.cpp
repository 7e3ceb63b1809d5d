// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Chooses the reader and the writer by the ending of a file's name.

#include "io/any_cloud.h"

#include "io/errors.h"
#include "io/files.h"
#include "io/kitti_file.h"
#include "io/ply.h"
#include "io/text.h"

#include <filesystem>

namespace pcl::app {

const std::vector<std::string>&
cloudEndings()
{
  static const std::vector<std::string> endings{".pcd", ".ply", ".bin"};
  return endings;
}

std::string
endingOf(const std::string& path)
{
  return toLower(std::filesystem::path(path).extension().string());
}

CloudFormat
cloudFormatOf(const std::string& path, std::string_view head, unsigned floats)
{
  constexpr std::string_view pointer = "version https://git-lfs";
  if (head.substr(0, pointer.size()) == pointer)
    throw InputError(path + ": a pointer of Git LFS; expected the file itself, which "
                            "'git lfs pull' fetches");
  const std::string ending = endingOf(path);
  if (ending == ".pcd")
    return CloudFormat::pcd;
  if (ending == ".bin")
    return CloudFormat::kitti;
  if (ending == ".ply")
    return CloudFormat::ply;
  if (floats > 0)
    return CloudFormat::kitti;
  return withoutByteOrderMark(head).substr(0, 3) == "ply" ? CloudFormat::ply
                                                          : CloudFormat::pcd;
}

CloudFile
decodeAnyCloud(const std::string& path, std::string_view file, unsigned floats)
{
  switch (cloudFormatOf(path, file, floats)) {
  case CloudFormat::kitti:
    return decodeVelodyne(path, file, floats);
  case CloudFormat::ply:
    return decodePly(path, file);
  default:
    return decodePcd(path, file);
  }
}

CloudFile
readAnyCloud(const std::string& path, unsigned floats)
{
  return decodeAnyCloud(path, readFile(path, "a PCD, PLY or KITTI .bin file"), floats);
}

std::string
encodeAnyCloud(const std::string& path, const CloudFile& cloud, PCDFormat format)
{
  return endingOf(path) == ".ply" ? encodePly(cloud, format == PCDFormat::ascii)
                                  : encodeCloud(cloud, format);
}

std::vector<std::string>
fieldsLeftOut(const std::string& path, const CloudFile& cloud)
{
  return endingOf(path) == ".ply" ? fieldsWithoutPly(cloud)
                                  : std::vector<std::string>();
}

} // namespace pcl::app
