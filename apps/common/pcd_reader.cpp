/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "pcd_reader.h"

#include "errors.h"
#include "lzf.h"
#include "pcd_header.h"
#include "pcd_values.h"
#include "read_file.h"

#include <cstring>

namespace pcl::app {
namespace {

std::string
badFile(const std::string& path, const std::string& what, const std::string& allowed)
{
  return path + ": " + what + ": allowed is " + allowed;
}

std::string
truncated(const CloudFile& cloud, std::uint64_t expected, std::size_t found)
{
  return badFile(cloud.path,
                 "truncated: the header promises " + std::to_string(cloud.size()) +
                     " points, in at least " + std::to_string(expected) +
                     " bytes of data, but " + std::to_string(found) + " follow",
                 "a complete file");
}

bool
storeValue(std::uint8_t datatype, std::string_view word, std::uint8_t* to)
{
  const auto store = [to](const auto& value) {
    if (value)
      std::memcpy(to, &*value, sizeof(*value));
    return value.has_value();
  };
  switch (datatype) {
  case pcl::PCLPointField::INT8:
    return store(parseInteger<std::int8_t>(word));
  case pcl::PCLPointField::UINT8:
    return store(parseInteger<std::uint8_t>(word));
  case pcl::PCLPointField::INT16:
    return store(parseInteger<std::int16_t>(word));
  case pcl::PCLPointField::UINT16:
    return store(parseInteger<std::uint16_t>(word));
  case pcl::PCLPointField::INT32:
    return store(parseInteger<std::int32_t>(word));
  case pcl::PCLPointField::UINT32:
    return store(parseInteger<std::uint32_t>(word));
  case pcl::PCLPointField::INT64:
    return store(parseInteger<std::int64_t>(word));
  case pcl::PCLPointField::UINT64:
    return store(parseInteger<std::uint64_t>(word));
  case pcl::PCLPointField::FLOAT32:
    return store(parseFloating<float>(word));
  default:
    return store(parseFloating<double>(word));
  }
}

void
readRow(const CloudFile& cloud,
        const std::vector<std::string_view>& words,
        std::size_t row,
        std::uint8_t* to)
{
  std::size_t word = 0;
  for (const auto& field : cloud.blob.fields)
    for (std::uint32_t i = 0; i < field.count; ++i, ++word) {
      if (!storeValue(field.datatype, words[word], to))
        throw InputError(badFile(cloud.path,
                                 "point " + std::to_string(row) + " has " +
                                     quoted(words[word]) + " in field '" + field.name +
                                     "'",
                                 "a number of the field's TYPE and SIZE"));
      to += valueSize(field.datatype);
    }
}

/** The columns of a compressed body, one field after the other, to points. */
void
interleave(CloudFile& cloud, const std::vector<std::uint8_t>& columns)
{
  cloud.blob.data.resize(columns.size());
  const std::uint8_t* from = columns.data();
  for (const auto& field : cloud.blob.fields) {
    const std::size_t bytes = valueSize(field.datatype) * field.count;
    std::uint8_t* to = cloud.blob.data.data() + field.offset;
    for (std::size_t i = 0; i < cloud.size(); ++i, from += bytes)
      std::memcpy(to + i * cloud.blob.point_step, from, bytes);
  }
}

void
readCompressed(CloudFile& cloud, std::string_view body)
{
  constexpr std::size_t sizes = 2 * sizeof(std::uint32_t);
  const std::size_t expected = cloud.size() * cloud.blob.point_step;
  if (body.size() < sizes)
    throw InputError(truncated(cloud, sizes, body.size()));
  std::uint32_t compressed = 0;
  std::uint32_t uncompressed = 0;
  std::memcpy(&compressed, body.data(), sizeof(compressed));
  std::memcpy(&uncompressed, body.data() + sizeof(compressed), sizeof(uncompressed));
  body.remove_prefix(sizes);
  if (uncompressed != expected)
    throw InputError(badFile(cloud.path,
                             "the compressed data says that it holds " +
                                 std::to_string(uncompressed) + " bytes",
                             std::to_string(expected) + " by the header"));
  if (compressed > body.size())
    throw InputError(truncated(cloud, compressed, body.size()));
  std::vector<std::uint8_t> columns;
  if (lzfMostBytes(compressed) < expected ||
      !lzfDecompress(reinterpret_cast<const std::uint8_t*>(body.data()),
                     compressed,
                     expected,
                     columns))
    throw InputError(badFile(cloud.path,
                             "the compressed data, " + std::to_string(compressed) +
                                 " bytes, is corrupt",
                             "LZF data of " + std::to_string(expected) + " bytes"));
  interleave(cloud, columns);
}

} // namespace

void
readAsciiPoints(CloudFile& cloud, std::string_view body)
{
  std::size_t columns = 0;
  for (const auto& field : cloud.blob.fields)
    columns += field.count;
  const std::uint64_t least = std::uint64_t{cloud.size()} * columns * 2 - 1;
  if (body.size() < least)
    throw InputError(truncated(cloud, least, body.size()));
  cloud.blob.data.resize(cloud.size() * cloud.blob.point_step);
  std::size_t row = 0;
  while (!body.empty()) {
    const std::vector<std::string_view> words = splitWords(takeLine(body));
    if (words.empty())
      continue;
    if (row == cloud.size())
      throw InputError(badFile(
          cloud.path, "more rows than POINTS", std::to_string(cloud.size()) + " rows"));
    if (words.size() != columns)
      throw InputError(badFile(cloud.path,
                               "point " + std::to_string(row) + " has " +
                                   std::to_string(words.size()) + " columns",
                               std::to_string(columns) + " by FIELDS and COUNT"));
    readRow(cloud, words, row, cloud.blob.data.data() + row * cloud.blob.point_step);
    ++row;
  }
  if (row < cloud.size())
    throw InputError(badFile(cloud.path,
                             "truncated: " + std::to_string(row) + " rows",
                             std::to_string(cloud.size()) + " by POINTS"));
}

void
readBinaryPoints(CloudFile& cloud, std::string_view body)
{
  const std::size_t expected = cloud.size() * cloud.blob.point_step;
  if (body.size() < expected)
    throw InputError(truncated(cloud, expected, body.size()));
  cloud.blob.data.assign(body.begin(),
                         body.begin() + static_cast<std::ptrdiff_t>(expected));
}

CloudFile
decodePcd(const std::string& path, std::string_view file)
{
  PCDHeader header = parseHeader(path, file);
  const std::string_view body = file.substr(header.body);
  switch (header.format) {
  case PCDFormat::ascii:
    readAsciiPoints(header.cloud, body);
    break;
  case PCDFormat::binary:
    readBinaryPoints(header.cloud, body);
    break;
  case PCDFormat::binary_compressed:
    readCompressed(header.cloud, body);
    break;
  }
  return std::move(header.cloud);
}

CloudFile
readCloud(const std::string& path)
{
  return decodePcd(path, readFile(path, "a PCD file"));
}

} // namespace pcl::app
