// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "io/pcd.h"

#include "cli/errors.h"
#include "cli/read_file.h"

#include <pcl/PCLPointField.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace pcl::app {
namespace {

constexpr std::size_t most_literals = 32;
constexpr std::size_t least_match = 3;
constexpr std::size_t most_match = 264;
constexpr std::size_t most_distance = 8192;
constexpr unsigned length_shift = 5;
constexpr unsigned long_length = 7;
constexpr unsigned hash_bits = 16;

/** Where each three bytes were seen last, plus one. */
using Seen = std::vector<std::size_t>;

std::size_t
hashOf(const std::uint8_t* bytes)
{
  const std::uint32_t three =
      bytes[0] | std::uint32_t{bytes[1]} << 8 | std::uint32_t{bytes[2]} << 16;
  constexpr std::uint32_t golden_ratio = 2654435769u;
  return (three * golden_ratio) >> (32 - hash_bits);
}

std::size_t
matchLength(const std::vector<std::uint8_t>& input, std::size_t from, std::size_t at)
{
  const std::size_t most = std::min(most_match, input.size() - at);
  std::size_t length = 0;
  while (length < most && input[from + length] == input[at + length])
    ++length;
  return length;
}

void
writeLiterals(const std::vector<std::uint8_t>& input,
              std::size_t begin,
              std::size_t end,
              std::string& output)
{
  while (begin < end) {
    const std::size_t count = std::min(end - begin, most_literals);
    output.push_back(static_cast<char>(count - 1));
    output.append(reinterpret_cast<const char*>(input.data() + begin), count);
    begin += count;
  }
}

void
writeMatch(std::size_t length, std::size_t distance, std::string& output)
{
  const std::size_t code = length - 2;
  const std::size_t offset = distance - 1;
  const std::size_t top = std::min<std::size_t>(code, long_length);
  output.push_back(static_cast<char>(top << length_shift | offset >> 8));
  if (code >= long_length)
    output.push_back(static_cast<char>(code - long_length));
  output.push_back(static_cast<char>(offset & 0xff));
}

} // namespace

std::string
lzfCompress(const std::vector<std::uint8_t>& input)
{
  std::string output;
  output.reserve(input.size() / 2);
  Seen seen(std::size_t{1} << hash_bits, 0);
  std::size_t literals = 0;
  std::size_t at = 0;
  while (at + least_match <= input.size()) {
    std::size_t& last = seen[hashOf(input.data() + at)];
    const std::size_t from = last == 0 ? at : last - 1;
    last = at + 1;
    const std::size_t distance = at - from;
    const bool near = distance > 0 && distance <= most_distance;
    const std::size_t length = near ? matchLength(input, from, at) : 0;
    if (length < least_match) {
      ++at;
      continue;
    }
    writeLiterals(input, literals, at, output);
    writeMatch(length, distance, output);
    at += length;
    literals = at;
  }
  writeLiterals(input, literals, input.size(), output);
  return output;
}

bool
lzfDecompress(const std::uint8_t* input,
              std::size_t input_size,
              std::size_t size,
              std::vector<std::uint8_t>& output)
{
  output.clear();
  output.reserve(size);
  const std::uint8_t* const end = input + input_size;
  while (input < end) {
    const unsigned control = *input++;
    if (control < most_literals) {
      const std::size_t count = control + 1;
      if (count > static_cast<std::size_t>(end - input) || count > size - output.size())
        return false;
      output.insert(output.end(), input, input + count);
      input += count;
      continue;
    }
    const unsigned code = control >> length_shift;
    const std::size_t bytes_left = static_cast<std::size_t>(end - input);
    if (bytes_left < (code == long_length ? 2u : 1u))
      return false;
    const std::size_t length = 2 + code + (code == long_length ? *input++ : 0u);
    const std::size_t distance = 1 + ((control & 0x1fu) << 8 | *input++);
    if (distance > output.size() || length > size - output.size())
      return false;
    for (std::size_t i = 0; i < length; ++i)
      output.push_back(output[output.size() - distance]);
  }
  return output.size() == size;
}

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
    if (name == nameOf(format))
      return format;
  return std::nullopt;
}

char
typeLetter(std::uint8_t datatype)
{
  switch (datatype) {
  case pcl::PCLPointField::FLOAT32:
  case pcl::PCLPointField::FLOAT64:
    return 'F';
  case pcl::PCLPointField::UINT8:
  case pcl::PCLPointField::UINT16:
  case pcl::PCLPointField::UINT32:
  case pcl::PCLPointField::UINT64:
    return 'U';
  default:
    return 'I';
  }
}

