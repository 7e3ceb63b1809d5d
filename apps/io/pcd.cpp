// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PCD files: the header, and the three kinds of data.
//
// Why not pcl::PCDReader and PCDWriter: libpcl_io loads some 60 libraries, half of them
// VTK's. `pcl_shape_detect --version` takes some 20 ms of processor time, and 50 with
// libpcl_io of PCL 1.13 in LD_PRELOAD; `pcl_shape_scene --version` 2 and 20. Some
// malformed files also make the reader crash. It is the reference of the tests instead.

#include "io/pcd.h"

#include "io/errors.h"
#include "io/files.h"
#include "io/text.h"

#include <pcl/common/io.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstring>
#include <lzf.h>
#include <map>
#include <memory>
#include <stdexcept>

namespace pcl::app {
namespace {

using Words = std::vector<std::string_view>;

/** As values of points, but no fraction is cut off. */
std::optional<std::uint64_t>
wholeNumber(std::string_view word)
{
  const auto number = parseFileValue<double>(word);
  return number && *number == std::trunc(*number) ? parseFileValue<std::uint64_t>(word)
                                                  : std::nullopt;
}

std::optional<std::uint8_t>
datatypeOf(std::string_view type, std::string_view size)
{
  const auto bytes = wholeNumber(size);
  if (!bytes || *bytes > sizeof(double) || type.size() != 1)
    return std::nullopt;
  const int datatype = pcl::getFieldType(static_cast<int>(*bytes), type.front());
  return datatype < 0 ? std::nullopt
                      : std::optional(static_cast<std::uint8_t>(datatype));
}

/** The lines of a header by their keyword. */
class HeaderLines {
public:
  HeaderLines(const std::string& path, std::string_view file);

  const Words*
  find(const std::string& keyword) const
  {
    const auto found = lines_.find(keyword);
    return found == lines_.end() ? nullptr : &found->second;
  }

  /** The words after a keyword; \p count of them, or after a single one whatever PCL
   * does not look at, such as a remark. */
  const Words& words(const std::string& keyword, std::size_t count) const;

  std::uint64_t integer(const std::string& keyword, std::uint64_t max) const;

  /** Offset of the data in the file. */
  std::size_t
  end() const
  {
    return end_;
  }

private:
  void add(std::string_view line, std::size_t number);

