// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PLY files: vertices with any properties in, one binary element vertex out.

#include "io/ply.h"

#include "io/errors.h"
#include "io/text.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

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
                                 {pcl::PCLPointField::FLOAT64, "double", "float64"},
                                 {pcl::PCLPointField::BOOL, "uchar", "bool"}};

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

/** A value, or a list of them, that each instance of an element has. */
struct InProperty {
  std::string name;
  std::uint8_t datatype = 0;
  std::optional<std::uint8_t> count_type; ///< of a list
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<InProperty> properties;
};

/** What the lines of a header say. */
struct Header {
  CloudFile cloud; ///< all but the points
  std::uint32_t columns = 0, rows = 0;
  std::vector<Element> elements;
  std::string format;
  bool is_in_memory = true; ///< all of the file
};

bool
isVertex(const Element& element)
{
  return element.name == "vertex";
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

void
readElement(const Words& words, Header& header)
{
  if (words.size() != 3)
    fail(header.cloud.path,
         "element " + inQuotes(words.size() > 1 ? words[1] : "") + " has " +
             std::to_string(words.size() - 1) + " words",
         "a name and a count");
  const auto count = parseValue<std::uint64_t>(words[2]);
  const bool is_vertex = words[1] == "vertex";
  const std::uint64_t most = header.is_in_memory ? max_points : max_bytes;
  if (!count || (is_vertex && (*count == 0 || *count > most)))
    fail(header.cloud.path,
         "element " + std::string(is_vertex ? "vertex" : inQuotes(words[1])) + " is " +
             inQuotes(words[2]),
         is_vertex ? "a whole number from 1 to " + std::to_string(most)
                   : "a whole number");
  if (is_vertex &&
      std::any_of(header.elements.begin(), header.elements.end(), isVertex))
    fail(header.cloud.path, "element vertex is there twice", "one");
  header.elements.push_back({std::string(words[1]), *count, {}});
}

std::uint8_t
typeOf(const Words& words, std::size_t at, const Header& header)
{
  const auto datatype = at < words.size() ? datatypeOf(words[at]) : std::nullopt;
  if (!datatype)
    fail(header.cloud.path,
         "property " + inQuotes(words.back()) + " of " +
             inQuotes(header.elements.back().name) + " has type " +
             inQuotes(at < words.size() ? words[at] : ""),
         "char, uchar, bool, short, ushort, int, uint, float or double");
  return *datatype;
}

/** `property TYPE NAME` or `property list TYPE TYPE NAME`. */
void
readProperty(const Words& words, Header& header)
{
  const bool is_list = words.size() > 1 && words[1] == "list";
  if (header.elements.empty())
    fail(header.cloud.path,
         "a property is before any element",
         "an element line before it");
  if (words.size() != (is_list ? 5 : 3))
    fail(header.cloud.path,
         "property " + inQuotes(words.size() > 1 ? words.back() : "") + " has " +
             std::to_string(words.size() - 1) + " words",
         "a type and a name, or list, two types and a name");
  InProperty property;
  property.name = std::string(words.back());
  property.datatype = typeOf(words, is_list ? 3 : 1, header);
  if (is_list) {
    property.count_type = typeOf(words, 2, header);
    if (visitType(*property.count_type,
                  [](auto value) { return std::is_floating_point_v<decltype(value)>; }))
      fail(header.cloud.path,
           "list " + inQuotes(property.name) + " has a count of type " +
               inQuotes(words[2]),
           "a type of whole numbers");
  }
  header.elements.back().properties.push_back(property);
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
    if (header.format != "ascii" && header.format != "binary_little_endian" &&
        header.format != "binary_big_endian")
      fail(header.cloud.path,
           "format " + inQuotes(words.size() > 1 ? words[1] : ""),
           "ascii 1.0, binary_little_endian 1.0 or binary_big_endian 1.0");
  }
  else if (keyword == "obj_info") {
    const auto value =
        words.size() == 3 ? parseValue<std::uint32_t>(words[2]) : std::nullopt;
    if (value && words[1] == "num_cols")
      header.columns = *value;
    else if (value && words[1] == "num_rows")
      header.rows = *value;
  }
  else if (!header.elements.empty()) // before, it is a comment's second line, as in PCL
    fail(header.cloud.path,
         "the header has a line " + inQuotes(keyword),
         "format, comment, obj_info, element, property or end_header");
}

