// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Files of KITTI and SemanticKITTI: four floats a point, labels, classes in YAML.

#include "io/kitti_file.h"

#include "io/errors.h"
#include "io/pcd.h"
#include "io/text.h"

#include <array>
#include <cstring>

namespace pcl::app {
namespace {

constexpr std::size_t values_per_point = 4;
constexpr std::size_t point_bytes = values_per_point * sizeof(float);

std::vector<float>
intensitiesOf(const CloudFile& cloud)
{
  for (const char* name : {"intensity", "reflectivity", "remission"}) {
    const pcl::PCLPointField* const field = findField(cloud, name);
    if (field && field->datatype == pcl::PCLPointField::FLOAT32 && field->count == 1)
      return floatsOf(cloud, name);
  }
  return std::vector<float>(cloud.size(), 0.0f);
}

/** Void black, planar blue, curved orange, edges red; then others, in blue, green, red
 * as SemanticKITTI has them. */
std::string
colorOf(std::size_t label)
{
  constexpr std::array<const char*, 10> colors{"[0, 0, 0]",
                                               "[180, 119, 31]",
                                               "[14, 127, 255]",
                                               "[40, 39, 214]",
                                               "[44, 160, 44]",
                                               "[189, 103, 148]",
                                               "[75, 86, 140]",
                                               "[194, 119, 227]",
                                               "[34, 189, 188]",
                                               "[207, 190, 23]"};
  return colors[label < colors.size() ? label : 1 + label % (colors.size() - 1)];
}

template <typename ValueOf>
void
appendMap(const char* key,
          std::size_t labels,
          std::string& text,
          const ValueOf& valueOf)
{
  text += std::string(key) + ":\n";
  for (std::size_t label = 0; label < labels; ++label)
    text += "  " + std::to_string(label) + ": " + valueOf(label) + '\n';
}

/** As many as fit the size of the file; if both do, nobody can tell. */
unsigned
floatsOfPoint(const std::string& path, std::size_t bytes)
{
  const bool fits_four = bytes % (4 * sizeof(float)) == 0;
  const bool fits_five = bytes % (5 * sizeof(float)) == 0;
  if (bytes == 0 || (!fits_four && !fits_five))
    throw InputError(path + ": " + std::to_string(bytes) +
                     " bytes; expected 16 for each point, x y z intensity, or 20, with "
                     "ring");
  if (fits_four && fits_five)
    throw InputError(path + ": " + std::to_string(bytes) + " bytes are " +
                     std::to_string(bytes / 16) + " points of 4 floats or " +
                     std::to_string(bytes / 20) +
                     " of 5; expected -floats 4 (x y z intensity, as of KITTI) or "
                     "-floats 5 (with ring, as of nuScenes)");
  return fits_four ? 4 : 5;
}

} // namespace

CloudFile
decodeVelodyne(const std::string& path, std::string_view file, unsigned floats)
{
  const unsigned columns = floats > 0 ? floats : floatsOfPoint(path, file.size());
  const std::size_t bytes = columns * sizeof(float);
  if (file.empty() || file.size() % bytes != 0)
    throw InputError(path + ": " + std::to_string(file.size()) + " bytes; expected " +
                     std::to_string(bytes) + " for each point, by -floats " +
                     std::to_string(columns));
  if (file.size() > max_bytes)
    throw InputError(path + ": " + std::to_string(file.size()) +
                     " bytes; must be less than 4 GiB");
  CloudFile cloud;
  cloud.path = path;
  constexpr std::array<const char*, 5> names{"x", "y", "z", "intensity", "ring"};
  for (unsigned c = 0; c < columns; ++c)
    addField(cloud, names[c], pcl::PCLPointField::FLOAT32);
  cloud.blob.width = static_cast<std::uint32_t>(file.size() / bytes);
  cloud.blob.height = 1;
  cloud.blob.row_step = static_cast<std::uint32_t>(file.size());
  readBinaryPoints(cloud, file);
  return cloud;
}

std::string
encodeVelodyne(const CloudFile& cloud)
{
  const auto points = pointsOf(cloud);
  const std::vector<float> intensities = intensitiesOf(cloud);
  std::string bytes(point_bytes * cloud.size(), '\0');
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const auto& p = (*points)[i];
    const std::array<float, values_per_point> point{p.x, p.y, p.z, intensities[i]};
    std::memcpy(bytes.data() + i * point_bytes, point.data(), point_bytes);
  }
  return bytes;
}

std::string
encodeLabels(const std::vector<std::uint32_t>& labels)
{
  std::string bytes(labels.size() * sizeof(std::uint32_t), '\0');
  if (!labels.empty())
    std::memcpy(bytes.data(), labels.data(), bytes.size());
  return bytes;
}

std::string
encodeKittiClasses(const std::vector<KittiClass>& classes)
{
  const std::size_t count = classes.size();
  const auto same = [](std::size_t label) { return std::to_string(label); };
  std::string text = "# Classes of pcl_shape_label, with the keys of SemanticKITTI's "
                     "configuration.\nname: \"pcl_shape\"\n";
  appendMap("labels", count, text, [&](std::size_t label) {
    return '"' + classes[label].name + '"';
  });
  text += "# blue, green, red\n";
  appendMap("color_map", count, text, colorOf);
  text += "# shares of the points\n";
  appendMap("content", count, text, [&](std::size_t label) {
    std::string share;
    appendNumber(classes[label].share, share);
    return share;
  });
  appendMap("learning_map", count, text, same);
  appendMap("learning_map_inv", count, text, same);
  appendMap("learning_ignore", count, text, [](std::size_t label) {
    return std::string(label == 0 ? "True" : "False");
  });
  return text + "split:\n  train:\n    - 0\n  valid: []\n  test: []\n";
}

} // namespace pcl::app