  const std::string& path_;
  std::map<std::string, Words> lines_;
  std::size_t end_ = 0;
};

HeaderLines::HeaderLines(const std::string& path, std::string_view file) : path_(path)
{
  if (file.empty())
    fail(path, "the file is empty", "a PCD file");
  std::string_view rest = withoutByteOrderMark(file);
  for (std::size_t number = 1; !rest.empty() && !find("DATA"); ++number)
    add(takeLine(rest), number);
  if (!find("DATA"))
    fail(path, "the header has no DATA line", "a complete PCD header");
  end_ = file.size() - rest.size();
}

void
HeaderLines::add(std::string_view line, std::size_t number)
{
  static const Words keywords =
      splitWords("VERSION FIELDS SIZE TYPE COUNT WIDTH HEIGHT VIEWPOINT POINTS DATA");
  Words words = splitWords(line);
  if (words.empty() || words.front().front() == '#')
    return;
  std::string keyword(words.front());
  std::transform(keyword.begin(), keyword.end(), keyword.begin(), [](unsigned char c) {
    return static_cast<char>(std::toupper(c));
  });
  if (keyword == "COLUMNS") // of version 0.5
    keyword = "FIELDS";
  const std::string where = "header line " + std::to_string(number) + " ";
  const bool is_keyword = std::count(keywords.begin(), keywords.end(), keyword) > 0;
  if (!is_keyword && lines_.empty())
    fail(path_,
         where + "begins with " + inQuotes(words.front()),
         "a PCD file, which begins with VERSION or FIELDS, a PLY file with the ending "
         ".ply, or KITTI's with the ending .bin or -floats; convert other formats, "
         "such as LAS, E57 or XYZ, to one of these");
  if (!is_keyword)
    fail(path_,
         where + "begins with " + inQuotes(words.front()),
         "VERSION, FIELDS, SIZE, TYPE, COUNT, WIDTH, HEIGHT, VIEWPOINT, POINTS or "
         "DATA");
  words.erase(words.begin());
  if (!lines_.emplace(keyword, std::move(words)).second)
    fail(path_, where + "repeats " + keyword, "each keyword once");
}

const Words&
HeaderLines::words(const std::string& keyword, std::size_t count) const
{
  const Words* const found = find(keyword);
  if (!found)
    fail(path_, "the header has no " + keyword + " line", "a complete PCD header");
  const bool has_remark = count == 1 && found->size() > 1 &&
                          (keyword == "DATA" || !parseValue<double>((*found)[1]));
  if (found->size() != count && !has_remark)
    fail(path_,
         keyword + " has " + std::to_string(found->size()) + " values",
         std::to_string(count));
  return *found;
}

std::uint64_t
HeaderLines::integer(const std::string& keyword, std::uint64_t max) const
{
  const std::string_view word = words(keyword, 1).front();
  const auto value = wholeNumber(word);
  if (!value || *value == 0 || *value > max)
    fail(path_,
         keyword + " is " + inQuotes(word),
         "a whole number from 1 to " + std::to_string(max));
  return *value;
}

bool
isCoordinate(std::string_view name)
{
  const std::string lower = toLower(name);
  return lower == "x" || lower == "y" || lower == "z";
}

void
readFields(const HeaderLines& lines, CloudFile& cloud)
{
  constexpr std::uint64_t max_count = 1u << 20; // values: no descriptor has more
  const Words* const names = lines.find("FIELDS");
  if (!names || names->empty())
    fail(cloud.path, "the header has no FIELDS", "at least x y z");
  const auto wordsOr = [&](const char* keyword, std::string_view usual) {
    return lines.find(keyword) ? lines.words(keyword, names->size())
                               : Words(names->size(), usual);
  };
  const Words sizes = wordsOr("SIZE", "4"); // of version 0.5, as PCL has them
  const Words types = wordsOr("TYPE", "F");
  const Words counts = wordsOr("COUNT", "1");
  std::uint64_t step = 0;
  for (std::size_t i = 0; i < names->size(); ++i) {
    const std::string_view name = (*names)[i];
    const std::string field = "field " + inQuotes(name);
    const auto datatype = datatypeOf(types[i], sizes[i]);
    if (!datatype)
      fail(cloud.path,
           field + " has SIZE " + inQuotes(sizes[i]) + " and TYPE " +
               inQuotes(types[i]),
           "SIZE 1, 2, 4 or 8 with TYPE I or U, SIZE 4 or 8 with TYPE F, SIZE 1 with "
           "TYPE B");
    const auto count = wholeNumber(counts[i]);
    if (count == 0 && !isCoordinate(name))
      continue; // as in PCL: some write padding of no bytes
    if (!count || *count == 0 || *count > max_count)
      fail(cloud.path,
           field + " has COUNT " + inQuotes(counts[i]),
           "a whole number from 1 to " + std::to_string(max_count));
    addField(cloud, std::string(name), *datatype);
    cloud.blob.fields.back().count = static_cast<std::uint32_t>(*count);
    cloud.blob.fields.back().offset = static_cast<std::uint32_t>(step);
    step += valueSize(*datatype) * *count;
    if (step > max_bytes)
      fail(cloud.path,
           "a point has more than " + std::to_string(max_bytes) + " bytes",
           "fewer fields or smaller COUNT");
  }
  if (cloud.blob.fields.empty())
    fail(cloud.path, "every COUNT is 0", "at least x y z with 1");
  cloud.blob.point_step = static_cast<std::uint32_t>(step);
}

void
readSize(const HeaderLines& lines, CloudFile& cloud, bool is_in_memory)
{
  // The oldest files have POINTS alone, others leave POINTS out.
  const bool has_points = lines.find("POINTS");
  const bool has_width = lines.find("WIDTH") || lines.find("HEIGHT") || !has_points;
  const std::uint64_t most = is_in_memory ? max_points : max_bytes; // of 32 bits
  const std::uint64_t width = lines.integer(has_width ? "WIDTH" : "POINTS", most);
  const std::uint64_t height = lines.find("HEIGHT") ? lines.integer("HEIGHT", most) : 1;
  const std::uint64_t points =
      has_points ? lines.integer("POINTS", most) : width * height;
  if (width * height != points)
    fail(cloud.path,
         "WIDTH " + std::to_string(width) + " times HEIGHT " + std::to_string(height) +
             " is not POINTS " + std::to_string(points),
         "POINTS = WIDTH x HEIGHT");
  if (is_in_memory &&
      (points > max_points || points * cloud.blob.point_step > max_bytes))
    fail(cloud.path,
         "POINTS " + std::to_string(points) + " of " +
             std::to_string(cloud.blob.point_step) + " bytes",
         "less than 4 GiB: divide the cloud into tiles");
  cloud.blob.width = static_cast<std::uint32_t>(width);
  cloud.blob.height = static_cast<std::uint32_t>(height);
  cloud.blob.row_step = cloud.blob.width * cloud.blob.point_step;
}

void
readViewpoint(const HeaderLines& lines, CloudFile& cloud)
{
  if (!lines.find("VIEWPOINT"))
    return;
  const Words& words = lines.words("VIEWPOINT", cloud.viewpoint.size());
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto value = parseValue<float>(words[i]);
    if (!value || !std::isfinite(*value))
      fail(cloud.path,
           "VIEWPOINT has the value " + inQuotes(words[i]),
           "a finite number");
    cloud.viewpoint[i] = *value;
  }
}

void
requireVersion(const HeaderLines& lines, const std::string& path)
{
  constexpr std::array<std::string_view, 6> versions{
      "0.7", ".7", "0.6", ".6", "0.5", ".5"};
  if (!lines.find("VERSION"))
    return;
  const std::string_view version = lines.words("VERSION", 1).front();
  if (std::count(versions.begin(), versions.end(), version) == 0)
    fail(path, "VERSION is " + inQuotes(version), "0.5, 0.6 or 0.7");
}

[[noreturn]] void
failTruncated(const CloudFile& cloud, std::uint64_t expected, std::size_t found)
{
  fail(cloud.path,
       "truncated: the header promises " + std::to_string(cloud.size()) +
           " points, in at least " + std::to_string(expected) + " bytes of data, but " +
           std::to_string(found) + " follow",
       "a complete file");
}

void
readRow(CloudFile& cloud, const Words& words, std::size_t row)
{
  std::uint8_t* to = cloud.blob.data.data() + row * cloud.blob.point_step;
  std::size_t word = 0;
  for (const auto& field : cloud.blob.fields) {
    if (field.name == padding_field) {
      word += field.count; // means nothing, whatever it says
      to += valueSize(field.datatype) * field.count;
      continue;
    }
    for (std::uint32_t i = 0; i < field.count; ++i, ++word)
      visitType(field.datatype, [&](auto zero) {
        const auto value = parseFileValue<decltype(zero)>(words[word]);
        if (!value)
          fail(cloud.path,
               "point " + std::to_string(row) + " has " + inQuotes(words[word]) +
                   " in field '" + field.name + "'",
               "a number of the field's TYPE and SIZE");
        std::memcpy(to, &*value, sizeof(*value));
        to += sizeof(*value);
      });
  }
}

/** The columns of a compressed body, one field after the other, to points. */
void
interleave(CloudFile& cloud, const std::vector<std::uint8_t>& columns)
{
  std::vector<FieldSource> sources;
  const std::uint8_t* from = columns.data();
  for (const auto& field : cloud.blob.fields) {
    const std::size_t bytes = valueSize(field.datatype) * field.count;
    sources.push_back({field, from, bytes});
    from += bytes * cloud.size();
  }
  setFields(cloud, sources);
}

bool
isPadding(const pcl::PCLPointField& field)
{
  return field.name == padding_field;
}

/** Leave out the columns that mean nothing. PCL leaves them out of compressed data
 * without saying so in the header, so no file with them is read by all alike. */
void
dropPadding(CloudFile& cloud)
{
  std::vector<FieldSource> sources = sourcesOf(cloud);
  sources.erase(std::remove_if(sources.begin(),
                               sources.end(),
                               [](const FieldSource& s) { return isPadding(s.field); }),
                sources.end());
  if (sources.empty())
    fail(cloud.path, "FIELDS has only padding, '_'", "at least x y z");
  if (sources.size() < cloud.blob.fields.size())
    setFields(cloud, sources);
}

/** The description of the points without padding: what PCL means by a compressed file
 * that has it. */
void
forgetPadding(CloudFile& cloud)
{
  auto& fields = cloud.blob.fields;
  fields.erase(std::remove_if(fields.begin(), fields.end(), isPadding), fields.end());
  std::uint32_t step = 0;
  for (auto& field : fields) {
    field.offset = step;
    step += static_cast<std::uint32_t>(valueSize(field.datatype)) * field.count;
  }
  cloud.blob.point_step = step;
}

void
readCompressed(CloudFile& cloud, std::string_view body)
{
  std::array<std::uint32_t, 2> sizes{}; // compressed and not
  if (body.size() < sizeof(sizes))
    failTruncated(cloud, sizeof(sizes), body.size());
  std::memcpy(sizes.data(), body.data(), sizeof(sizes));
  body.remove_prefix(sizeof(sizes));
  CloudFile bare = cloud;
  forgetPadding(bare);
  if (sizes[1] != 0 && sizes[1] == bare.size() * bare.blob.point_step)
    cloud = std::move(bare);
  const std::size_t expected = cloud.size() * cloud.blob.point_step;
  if (sizes[1] != expected)
    fail(cloud.path,
         "the compressed data says that it holds " + std::to_string(sizes[1]) +
             " bytes",
         std::to_string(expected) + " by the header");
  if (sizes[0] > body.size())
    failTruncated(cloud, sizes[0], body.size());
  // No memory is taken for what cannot be there: three bytes give 264 at most.
  constexpr std::uint64_t max_expansion = 264 / 3;
  std::vector<std::uint8_t> columns;
  if (sizes[0] * max_expansion >= expected)
    columns.resize(expected);
  if (columns.empty() ||
      lzf_decompress(body.data(), sizes[0], columns.data(), sizes[1]) != expected)
    fail(cloud.path,
         "the compressed data, " + std::to_string(sizes[0]) + " bytes, is corrupt",
         "LZF data of " + std::to_string(expected) + " bytes");
  interleave(cloud, columns);
}

/** All but the points. */
CloudFile
describedBy(const HeaderLines& lines, const std::string& path, bool is_in_memory)
{
  CloudFile cloud;
  cloud.path = path;
  requireVersion(lines, path);
  readFields(lines, cloud);
  readSize(lines, cloud, is_in_memory);
  readViewpoint(lines, cloud);
  return cloud;
}

PCDFormat
formatBy(const HeaderLines& lines, const std::string& path)
{
  const std::string_view word = lines.words("DATA", 1).front();
  // As in PCL, text may begin without a new line; what is on this one is lost.
  constexpr std::size_t letters = 5;
  const bool has_number =
      word.substr(0, letters + 1).find_first_of("+-.0123456789") == letters;
  const auto format = formatOf(has_number ? word.substr(0, letters) : word);
  if (!format)
    fail(path, "DATA is " + inQuotes(word), "ascii, binary or binary_compressed");
  return *format;
}

/** Colors are bits: as a float, many are NaN, and text would lose them. */
std::uint8_t
writtenType(const pcl::PCLPointField& field, PCDFormat format)
{
  const bool is_color = (field.name == "rgb" || field.name == "rgba") &&
                        field.datatype == pcl::PCLPointField::FLOAT32;
  return format == PCDFormat::ascii && is_color
             ? std::uint8_t{pcl::PCLPointField::UINT32}
             : field.datatype;
}

std::vector<StoredValue>
valuesInText(const CloudFile& cloud)
{
  std::vector<StoredValue> values;
  for (const auto& field : cloud.blob.fields)
    for (std::uint32_t i = 0; i < field.count; ++i)
      values.push_back({writtenType(field, PCDFormat::ascii),
                        field.offset + i * valueSize(field.datatype)});
  return values;
}

/** Memory that is not set to 0 first. */
template <typename T>
std::unique_ptr<T[]>
rawArray(std::size_t size)
{
  return std::unique_ptr<T[]>(new T[size]);
}

/** The points as columns, one field after the other. */
std::unique_ptr<std::uint8_t[]>
columnsOf(const CloudFile& cloud)
{
  auto columns = rawArray<std::uint8_t>(cloud.blob.data.size());
  std::uint8_t* to = columns.get();
  for (const auto& field : cloud.blob.fields) {
    const std::size_t bytes = valueSize(field.datatype) * field.count;
    for (std::size_t i = 0; i < cloud.size(); ++i, to += bytes)
      if (bytes == sizeof(float)) // no call for so little
        std::memcpy(to, cloud.at(i, field), sizeof(float));
      else
        std::memcpy(to, cloud.at(i, field), bytes);
  }
  if (to != columns.get() + cloud.blob.data.size())
    throw std::logic_error("the points of a cloud have bytes of no field");
  return columns;
}

void
appendCompressed(const CloudFile& cloud, std::string& text)
{
  const std::size_t size = cloud.blob.data.size();
  // What has no repetition grows by a byte for every 32; the rest is LibLZF's reserve.
  const auto most = static_cast<std::uint32_t>(
      std::min<std::uint64_t>(size + size / 32 + 16, max_bytes));
  std::array<std::uint32_t, 2> sizes{0, static_cast<std::uint32_t>(size)};
  const auto compressed = rawArray<char>(most);
  sizes[0] = lzf_compress(columnsOf(cloud).get(), sizes[1], compressed.get(), most);
  if (sizes[0] == 0)
    throw InputError(cloud.path + ": the points have 4 GiB when compressed; must be "
                                  "less (see -format binary)");
  text.append(reinterpret_cast<const char*>(sizes.data()), sizeof(sizes));
  text.append(compressed.get(), sizes[0]);
}

void
appendPoints(const CloudFile& cloud, PCDFormat format, std::string& text)
{
  if (format == PCDFormat::ascii)
    appendRows(cloud, valuesInText(cloud), text);
  else if (format == PCDFormat::binary)
    text.append(cloud.blob.data.begin(), cloud.blob.data.end());
  else
    appendCompressed(cloud, text);
}

} // namespace