/** The points are an image if it has as many pixels. */
void
setLayout(Header& header)
{
  pcl::PCLPointCloud2& blob = header.cloud.blob;
  const std::uint64_t size = header.cloud.size();
  const bool is_organized =
      header.rows > 1 && std::uint64_t{header.columns} * header.rows == size;
  blob.width = is_organized ? header.columns : static_cast<std::uint32_t>(size);
  blob.height = is_organized ? header.rows : 1;
  blob.row_step = blob.width * blob.point_step;
}

/** The values of a vertex that are not lists become fields. */
void
addFields(const Element& vertex, Header& header)
{
  CloudFile& cloud = header.cloud;
  for (const InProperty& property : vertex.properties)
    if (!property.count_type)
      addField(cloud, property.name, property.datatype);
  if (cloud.blob.fields.empty())
    fail(cloud.path, "element vertex has no property but lists", "at least x y z");
  if (header.is_in_memory && vertex.count * cloud.blob.point_step > max_bytes)
    fail(cloud.path,
         "element vertex " + std::to_string(vertex.count) + " of " +
             std::to_string(cloud.blob.point_step) + " bytes",
         "less than 4 GiB: divide the cloud into tiles");
  cloud.blob.width = static_cast<std::uint32_t>(vertex.count);
  cloud.blob.height = 1;
  setLayout(header);
}

/** Takes the header off the file. */
Header
readHeader(const std::string& path, std::string_view& file, bool is_in_memory)
{
  Header header;
  header.is_in_memory = is_in_memory;
  CloudFile& cloud = header.cloud;
  cloud.path = path;
  file = withoutByteOrderMark(file);
  if (splitWords(takeLine(file)) != Words{"ply"})
    fail(cloud.path, "the first line is not 'ply'", "a PLY file");
  for (Words words; words.empty() || words.front() != "end_header";) {
    if (!words.empty())
      readLine(words, header);
    if (file.empty())
      fail(cloud.path, "the header has no end_header", "a complete PLY header");
    words = splitWords(takeLine(file));
  }
  const auto vertex =
      std::find_if(header.elements.begin(), header.elements.end(), isVertex);
  if (header.format.empty() || vertex == header.elements.end())
    fail(cloud.path, "the header has no format or vertex", "a complete PLY header");
  addFields(*vertex, header);
  return header;
}

/** Takes values off the body of a file, one after the other. */
class Body {
public:
  Body(const CloudFile& cloud, std::string_view rest) : cloud_(cloud), rest_(rest) {}
  virtual ~Body() = default;
  Body(const Body&) = delete;
  Body& operator=(const Body&) = delete;

  /** At the begin of each instance of an element, and of the number of values that it
   * has at least. */
  virtual void begin(const Element& element, std::uint64_t instance) = 0;

  /** After its last value. */
  virtual void end() = 0;

  /** The next value, in the machine's order of bytes, to \p to. */
  virtual void
  take(const InProperty& property, std::uint8_t type, std::uint8_t* to) = 0;

  /** What a value needs at least. */
  virtual std::size_t minBytes(std::uint8_t type) const = 0;

  std::size_t
  bytesLeft() const
  {
    return rest_.size();
  }

protected:
  [[noreturn]] void
  failTruncated(const Element& element, std::uint64_t instance) const
  {
    fail(cloud_.path,
         "truncated: the file ends in " + element.name + ' ' +
             std::to_string(instance) + " of " + std::to_string(element.count),
         "a complete file");
  }

  const CloudFile& cloud_;
  std::string_view rest_;
};

class BinaryBody : public Body {
public:
  BinaryBody(const CloudFile& cloud, std::string_view rest, bool is_big_endian)
  : Body(cloud, rest)
  , is_big_endian_(is_big_endian)
  {}

  void
  begin(const Element& element, std::uint64_t instance) override
  {
    element_ = &element;
    instance_ = instance;
  }

