/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "pcd_header.h"

#include "errors.h"
#include "pcd_types.h"
#include "pcd_values.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace pcl::app {
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

} // namespace pcl::app