const char*
nameOf(PCDFormat format)
{
  switch (format) {
  case PCDFormat::ascii:
    return "ascii";
  case PCDFormat::binary:
    return "binary";
  default:
    return "binary_compressed";
  }
}

std::optional<PCDFormat>
formatOf(std::string_view name)
{
  for (const PCDFormat format :
       {PCDFormat::ascii, PCDFormat::binary, PCDFormat::binary_compressed})
    if (toLower(name) == nameOf(format))
      return format;
  return std::nullopt;
}

void
readAsciiPoints(CloudFile& cloud, std::string_view body)
{
  std::size_t columns = 0;
  for (const auto& field : cloud.blob.fields)
    columns += field.count;
  const std::uint64_t min_bytes = std::uint64_t{cloud.size()} * columns * 2 - 1;
  if (body.size() < min_bytes)
    failTruncated(cloud, min_bytes, body.size());
  cloud.blob.data.resize(cloud.size() * cloud.blob.point_step);
  std::size_t row = 0;
  while (!body.empty()) {
    const Words words = splitPoint(takeLine(body));
    if (words.empty())
      continue;
    if (row == cloud.size())
      fail(cloud.path, "more rows than POINTS", std::to_string(row) + " rows");
    if (words.size() != columns)
      fail(cloud.path,
           "point " + std::to_string(row) + " has " + std::to_string(words.size()) +
               " columns",
           std::to_string(columns) + " by FIELDS and COUNT, with blanks between them");
    readRow(cloud, words, row++);
  }
  if (row < cloud.size())
    fail(cloud.path,
         "truncated: " + std::to_string(row) + " rows",
         std::to_string(cloud.size()) + " by POINTS");
}