  void
  end() override
  {}

  void
  take(const InProperty& /*property*/, std::uint8_t type, std::uint8_t* to) override
  {
    const std::size_t bytes = valueSize(type);
    if (rest_.size() < bytes)
      failTruncated(*element_, instance_);
    std::memcpy(to, rest_.data(), bytes);
    if (is_big_endian_)
      std::reverse(to, to + bytes);
    rest_.remove_prefix(bytes);
  }

  std::size_t
  minBytes(std::uint8_t type) const override
  {
    return valueSize(type);
  }

private:
  bool is_big_endian_;
  const Element* element_ = nullptr;
  std::uint64_t instance_ = 0;
};

/** One line for each instance of an element. */
class TextBody : public Body {
public:
  using Body::Body;

  void
  begin(const Element& element, std::uint64_t instance) override
  {
    words_.clear();
    while (words_.empty() && !rest_.empty())
      words_ = splitPoint(takeLine(rest_));
    if (words_.empty())
      failTruncated(element, instance);
    where_ = inQuotes(element.name) + ' ' + std::to_string(instance);
    next_ = 0;
  }

  void
  end() override
  {
    if (next_ != words_.size())
      failColumns(next_);
  }

  void
  take(const InProperty& property, std::uint8_t type, std::uint8_t* to) override
  {
    if (next_ == words_.size())
      failColumns(next_ + 1);
    const std::string_view word = words_[next_++];
    visitType(type, [&](auto zero) {
      const auto value = parseFileValue<decltype(zero)>(word);
      if (!value)
        fail(cloud_.path,
             where_ + " has " + inQuotes(word) + " in property " +
                 inQuotes(property.name),
             "a number of the property's type");
      std::memcpy(to, &*value, sizeof(*value));
    });
  }

  std::size_t
  minBytes(std::uint8_t /*type*/) const override
  {
    return 1; // a digit; the blank after it may be missing once
  }

private:
  [[noreturn]] void
  failColumns(std::size_t expected) const
  {
    fail(cloud_.path,
         where_ + " has " + std::to_string(words_.size()) + " columns",
         (expected > words_.size() ? "at least " : "") + std::to_string(expected) +
             " by its properties");
  }

  Words words_;
  std::string where_;
  std::size_t next_ = 0;
};

/** The number of values in a list, which comes before them. */
std::uint64_t
takeCount(const CloudFile& cloud, const InProperty& list, Body& body)
{
  std::array<std::uint8_t, sizeof(double)> bytes{};
  body.take(list, *list.count_type, bytes.data());
  return visitType(*list.count_type, [&](auto value) {
    std::memcpy(&value, bytes.data(), sizeof(value));
    const auto count = static_cast<std::int64_t>(value); // PLY has at most 32 bits
    if (count < 0)
      fail(cloud.path,
           "list '" + list.name + "' has " + std::to_string(count) + " values",
           "0 or more");
    return static_cast<std::uint64_t>(count);
  });
}

/** Take an instance; `use` gets its values, also those of lists. */
template <typename Use>
void
takeInstance(const CloudFile& cloud, const Element& element, Body& body, const Use& use)
{
  std::array<std::uint8_t, sizeof(double)> bytes{};
  for (const InProperty& property : element.properties) {
    // Ends by itself where the file does: each value takes bytes.
    for (std::uint64_t left = property.count_type ? takeCount(cloud, property, body)
                                                  : 1;
         left > 0;
         --left) {
      body.take(property, property.datatype, bytes.data());
      use(property, bytes.data());
    }
  }
}

/** All instances of an element; what cannot be in the file is refused before.
 * \param[in] end called after each */
template <typename Use, typename End = void (*)()>
void
takeElement(
    const CloudFile& cloud,
    const Element& element,
    Body& body,
    const Use& use,
    const End& end = [] {})
{
  if (element.properties.empty())
    return; // the file has no data of it
  std::size_t least = 0;
  for (const InProperty& property : element.properties)
    least += body.minBytes(property.count_type.value_or(property.datatype));
  if (element.count > body.bytesLeft() / least)
    fail(cloud.path,
         "truncated: element " + element.name + " needs " +
             std::to_string(element.count) + " times at least " +
             std::to_string(least) + " bytes, but " + std::to_string(body.bytesLeft()) +
             " follow",
         "a complete file");
  for (std::uint64_t i = 0; i < element.count; ++i) {
    body.begin(element, i);
    takeInstance(cloud, element, body, use);
    body.end();
    end();
  }
}

