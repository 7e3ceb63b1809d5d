/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "pcd_writer.h"

#include "errors.h"
#include "lzf.h"
#include "pcd_values.h"

#include <limits>

namespace pcl::app {
namespace {

/** Colours are bits: as a float, many are NaN, and text would lose them. */
bool
isColor(const pcl::PCLPointField& field)
{
  return (field.name == "rgb" || field.name == "rgba") &&
         field.datatype == pcl::PCLPointField::FLOAT32;
}

std::uint8_t
writtenType(const pcl::PCLPointField& field, PCDFormat format)
{
  if (format == PCDFormat::ascii && isColor(field))
    return pcl::PCLPointField::UINT32;
  return field.datatype;
}

std::string
encodeHeader(const CloudFile& cloud, PCDFormat format)
{
  std::string names = "FIELDS";
  std::string sizes = "SIZE";
  std::string types = "TYPE";
  std::string counts = "COUNT";
  for (const auto& field : cloud.blob.fields) {
    names += ' ' + field.name;
    sizes += ' ' + std::to_string(valueSize(field.datatype));
    types += std::string(" ") + typeLetter(writtenType(field, format));
    counts += ' ' + std::to_string(field.count);
  }
  std::string viewpoint = "VIEWPOINT";
  for (const float value : cloud.viewpoint)
    appendNumber(value, viewpoint += ' ');
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n" + names + '\n' +
         sizes + '\n' + types + '\n' + counts + "\nWIDTH " +
         std::to_string(cloud.blob.width) + "\nHEIGHT " +
         std::to_string(cloud.blob.height) + '\n' + viewpoint + "\nPOINTS " +
         std::to_string(cloud.size()) + "\nDATA " + nameOf(format) + '\n';
}

template <typename T>
void
appendValue(const std::uint8_t* from, std::string& text)
{
  T value;
  std::memcpy(&value, from, sizeof(value));
  if (value != value)
    text += "nan";
  else
    appendNumber(value, text);
}

void
appendValue(std::uint8_t datatype, const std::uint8_t* from, std::string& text)
{
  switch (datatype) {
  case pcl::PCLPointField::INT8:
    return appendValue<std::int8_t>(from, text);
  case pcl::PCLPointField::UINT8:
    return appendValue<std::uint8_t>(from, text);
  case pcl::PCLPointField::INT16:
    return appendValue<std::int16_t>(from, text);
  case pcl::PCLPointField::UINT16:
    return appendValue<std::uint16_t>(from, text);
  case pcl::PCLPointField::INT32:
    return appendValue<std::int32_t>(from, text);
  case pcl::PCLPointField::UINT32:
    return appendValue<std::uint32_t>(from, text);
  case pcl::PCLPointField::INT64:
    return appendValue<std::int64_t>(from, text);
  case pcl::PCLPointField::UINT64:
    return appendValue<std::uint64_t>(from, text);
  case pcl::PCLPointField::FLOAT32:
    return appendValue<float>(from, text);
  default:
    return appendValue<double>(from, text);
  }
}

void
appendAscii(const CloudFile& cloud, std::string& text)
{
  const std::uint8_t* from = cloud.blob.data.data();
  for (std::size_t point = 0; point < cloud.size(); ++point) {
    for (const auto& field : cloud.blob.fields) {
      const std::uint8_t datatype = writtenType(field, PCDFormat::ascii);
      for (std::uint32_t i = 0; i < field.count; ++i, from += valueSize(datatype)) {
        appendValue(datatype, from, text);
        text += ' ';
      }
    }
    text.back() = '\n';
  }
}

/** The points as columns, one field after the other. */
std::vector<std::uint8_t>
columnsOf(const CloudFile& cloud)
{
  std::vector<std::uint8_t> columns(cloud.blob.data.size());
  std::uint8_t* to = columns.data();
  for (const auto& field : cloud.blob.fields) {
    const std::size_t bytes = valueSize(field.datatype) * field.count;
    const std::uint8_t* from = cloud.blob.data.data() + field.offset;
    for (std::size_t i = 0; i < cloud.size(); ++i, to += bytes)
      std::memcpy(to, from + i * cloud.blob.point_step, bytes);
  }
  return columns;
}

void
appendCompressed(const CloudFile& cloud, std::string& text)
{
  const std::string data = lzfCompress(columnsOf(cloud));
  if (data.size() > std::numeric_limits<std::uint32_t>::max())
    throw InputError(
        cloud.path + ": " + std::to_string(data.size()) +
        " compressed bytes: allowed is less than 4 GiB (see -format binary)");
  for (const std::size_t size : {data.size(), cloud.blob.data.size()}) {
    const auto stored = static_cast<std::uint32_t>(size);
    text.append(reinterpret_cast<const char*>(&stored), sizeof(stored));
  }
  text += data;
}

} // namespace

std::string
encodeCloud(const CloudFile& cloud, PCDFormat format)
{
  if (cloud.blob.data.size() > std::numeric_limits<std::uint32_t>::max())
    throw InputError(cloud.path + ": " + std::to_string(cloud.blob.data.size()) +
                     " bytes with the new fields: allowed is less than 4 GiB");
  std::string text = encodeHeader(cloud, format);
  switch (format) {
  case PCDFormat::ascii:
    appendAscii(cloud, text);
    break;
  case PCDFormat::binary:
    text.append(cloud.blob.data.begin(), cloud.blob.data.end());
    break;
  case PCDFormat::binary_compressed:
    appendCompressed(cloud, text);
    break;
  }
  return text;
}

} // namespace pcl::app