void
readBinaryPoints(CloudFile& cloud, std::string_view body)
{
  const std::size_t expected = cloud.size() * cloud.blob.point_step;
  if (body.size() < expected)
    failTruncated(cloud, expected, body.size());
  cloud.blob.data.assign(body.begin(),
                         body.begin() + static_cast<std::ptrdiff_t>(expected));
}

std::optional<PointRows>
rowsOfPcd(const std::string& path, std::string_view head)
{
  if (withNewLines(head, "data", "data"))
    return std::nullopt;
  const HeaderLines lines(path, head);
  const PCDFormat format = formatBy(lines, path);
  if (format == PCDFormat::binary_compressed)
    return std::nullopt;
  return PointRows{
      describedBy(lines, path, false), format == PCDFormat::ascii, lines.end()};
}

void
finishPcd(CloudFile& cloud)
{
  dropPadding(cloud);
  usePclNames(cloud);
}

CloudFile
decodePcd(const std::string& path, std::string_view file)
{
  if (const auto text = withNewLines(file, "data", "data"))
    return decodePcd(path, *text);
  const HeaderLines lines(path, file);
  CloudFile cloud = describedBy(lines, path, true);
  const PCDFormat format = formatBy(lines, path);
  const std::string_view body = file.substr(lines.end());
  if (format == PCDFormat::ascii)
    readAsciiPoints(cloud, body);
  else if (format == PCDFormat::binary)
    readBinaryPoints(cloud, body);
  else
    readCompressed(cloud, body);
  finishPcd(cloud);
  return cloud;
}

CloudFile
readCloud(const std::string& path)
{
  return decodePcd(path, readFile(path, "a PCD file"));
}

std::string
encodePcdHeader(const CloudFile& cloud, PCDFormat format)
{
  std::string names = "FIELDS";
  std::string sizes = "SIZE";
  std::string types = "TYPE";
  std::string counts = "COUNT";
  for (const auto& field : cloud.blob.fields) {
    names += ' ' + field.name;
    sizes += ' ' + std::to_string(valueSize(field.datatype));
    types += std::string(" ") + pcl::getFieldType(writtenType(field, format));
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

std::string
encodePcdPoints(const CloudFile& cloud, PCDFormat format)
{
  std::string text;
  appendPoints(cloud, format, text);
  return text;
}

std::string
encodeCloud(const CloudFile& cloud, PCDFormat format)
{
  if (cloud.blob.data.size() > max_bytes)
    throw InputError(cloud.path + ": " + std::to_string(cloud.blob.data.size()) +
                     " bytes with the new fields; must be less than 4 GiB");
  std::string text = encodePcdHeader(cloud, format);
  appendPoints(cloud, format, text);
  return text;
}

} // namespace pcl::app