void
takeVertices(CloudFile& cloud, const Element& vertex, Body& body)
{
  std::vector<std::uint8_t> data;
  takeElement(cloud, vertex, body, [&](const InProperty& property, const auto* value) {
    if (!property.count_type)
      data.insert(data.end(), value, value + valueSize(property.datatype));
  });
  cloud.blob.data = std::move(data);
}

/** What PCL and scanners write of the camera: its position, its axes, which are the
 * rows of PCL's rotation, and the size of its image. */
class Camera {
public:
  void
  set(const InProperty& property, const std::uint8_t* bytes)
  {
    static const Words names =
        splitWords("x_axisx x_axisy x_axisz y_axisx y_axisy y_axisz "
                   "z_axisx z_axisy z_axisz view_px view_py view_pz "
                   "viewportx viewporty");
    const auto place = std::find(names.begin(), names.end(), property.name);
    if (place == names.end())
      return;
    values_[place - names.begin()] = visitType(property.datatype, [&](auto value) {
      std::memcpy(&value, bytes, sizeof(value));
      return static_cast<float>(value);
    });
  }

  /** Where there is a position it is the viewpoint's, where there are axes likewise. A
   * size counts if it is that of the image. */
  void
  apply(Header& header, std::size_t pixels) const
  {
    CloudFile& cloud = header.cloud;
    constexpr float max_side = 1 << 24; // of whole numbers that float holds
    if (values_[12] > 0.0f && values_[13] > 1.0f &&
        values_.tail<2>().maxCoeff() < max_side) {
      const auto columns = static_cast<std::uint32_t>(values_[12]);
      const auto rows = static_cast<std::uint32_t>(values_[13]);
      if (std::uint64_t{columns} * rows == pixels) {
        header.columns = columns;
        header.rows = rows;
      }
    }
    if (values_.segment<3>(9).allFinite())
      std::copy(values_.data() + 9, values_.data() + 12, cloud.viewpoint.begin());
    if (!values_.head<9>().allFinite())
      return;
    const Eigen::Matrix3f axes =
        Eigen::Map<const Eigen::Matrix3f>(values_.data()).transpose();
    const Eigen::Quaternionf turn(axes);
    if (turn.coeffs().allFinite() && turn.norm() > 0.0f)
      cloud.viewpoint = {cloud.viewpoint[0],
                         cloud.viewpoint[1],
                         cloud.viewpoint[2],
                         turn.w(),
                         turn.x(),
                         turn.y(),
                         turn.z()};
  }

private:
  using Values = Eigen::Matrix<float, 14, 1>;

  Values values_ = Values::Constant(std::numeric_limits<float>::quiet_NaN()); // unset
};

/** The vertex of each pixel of an image. */
using Grid = std::vector<std::optional<std::uint64_t>>;

Grid
takeGrid(const CloudFile& cloud, const Element& element, Body& body)
{
  Grid grid;
  std::optional<std::uint64_t> vertex; // the first of a pixel's list
  const auto use = [&](const InProperty& property, const std::uint8_t* bytes) {
    if (!property.count_type)
      return;
    visitType(property.datatype, [&](auto value) {
      std::memcpy(&value, bytes, sizeof(value));
      const auto number = static_cast<double>(value);
      if (!(number >= 0.0 && number < static_cast<double>(cloud.size()) &&
            number == std::trunc(number))) {
        std::string problem = "range_grid has the vertex ";
        appendNumber(value, problem);
        fail(cloud.path,
             problem,
             "a whole number from 0 to " + std::to_string(cloud.size() - 1));
      }
      vertex = vertex.value_or(static_cast<std::uint64_t>(number));
    });
  };
  takeElement(cloud, element, body, use, [&] {
    grid.push_back(std::exchange(vertex, std::nullopt));
  });
  return grid;
}