std::optional<std::uint8_t>
datatypeOf(std::string_view type, std::string_view size)
{
  static const std::map<std::pair<std::string_view, std::string_view>, std::uint8_t>
      types{{{"I", "1"}, pcl::PCLPointField::INT8},
            {{"I", "2"}, pcl::PCLPointField::INT16},
            {{"I", "4"}, pcl::PCLPointField::INT32},
            {{"I", "8"}, pcl::PCLPointField::INT64},
            {{"U", "1"}, pcl::PCLPointField::UINT8},
            {{"U", "2"}, pcl::PCLPointField::UINT16},
            {{"U", "4"}, pcl::PCLPointField::UINT32},
            {{"U", "8"}, pcl::PCLPointField::UINT64},
            {{"F", "4"}, pcl::PCLPointField::FLOAT32},
            {{"F", "8"}, pcl::PCLPointField::FLOAT64}};
  const auto found = types.find({type, size});
  if (found == types.end())
    return std::nullopt;
  return found->second;
}

std::string
quoted(std::string_view word)
{
  constexpr std::size_t longest = 40;
  std::string text(word.substr(0, longest));
  std::replace_if(
      text.begin(),
      text.end(),
      [](unsigned char c) { return c < ' ' || c > '~'; },
      '?');
  return '\'' + text + (word.size() > longest ? "...'" : "'");
}

