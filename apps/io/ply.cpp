// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PLY files: vertices with any properties in, one binary element vertex out.

#include "io/ply.h"

#include "cli/errors.h"
#include "io/pcd.h"
#include "io/text.h"

#include <array>
#include <cmath>
#include <cstring>
#include <optional>

namespace pcl::app {
namespace {

using Words = std::vector<std::string_view>;

struct PlyType {
  std::uint8_t datatype;
  const char* name; ///< that is written
  const char* alias;
};

constexpr PlyType ply_types[] = {{pcl::PCLPointField::INT8, "char", "int8"},
                                 {pcl::PCLPointField::UINT8, "uchar", "uint8"},
                                 {pcl::PCLPointField::INT16, "short", "int16"},
                                 {pcl::PCLPointField::UINT16, "ushort", "uint16"},
                                 {pcl::PCLPointField::INT32, "int", "int32"},
                                 {pcl::PCLPointField::UINT32, "uint", "uint32"},
                                 {pcl::PCLPointField::FLOAT32, "float", "float32"},
                                 {pcl::PCLPointField::FLOAT64, "double", "float64"}};

std::optional<std::uint8_t>
datatypeOf(std::string_view name)
{
  for (const PlyType& type : ply_types)
    if (name == type.name || name == type.alias)
      return type.datatype;
  return std::nullopt;
}

/** PLY's name of a type, or nullptr. */
const char*
nameOf(std::uint8_t datatype)
{
  for (const PlyType& type : ply_types)
    if (type.datatype == datatype)
      return type.name;
  return nullptr;
}

/** What the lines of a header say. */
struct Header {
  CloudFile cloud; ///< all but the points
  std::uint64_t points = 0;
  std::uint32_t columns = 0, rows = 0;
  std::size_t elements = 0;
  std::string format;
};

[[noreturn]] void
fail(const CloudFile& cloud, const std::string& what, const std::string& expected)
{
  throw InputError(cloud.path + ": " + what + "; expected " + expected);
}

/** The viewpoint, as encodePly() writes it. */
void
readViewpoint(const Words& words, CloudFile& cloud)
{
  std::array<float, 7> viewpoint{};
  if (words.size() != 2 + viewpoint.size() || words[1] != "viewpoint")
    return;
  for (std::size_t i = 0; i < viewpoint.size(); ++i) {
    const auto value = parseValue<float>(words[i + 2]);
    if (!value || !std::isfinite(*value))
      return;
    viewpoint[i] = *value;
  }
  cloud.viewpoint = viewpoint;
}

/** Only the first element is read, and it must be vertex. */
void
readElement(const Words& words, Header& header)
{
  if (++header.elements > 1)
    return;
  if (words.size() != 3 || words[1] != "vertex")
    fail(header.cloud,
         "the first element is " + inQuotes(words.size() > 1 ? words[1] : ""),
         "vertex");
  const auto points = parseValue<std::uint64_t>(words[2]);
  if (!points || *points == 0 || *points > max_points)
    fail(header.cloud,
         "element vertex is " + inQuotes(words[2]),
         "a whole number from 1 to " + std::to_string(max_points));
  header.points = *points;
}

void
readProperty(const Words& words, Header& header)
{
  if (header.elements != 1)
    return;
  const auto datatype = words.size() == 3 ? datatypeOf(words[1]) : std::nullopt;
  if (!datatype)
    fail(header.cloud,
         "property " + inQuotes(words.back()) + " of vertex has type " +
             inQuotes(words.size() > 1 ? words[1] : ""),
         "char, uchar, short, ushort, int, uint, float or double");
  if (findField(header.cloud, std::string(words[2])))
    fail(header.cloud,
         "property " + inQuotes(words[2]) + " is there twice",
         "each once");
  addField(header.cloud, std::string(words[2]), *datatype);
}

void
readLine(const Words& words, Header& header)
{
  const std::string_view keyword = words.front();
  if (keyword == "comment")
    readViewpoint(words, header.cloud);
  else if (keyword == "element")
    readElement(words, header);
  else if (keyword == "property")
    readProperty(words, header);
  else if (keyword == "format") {
    header.format = words.size() == 3 ? words[1] : "";
    if (header.format != "ascii" && header.format != "binary_little_endian")
      fail(header.cloud,
           "format " + inQuotes(words.size() > 1 ? words[1] : ""),
           "ascii 1.0 or binary_little_endian 1.0");
  }
  else if (keyword == "obj_info") {
    const auto value =
        words.size() == 3 ? parseValue<std::uint32_t>(words[2]) : std::nullopt;
    if (value && words[1] == "num_cols")
      header.columns = *value;
    else if (value && words[1] == "num_rows")
      header.rows = *value;
  }
  else
    fail(header.cloud,
         "the header has a line " + inQuotes(keyword),
         "format, comment, obj_info, element, property or end_header");
}

/** Takes the header off the file. */
Header
readHeader(const std::string& path, std::string_view& file)
{
  Header header;
  CloudFile& cloud = header.cloud;
  cloud.path = path;
  if (splitWords(takeLine(file)) != Words{"ply"})
    fail(cloud, "the first line is not 'ply'", "a PLY file");
  for (Words words; words.empty() || words.front() != "end_header";) {
    if (!words.empty())
      readLine(words, header);
    if (file.empty())
      fail(cloud, "the header has no end_header", "a complete PLY header");
    words = splitWords(takeLine(file));
  }
  if (header.format.empty() || header.elements == 0 || cloud.blob.fields.empty())
    fail(
        cloud, "the header has no format, vertex or property", "a complete PLY header");
  if (header.points * cloud.blob.point_step > max_bytes)
    fail(cloud,
         "element vertex " + std::to_string(header.points) + " of " +
             std::to_string(cloud.blob.point_step) + " bytes",
         "less than 4 GiB: divide the cloud into tiles");
  const bool is_organized =
      header.rows > 1 && std::uint64_t{header.columns} * header.rows == header.points;
  cloud.blob.width =
      is_organized ? header.columns : static_cast<std::uint32_t>(header.points);
  cloud.blob.height = is_organized ? header.rows : 1;
  cloud.blob.row_step = cloud.blob.width * cloud.blob.point_step;
  return header;
}

/** The first `count` lines that are not empty. */
std::string_view
firstLines(std::string_view body, std::size_t count)
{
  std::string_view rest = body;
  while (count > 0 && !rest.empty())
    count -= splitWords(takeLine(rest)).empty() ? 0 : 1;
  return body.substr(0, body.size() - rest.size());
}

} // namespace

CloudFile
decodePly(const std::string& path, std::string_view file)
{
  Header header = readHeader(path, file);
  if (header.format == "ascii")
    readAsciiPoints(header.cloud, firstLines(file, header.cloud.size()));
  else
    readBinaryPoints(header.cloud, file);
  return std::move(header.cloud);
}

namespace {

struct Property {
  std::string name;
  const char* type;
  std::size_t offset; ///< of its bytes in a point
  std::size_t size;
};

bool
isColor(const pcl::PCLPointField& field)
{
  return (field.name == "rgb" || field.name == "rgba") &&
         valueSize(field.datatype) == sizeof(std::uint32_t) && field.count == 1;
}

/** PCL packs a color as 0xAARRGGBB. */
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
    const char* const type = nameOf(field.datatype);
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
    if (field.name != padding_field && !nameOf(field.datatype))
      names.push_back(field.name);
  return names;
}

} // namespace pcl::app
