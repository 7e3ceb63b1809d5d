// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PLY files: vertices with any properties in, one binary element vertex out.

#include "io/ply.h"

#include "cli/errors.h"
#include "io/pcd.h"
#include "io/text.h"

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

/** Reads a header line by line. */
class Header {
public:
  explicit Header(const std::string& path) { cloud_.path = path; }

  /** \return false after the last line */
  bool
  add(const Words& words)
  {
    if (words.empty() || words[0] == "comment")
      readComment(words);
    else if (words[0] == "format")
      readFormat(words);
    else if (words[0] == "obj_info")
      readInfo(words);
    else if (words[0] == "element")
      readElement(words);
    else if (words[0] == "property")
      readProperty(words);
    else if (words[0] != "end_header")
      fail("the header has a line " + inQuotes(words[0]),
           "format, comment, obj_info, element, property or end_header");
    return words.empty() || words[0] != "end_header";
  }

  /** What was read: all but the points. */
  CloudFile finish();

  bool
  isText() const
  {
    return is_text_;
  }

private:
  [[noreturn]] void
  fail(const std::string& what, const std::string& expected) const
  {
    throw InputError(cloud_.path + ": " + what + "; expected " + expected);
  }

  void
  readFormat(const Words& words)
  {
    if (words.size() != 3 ||
        (words[1] != "ascii" && words[1] != "binary_little_endian"))
      fail("format " + inQuotes(words.size() > 1 ? words[1] : ""),
           "ascii 1.0 or binary_little_endian 1.0");
    has_format_ = true;
    is_text_ = words[1] == "ascii";
  }

  /** The viewpoint, as encodePly() writes it. */
  void
  readComment(const Words& words)
  {
    if (words.size() != 2 + cloud_.viewpoint.size() || words[1] != "viewpoint")
      return;
    std::array<float, 7> viewpoint{};
    for (std::size_t i = 0; i < viewpoint.size(); ++i) {
      const auto value = parseValue<float>(words[i + 2]);
      if (!value || !std::isfinite(*value))
        return;
      viewpoint[i] = *value;
    }
    cloud_.viewpoint = viewpoint;
  }

  void
  readInfo(const Words& words)
  {
    const auto value = words.size() == 3 ? parseValue<std::uint32_t>(words[2])
                                         : std::optional<std::uint32_t>();
    if (value && words[1] == "num_cols")
      columns_ = *value;
    else if (value && words[1] == "num_rows")
      rows_ = *value;
  }

  void readElement(const Words& words);

  void readProperty(const Words& words);

  CloudFile cloud_;
  std::uint64_t points_ = 0;
  std::uint32_t columns_ = 0, rows_ = 0;
  std::size_t elements_ = 0;
  bool has_format_ = false, is_text_ = false;
};

void
Header::readElement(const Words& words)
{
  ++elements_;
  if (elements_ > 1)
    return;
  if (words.size() != 3 || words[1] != "vertex")
    fail("the first element is " + inQuotes(words.size() > 1 ? words[1] : ""),
         "vertex");
  const auto points = parseValue<std::uint64_t>(words[2]);
  if (!points || *points == 0 || *points > max_points)
    fail("element vertex is " + inQuotes(words[2]),
         "a whole number from 1 to " + std::to_string(max_points));
  points_ = *points;
}

void
Header::readProperty(const Words& words)
{
  if (elements_ != 1)
    return;
  const auto datatype =
      words.size() == 3 ? datatypeOf(words[1]) : std::optional<std::uint8_t>();
  if (!datatype)
    fail("property " + inQuotes(words.back()) + " of vertex has type " +
             inQuotes(words.size() > 1 ? words[1] : ""),
         "char, uchar, short, ushort, int, uint, float or double");
  if (findField(cloud_, std::string(words[2])))
    fail("property " + inQuotes(words[2]) + " is there twice", "each name once");
  addField(cloud_, std::string(words[2]), *datatype);
}

CloudFile
Header::finish()
{
  if (!has_format_ || elements_ == 0 || cloud_.blob.fields.empty())
    fail("the header has no format, vertex or property", "a complete PLY header");
  if (points_ * cloud_.blob.point_step > max_bytes)
    fail("element vertex " + std::to_string(points_) + " of " +
             std::to_string(cloud_.blob.point_step) + " bytes",
         "less than 4 GiB: divide the cloud into tiles");
  const bool is_organized = rows_ > 1 && std::uint64_t{columns_} * rows_ == points_;
  cloud_.blob.width = is_organized ? columns_ : static_cast<std::uint32_t>(points_);
  cloud_.blob.height = is_organized ? rows_ : 1;
  cloud_.blob.row_step = cloud_.blob.width * cloud_.blob.point_step;
  return std::move(cloud_);
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
  std::string_view rest = file;
  if (splitWords(takeLine(rest)) != Words{"ply"})
    throw InputError(path + ": the first line is not 'ply'; expected a PLY file");
  Header header(path);
  for (bool more = true; more;) {
    if (rest.empty())
      throw InputError(path + ": the header has no end_header; expected a complete PLY "
                              "header");
    more = header.add(splitWords(takeLine(rest)));
  }
  const bool is_text = header.isText();
  CloudFile cloud = header.finish();
  if (is_text)
    readAsciiPoints(cloud, firstLines(rest, cloud.size()));
  else
    readBinaryPoints(cloud, rest);
  return cloud;
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
