// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Renames fields to PCL's names and packs colors.

#include "io/pcl_names.h"

#include "io/text.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

namespace pcl::app {
namespace {

constexpr std::array<const char*, 10> known_names{"x",
                                                  "y",
                                                  "z",
                                                  "normal_x",
                                                  "normal_y",
                                                  "normal_z",
                                                  "curvature",
                                                  "rgb",
                                                  "rgba",
                                                  "intensity"};

void
rename(CloudFile& cloud, pcl::PCLPointField& field, const std::string& name)
{
  if (!findField(cloud, name))
    field.name = name;
}

const pcl::PCLPointField*
findByte(const CloudFile& cloud, const std::string& name)
{
  const pcl::PCLPointField* const field = findField(cloud, name);
  return field && field->datatype == pcl::PCLPointField::UINT8 && field->count == 1
             ? field
             : nullptr;
}

/** The channels of a color in the order of a packed one's bytes, or fewer. */
std::vector<const pcl::PCLPointField*>
channelsOf(const CloudFile& cloud, const std::string& prefix)
{
  std::vector<const pcl::PCLPointField*> channels;
  for (const char* const name : {"blue", "green", "red"})
    if (const pcl::PCLPointField* const field = findByte(cloud, prefix + name))
      channels.push_back(field);
  if (const pcl::PCLPointField* const alpha = findByte(cloud, "alpha");
      alpha && channels.size() == 3)
    channels.push_back(alpha);
  return channels;
}

/** Replace three or four bytes by one field in the place of red. */
void
packColors(CloudFile& cloud, const std::string& prefix)
{
  const auto channels = channelsOf(cloud, prefix);
  const bool has_alpha = channels.size() == 4;
  if (channels.size() < 3 || findField(cloud, "rgb") || findField(cloud, "rgba"))
    return;
  constexpr std::size_t bytes = sizeof(std::uint32_t);
  std::vector<std::uint8_t> packed(cloud.size() * bytes, 0);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    for (std::size_t c = 0; c < channels.size(); ++c)
      packed[i * bytes + c] = *cloud.at(i, *channels[c]); // 0xAARRGGBB
  pcl::PCLPointField color;
  color.name = has_alpha ? "rgba" : "rgb";
  color.datatype = has_alpha ? pcl::PCLPointField::UINT32 : pcl::PCLPointField::FLOAT32;
  color.count = 1;
  constexpr std::size_t red = 2;
  std::vector<FieldSource> sources;
  for (const FieldSource& source : sourcesOf(cloud)) {
    const auto channel =
        std::find_if(channels.begin(), channels.end(), [&](const auto* c) {
          return c->offset == source.field.offset;
        });
    if (channel == channels.end())
      sources.push_back(source);
    else if (*channel == channels[red])
      sources.push_back({color, packed.data(), bytes});
  }
  setFields(cloud, sources);
}

/** pcl::PLYReader makes a byte of intensity a float. */
void
widenIntensity(CloudFile& cloud)
{
  if (!findByte(cloud, "intensity"))
    return;
  std::vector<float> values;
  for (const double value : numbersOf(cloud, "intensity"))
    values.push_back(static_cast<float>(value));
  setField(cloud, "intensity", values);
}

} // namespace

void
usePclNames(CloudFile& cloud)
{
  for (auto& field : cloud.blob.fields) {
    const std::string name = toLower(field.name);
    if (std::count(known_names.begin(), known_names.end(), name) > 0)
      rename(cloud, field, name);
  }
}

void
usePclNamesOfPly(CloudFile& cloud)
{
  usePclNames(cloud);
  constexpr std::array<std::pair<const char*, const char*>, 3> normals{
      {{"nx", "normal_x"}, {"ny", "normal_y"}, {"nz", "normal_z"}}};
  for (auto& field : cloud.blob.fields)
    for (const auto& [ply, pcl_name] : normals)
      if (field.name == ply)
        rename(cloud, field, pcl_name);
  packColors(cloud, "");
  packColors(cloud, "diffuse_");
  widenIntensity(cloud);
}

} // namespace pcl::app
