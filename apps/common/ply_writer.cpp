/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "ply_writer.h"

#include "pcd_types.h"
#include "pcd_values.h"

#include <cstring>

namespace pcl::app {
namespace {

struct Property {
  std::string name;
  const char* type;
  std::size_t offset; ///< of its bytes in a point
  std::size_t size;
};

/** PLY's name of a type, or nullptr. */
const char*
plyType(std::uint8_t datatype)
{
  switch (datatype) {
  case pcl::PCLPointField::INT8:
    return "char";
  case pcl::PCLPointField::UINT8:
    return "uchar";
  case pcl::PCLPointField::INT16:
    return "short";
  case pcl::PCLPointField::UINT16:
    return "ushort";
  case pcl::PCLPointField::INT32:
    return "int";
  case pcl::PCLPointField::UINT32:
    return "uint";
  case pcl::PCLPointField::FLOAT32:
    return "float";
  case pcl::PCLPointField::FLOAT64:
    return "double";
  default:
    return nullptr;
  }
}

bool
isColor(const pcl::PCLPointField& field)
{
  return (field.name == "rgb" || field.name == "rgba") &&
         valueSize(field.datatype) == sizeof(std::uint32_t) && field.count == 1;
}

/** PCL packs a colour as 0xAARRGGBB. */
void
addColor(const pcl::PCLPointField& field, std::vector<Property>& properties)
{
  const char* const names[] = {"red", "green", "blue", "alpha"};
  const std::size_t bytes[] = {2, 1, 0, 3};
  for (std::size_t c = 0; c < (field.name == "rgba" ? 4u : 3u); ++c)
    properties.push_back({names[c], "uchar", field.offset + bytes[c], 1});
}

std::vector<Property>
propertiesOf(const CloudFile& cloud)
{
  std::vector<Property> properties;
  for (const auto& field : cloud.blob.fields) {
    const char* const type = plyType(field.datatype);
    const std::size_t size = valueSize(field.datatype);
    if (field.name == padding_field || !type)
      continue;
    if (isColor(field))
      addColor(field, properties);
    else if (field.count == 1)
      properties.push_back({field.name, type, field.offset, size});
    else
      for (std::uint32_t i = 0; i < field.count; ++i)
        properties.push_back({field.name + '_' + std::to_string(i),
                              type,
                              field.offset + i * size,
                              size});
  }
  return properties;
}

std::string
encodeHeader(const CloudFile& cloud, const std::vector<Property>& properties)
{
  std::string text = "ply\nformat binary_little_endian 1.0\ncomment viewpoint";
  for (const float value : cloud.viewpoint)
    appendNumber(value, text += ' ');
  if (cloud.blob.height > 1)
    text += "\nobj_info num_cols " + std::to_string(cloud.blob.width) +
            "\nobj_info num_rows " + std::to_string(cloud.blob.height);
  text += "\nelement vertex " + std::to_string(cloud.size()) + '\n';
  for (const Property& property : properties)
    text += std::string("property ") + property.type + ' ' + property.name + '\n';
  return text + "end_header\n";
}

} // namespace

std::string
encodePly(const CloudFile& cloud)
{
  const std::vector<Property> properties = propertiesOf(cloud);
  std::size_t step = 0;
  for (const Property& property : properties)
    step += property.size;
  std::string text = encodeHeader(cloud, properties);
  const std::size_t begin = text.size();
  text.resize(begin + step * cloud.size());
  char* to = text.data() + begin;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    for (const Property& property : properties) {
      const std::size_t from = i * cloud.blob.point_step + property.offset;
      std::memcpy(to, cloud.blob.data.data() + from, property.size);
      to += property.size;
    }
  return text;
}

std::vector<std::string>
fieldsWithoutPly(const CloudFile& cloud)
{
  std::vector<std::string> names;
  for (const auto& field : cloud.blob.fields)
    if (field.name != padding_field && !plyType(field.datatype))
      names.push_back(field.name);
  return names;
}

} // namespace pcl::app