std::vector<std::string_view>
splitWords(std::string_view line)
{
  constexpr std::string_view blanks = " \t\r";
  std::vector<std::string_view> words;
  std::size_t begin = line.find_first_not_of(blanks);
  while (begin != std::string_view::npos) {
    const std::size_t end = std::min(line.find_first_of(blanks, begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(blanks, end);
  }
  return words;
}

std::string_view
takeLine(std::string_view& text)
{
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

namespace {

using Words = std::vector<std::string_view>;

constexpr std::uint64_t most_count = 1u << 20;

/** The lines of a header by their keyword. */
class HeaderLines {
public:
  HeaderLines(const std::string& path, std::string_view file);

  std::string
  problem(const std::string& what, const std::string& allowed) const
  {
    return path_ + ": " + what + ": allowed is " + allowed;
  }

  const Words*
  find(const std::string& keyword) const
  {
    const auto found = lines_.find(keyword);
    return found == lines_.end() ? nullptr : &found->second;
  }

  /** \brief The words after a keyword; \p count of them. */
  const Words& words(const std::string& keyword, std::size_t count) const;

  std::uint64_t integer(const std::string& keyword, std::uint64_t most) const;

  std::size_t
  end() const
  {
    return end_;
  }

private:
  void add(std::string_view line, std::size_t number);

  std::string path_;
  std::map<std::string, Words, std::less<>> lines_;
  std::size_t end_ = 0;
};

HeaderLines::HeaderLines(const std::string& path, std::string_view file) : path_(path)
{
  if (file.empty())
    throw InputError(problem("the file is empty", "a PCD file"));
  std::string_view rest = file;
  for (std::size_t number = 1; !rest.empty() && !find("DATA"); ++number)
    add(takeLine(rest), number);
  if (!find("DATA"))
    throw InputError(problem("the header has no DATA line", "a complete PCD header"));
  end_ = file.size() - rest.size();
}

void
HeaderLines::add(std::string_view line, std::size_t number)
{
  static const std::set<std::string, std::less<>> keywords{"VERSION",
                                                           "FIELDS",
                                                           "SIZE",
                                                           "TYPE",
                                                           "COUNT",
                                                           "WIDTH",
                                                           "HEIGHT",
                                                           "VIEWPOINT",
                                                           "POINTS",
                                                           "DATA"};
  Words words = splitWords(line);
  if (words.empty() || words.front().front() == '#')
    return;
  const std::string keyword(words.front());
  const std::string where = "header line " + std::to_string(number) + " ";
  if (keywords.count(keyword) == 0)
    throw InputError(problem(
        where + "begins with " + quoted(keyword),
        "VERSION, FIELDS, SIZE, TYPE, COUNT, WIDTH, HEIGHT, VIEWPOINT, POINTS or "
        "DATA"));
  words.erase(words.begin());
  if (!lines_.emplace(keyword, std::move(words)).second)
    throw InputError(problem(where + "repeats " + keyword, "each keyword once"));
}

const Words&
HeaderLines::words(const std::string& keyword, std::size_t count) const
{
  const Words* const found = find(keyword);
  if (!found)
    throw InputError(
        problem("the header has no " + keyword + " line", "a complete PCD header"));
  if (found->size() != count)
    throw InputError(
        problem(keyword + " has " + std::to_string(found->size()) + " values",
                std::to_string(count)));
  return *found;
}

std::uint64_t
HeaderLines::integer(const std::string& keyword, std::uint64_t most) const
{
  const std::string_view word = words(keyword, 1).front();
  const auto value = parseInteger<std::uint64_t>(word);
  if (!value || *value == 0 || *value > most)
    throw InputError(problem(keyword + " is " + quoted(word),
                             "a whole number from 1 to " + std::to_string(most)));
  return *value;
}

void
readFields(const HeaderLines& lines, CloudFile& cloud)
{
  const Words* const names = lines.find("FIELDS");
  if (!names || names->empty())
    throw InputError(lines.problem("the header has no FIELDS", "at least x y z"));
  const Words& sizes = lines.words("SIZE", names->size());
  const Words& types = lines.words("TYPE", names->size());
  const Words ones(names->size(), "1");
  const Words& counts =
      lines.find("COUNT") ? lines.words("COUNT", names->size()) : ones;
  std::uint64_t step = 0;
  for (std::size_t i = 0; i < names->size(); ++i) {
    const std::string_view name = (*names)[i];
    if (name != padding_field && std::count(names->begin(), names->end(), name) > 1)
      throw InputError(
          lines.problem("field " + quoted(name) + " is there twice", "each name once"));
    const auto datatype = datatypeOf(types[i], sizes[i]);
    if (!datatype)
      throw InputError(
          lines.problem("field " + quoted(name) + " has SIZE " + quoted(sizes[i]) +
                            " and TYPE " + quoted(types[i]),
                        "SIZE 1, 2, 4 or 8 with TYPE I or U, SIZE 4 or 8 with TYPE F"));
    const auto count = parseInteger<std::uint32_t>(counts[i]);
    if (!count || *count == 0 || *count > most_count)
      throw InputError(
          lines.problem("field " + quoted(name) + " has COUNT " + quoted(counts[i]),
                        "a whole number from 1 to " + std::to_string(most_count)));
    pcl::PCLPointField field;
    field.name = std::string(name);
    field.offset = static_cast<std::uint32_t>(step);
    field.datatype = *datatype;
    field.count = *count;
    cloud.blob.fields.push_back(field);
    step += valueSize(*datatype) * *count;
    if (step > most_bytes)
      throw InputError(lines.problem("a point has more than " +
                                         std::to_string(most_bytes) + " bytes",
                                     "fewer fields or smaller COUNT"));
  }
  cloud.blob.point_step = static_cast<std::uint32_t>(step);
}

void
readSize(const HeaderLines& lines, CloudFile& cloud)
{
  const std::uint64_t width = lines.integer("WIDTH", most_points);
  const std::uint64_t height =
      lines.find("HEIGHT") ? lines.integer("HEIGHT", most_points) : 1;
  const std::uint64_t points = lines.integer("POINTS", most_points);
  if (width * height != points)
    throw InputError(lines.problem("WIDTH " + std::to_string(width) + " times HEIGHT " +
                                       std::to_string(height) + " is not POINTS " +
                                       std::to_string(points),
                                   "POINTS = WIDTH x HEIGHT"));
  if (points * cloud.blob.point_step > most_bytes)
    throw InputError(lines.problem("POINTS " + std::to_string(points) + " of " +
                                       std::to_string(cloud.blob.point_step) + " bytes",
                                   "less than 4 GiB: divide the cloud into tiles"));
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
    const auto value = parseFloating<float>(words[i]);
    if (!value || !std::isfinite(*value))
      throw InputError(lines.problem("VIEWPOINT has the value " + quoted(words[i]),
                                     "a finite number"));
    cloud.viewpoint[i] = *value;
  }
}

void
requireVersion(const HeaderLines& lines)
{
  static const Words versions{"0.7", ".7", "0.6", ".6", "0.5", ".5"};
  if (!lines.find("VERSION"))
    return;
  const std::string_view version = lines.words("VERSION", 1).front();
  if (std::find(versions.begin(), versions.end(), version) == versions.end())
    throw InputError(lines.problem("VERSION is " + quoted(version), "0.5, 0.6 or 0.7"));
}

PCDFormat
readFormat(const HeaderLines& lines)
{
  const std::string_view name = lines.words("DATA", 1).front();
  if (const auto format = formatOf(name))
    return *format;
  throw InputError(
      lines.problem("DATA is " + quoted(name), "ascii, binary or binary_compressed"));
}

} // namespace

PCDHeader
parseHeader(const std::string& path, std::string_view file)
{
  const HeaderLines lines(path, file);
  requireVersion(lines);
  PCDHeader header;
  header.cloud.path = path;
  readFields(lines, header.cloud);
  readSize(lines, header.cloud);
  readViewpoint(lines, header.cloud);
  header.format = readFormat(lines);
  header.body = lines.end();
  return header;
}

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
