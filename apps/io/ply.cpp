// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "io/ply.h"

#include "cli/errors.h"
#include "io/pcd.h"

#include <cmath>
#include <cstring>
#include <map>
#include <optional>

namespace pcl::app {
namespace {

using Words = std::vector<std::string_view>;

std::optional<std::uint8_t>
datatypeOfProperty(std::string_view type)
{
  using Field = pcl::PCLPointField;
  static const std::map<std::string_view, std::uint8_t> types{
      {"char", Field::INT8},
      {"int8", Field::INT8},
      {"uchar", Field::UINT8},
      {"uint8", Field::UINT8},
      {"short", Field::INT16},
      {"int16", Field::INT16},
      {"ushort", Field::UINT16},
      {"uint16", Field::UINT16},
      {"int", Field::INT32},
      {"int32", Field::INT32},
      {"uint", Field::UINT32},
      {"uint32", Field::UINT32},
      {"float", Field::FLOAT32},
      {"float32", Field::FLOAT32},
      {"double", Field::FLOAT64},
      {"float64", Field::FLOAT64}};
  const auto found = types.find(type);
  return found == types.end() ? std::nullopt
                              : std::optional<std::uint8_t>(found->second);
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
      fail("the header has a line " + quoted(words[0]),
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
  fail(const std::string& what, const std::string& allowed) const
  {
    throw InputError(cloud_.path + ": " + what + ": allowed is " + allowed);
  }

  void
  readFormat(const Words& words)
  {
    if (words.size() != 3 ||
        (words[1] != "ascii" && words[1] != "binary_little_endian"))
      fail("format " + quoted(words.size() > 1 ? words[1] : ""),
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
      const auto value = parseFloating<float>(words[i + 2]);
      if (!value || !std::isfinite(*value))
        return;
      viewpoint[i] = *value;
    }
    cloud_.viewpoint = viewpoint;
  }

  void
  readInfo(const Words& words)
  {
    const auto value = words.size() == 3 ? parseInteger<std::uint32_t>(words[2])
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
    fail("the first element is " + quoted(words.size() > 1 ? words[1] : ""), "vertex");
  const auto points = parseInteger<std::uint64_t>(words[2]);
  if (!points || *points == 0 || *points > most_points)
    fail("element vertex is " + quoted(words[2]),
         "a whole number from 1 to " + std::to_string(most_points));
  points_ = *points;
}

void
Header::readProperty(const Words& words)
{
  if (elements_ != 1)
    return;
  const auto datatype =
      words.size() == 3 ? datatypeOfProperty(words[1]) : std::optional<std::uint8_t>();
  if (!datatype)
    fail("property " + quoted(words.back()) + " of vertex has type " +
             quoted(words.size() > 1 ? words[1] : ""),
         "char, uchar, short, ushort, int, uint, float or double");
  if (findField(cloud_, std::string(words[2])))
    fail("property " + quoted(words[2]) + " is there twice", "each name once");
  pcl::PCLPointField field;
  field.name = std::string(words[2]);
  field.datatype = *datatype;
  field.count = 1;
  field.offset = cloud_.blob.point_step;
  cloud_.blob.point_step += static_cast<std::uint32_t>(valueSize(*datatype));
  cloud_.blob.fields.push_back(field);
}

CloudFile
Header::finish()
{
  if (!has_format_ || elements_ == 0 || cloud_.blob.fields.empty())
    fail("the header has no format, vertex or property", "a complete PLY header");
  if (points_ * cloud_.blob.point_step > most_bytes)
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
    throw InputError(path + ": the first line is not 'ply': allowed is a PLY file");
  Header header(path);
  for (bool more = true; more;) {
    if (rest.empty())
      throw InputError(path + ": the header has no end_header: allowed is a complete "
                              "PLY header");
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
