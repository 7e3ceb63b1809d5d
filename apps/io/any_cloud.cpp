// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Chooses the reader and the writer by the ending of a file's name.

#include "io/any_cloud.h"

#include "cli/files.h"
#include "io/kitti_file.h"
#include "io/ply.h"
#include "io/text.h"

#include <algorithm>
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

CloudFile
decodeAnyCloud(const std::string& path, std::string_view file, unsigned floats)
{
  const std::string ending = endingOf(path);
  const auto& endings = cloudEndings();
  const bool is_known = std::count(endings.begin(), endings.end(), ending) > 0;
  std::string_view rest = file;
  const auto begins_as_ply = [&] {
    return splitWords(takeLine(rest)) == std::vector<std::string_view>{"ply"};
  };
  if (ending == ".bin" || (!is_known && floats > 0))
    return decodeVelodyne(path, file, floats);
  if (ending == ".ply" || (!is_known && begins_as_ply()))
    return decodePly(path, file);
  return decodePcd(path, file);
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