/** As PCL fills an image: where there is no vertex, floats are NaN and others 0. It
 * leaves the vertices alone if the pixels are as many. */
void
fillImage(Header& header, const Grid& grid)
{
  pcl::PCLPointCloud2& blob = header.cloud.blob;
  const bool fits = std::uint64_t{header.columns} * header.rows == grid.size();
  if (grid.empty() || (!fits && grid.size() == header.cloud.size()))
    return;
  if (!fits || grid.size() > max_points || grid.size() * blob.point_step > max_bytes)
    fail(header.cloud.path,
         "range_grid has " + std::to_string(grid.size()) + " pixels of " +
             std::to_string(blob.point_step) + " bytes",
         "as many as num_cols times num_rows, " + std::to_string(header.columns) +
             " times " + std::to_string(header.rows) + ", and less than 4 GiB");
  std::vector<std::uint8_t> empty(blob.point_step, 0), data;
  for (const pcl::PCLPointField& field : blob.fields)
    visitType(field.datatype, [&](auto value) {
      if constexpr (std::is_floating_point_v<decltype(value)>) {
        value = std::numeric_limits<decltype(value)>::quiet_NaN();
        std::memcpy(empty.data() + field.offset, &value, sizeof(value));
      }
    });
  data.reserve(grid.size() * blob.point_step);
  for (const std::optional<std::uint64_t>& vertex : grid) {
    const std::uint8_t* const from =
        vertex ? blob.data.data() + *vertex * blob.point_step : empty.data();
    data.insert(data.end(), from, from + blob.point_step);
  }
  blob.data = std::move(data);
  blob.width = static_cast<std::uint32_t>(grid.size());
  blob.height = 1;
}

bool
isCamera(const Element& element)
{
  return element.name == "camera";
}

bool
isGrid(const Element& element)
{
  return element.name == "range_grid";
}

/** The elements up to the last one that says something of the points. */
void
takeElements(Header& header, Body& body)
{
  const auto& elements = header.elements;
  Camera camera;
  Grid grid;
  const auto last =
      std::find_if(elements.rbegin(), elements.rend(), [](const Element& element) {
        return isVertex(element) || isCamera(element) || isGrid(element);
      });
  for (auto element = elements.begin(); element != last.base(); ++element) {
    if (isVertex(*element))
      takeVertices(header.cloud, *element, body);
    else if (isGrid(*element))
      grid = takeGrid(header.cloud, *element, body);
    else {
      const bool is_camera = isCamera(*element);
      const auto use = [&](const InProperty& property, const auto* value) {
        if (is_camera)
          camera.set(property, value);
      };
      takeElement(header.cloud, *element, body, use);
    }
  }
  camera.apply(header, grid.empty() ? header.cloud.size() : grid.size());
  fillImage(header, grid);
  setLayout(header);
}

/** Whether the body begins with the points, values alone. */
bool
hasRows(const Header& header)
{
  const auto& elements = header.elements;
  const Element& first = elements.front();
  const bool is_image =
      std::any_of(elements.begin(), elements.end(), [](const Element& element) {
        return isCamera(element) || isGrid(element);
      });
  return header.format != "binary_big_endian" && isVertex(first) && !is_image &&
         std::none_of(first.properties.begin(),
                      first.properties.end(),
                      [](const InProperty& p) { return p.count_type.has_value(); });
}

struct Property {
  std::string name;
  StoredValue value;
};

bool
isColor(const pcl::PCLPointField& field)
{
  return (field.name == "rgb" || field.name == "rgba") &&
         valueSize(field.datatype) == sizeof(std::uint32_t) && field.count == 1;
}

/** The name that other programs know. */
std::string
plyNameOf(const std::string& field)
{
  constexpr std::array<const char*, 3> normals{"normal_x", "normal_y", "normal_z"};
  constexpr std::array<const char*, 3> names{"nx", "ny", "nz"};
  const auto place = std::find(normals.begin(), normals.end(), field);
  return place == normals.end()
             ? field
             : names[static_cast<std::size_t>(place - normals.begin())];
}

/** PCL packs a color as 0xAARRGGBB. */
void
addColor(const pcl::PCLPointField& field, std::vector<Property>& properties)
{
  const char* const names[] = {"red", "green", "blue", "alpha"};
  const std::size_t bytes[] = {2, 1, 0, 3};
  for (std::size_t c = 0; c < (field.name == "rgba" ? 4u : 3u); ++c)
    properties.push_back(
        {names[c], {pcl::PCLPointField::UINT8, field.offset + bytes[c]}});
}

std::vector<Property>
propertiesOf(const CloudFile& cloud)
{
  std::vector<Property> properties;
  for (const auto& field : cloud.blob.fields) {
    if (field.name == padding_field || !nameOf(field.datatype))
      continue;
    if (isColor(field))
      addColor(field, properties);
    else
      for (std::uint32_t i = 0; i < field.count; ++i)
        properties.push_back(
            {field.count == 1 ? plyNameOf(field.name)
                              : field.name + '_' + std::to_string(i),
             {field.datatype, field.offset + i * valueSize(field.datatype)}});
  }
  return properties;
}

void
appendBytes(const CloudFile& cloud,
            const std::vector<StoredValue>& values,
            std::string& text)
{
  std::size_t step = 0;
  for (const StoredValue& value : values)
    step += valueSize(value.datatype);
  text.reserve(text.size() + step * cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i)
    for (const StoredValue& value : values) {
      const std::uint8_t* const from =
          cloud.blob.data.data() + i * cloud.blob.point_step + value.offset;
      text.append(reinterpret_cast<const char*>(from), valueSize(value.datatype));
    }
}

void
appendPoints(const CloudFile& cloud, bool is_text, std::string& text)
{
  std::vector<StoredValue> values;
  for (const Property& property : propertiesOf(cloud))
    values.push_back(property.value);
  if (is_text)
    appendRows(cloud, values, text);
  else
    appendBytes(cloud, values, text);
}

} // namespace

std::optional<PointRows>
rowsOfPly(const std::string& path, std::string_view head)
{
  if (withNewLines(head, "end_header", "format"))
    return std::nullopt;
  std::string_view rest = head;
  Header header = readHeader(path, rest, false);
  if (!hasRows(header))
    return std::nullopt;
  const std::uint64_t begin = head.size() - rest.size();
  return PointRows{std::move(header.cloud), header.format == "ascii", begin};
}

CloudFile
decodePly(const std::string& path, std::string_view file)
{
  if (const auto text = withNewLines(file, "end_header", "format"))
    return decodePly(path, *text);
  Header header = readHeader(path, file, true);
  if (hasRows(header) && header.format != "ascii")
    readBinaryPoints(header.cloud, file);
  else if (header.format == "ascii") {
    TextBody body(header.cloud, file);
    takeElements(header, body);
  }
  else {
    BinaryBody body(header.cloud, file, header.format == "binary_big_endian");
    takeElements(header, body);
  }
  usePclNamesOfPly(header.cloud);
  return std::move(header.cloud);
}

std::string
encodePlyHeader(const CloudFile& cloud, bool is_text)
{
  std::string text = std::string("ply\nformat ") +
                     (is_text ? "ascii" : "binary_little_endian") +
                     " 1.0\ncomment viewpoint";
  for (const float value : cloud.viewpoint)
    appendNumber(value, text += ' ');
  if (cloud.blob.height > 1)
    text += "\nobj_info num_cols " + std::to_string(cloud.blob.width) +
            "\nobj_info num_rows " + std::to_string(cloud.blob.height);
  text += "\nelement vertex " + std::to_string(cloud.size()) + '\n';
  for (const Property& property : propertiesOf(cloud))
    text += std::string("property ") + nameOf(property.value.datatype) + ' ' +
            property.name + '\n';
  return text + "end_header\n";
}

std::string
encodePlyPoints(const CloudFile& cloud, bool is_text)
{
  std::string text;
  appendPoints(cloud, is_text, text);
  return text;
}

std::string
encodePly(const CloudFile& cloud, bool is_text)
{
  std::string text = encodePlyHeader(cloud, is_text);
  appendPoints(cloud, is_text, text);
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
