// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A cloud file of any size, some points at a time.

#include "io/cloud_stream.h"

#include "io/errors.h"
#include "io/files.h"
#include "io/ply.h"
#include "io/text.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

#include <sys/stat.h>

namespace pcl::app {
namespace {

constexpr std::size_t part_points = 1 << 17; // some megabytes
// Points of a section: small ones can be shared evenly, large ones make few files.
constexpr std::uint64_t min_section = part_points, max_section = 1 << 20,
                        wanted_sections = 8;
constexpr std::size_t head_bytes = 1 << 20; // of a header: PCL's have some hundred
constexpr std::size_t text_bytes = 1 << 22; // of text at a time

[[noreturn]] void
failToRead(const std::string& path, const char* why)
{
  throw InputError(path + ": cannot be read: " + why +
                   "; expected a PCD, PLY or KITTI .bin file");
}

/** A file, read from some place on. */
class File {
public:
  File(const std::string& path, std::uint64_t begin) : path_(path), at_(begin)
  {
    if (path == standard_stream)
      failToRead("standard input", "it can be read only once");
    descriptor_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    struct stat status {};
    if (descriptor_ < 0 || ::fstat(descriptor_, &status) != 0)
      failToRead(path, std::strerror(errno));
    if (!S_ISREG(status.st_mode))
      failToRead(path, "it is not a regular file, and is read several times");
  }
  ~File() { ::close(descriptor_); }
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  /** Append up to so many bytes. \return false at the end of the file */
  bool
  read(std::size_t size, std::string& to)
  {
    const std::size_t old = to.size();
    to.resize(old + size);
    std::size_t got = 0;
    while (got < size) {
      const ssize_t now = ::pread(
          descriptor_, to.data() + old + got, size - got, static_cast<off_t>(at_));
      if (now < 0 && errno != EINTR)
        failToRead(path_, std::strerror(errno));
      if (now == 0)
        break;
      if (now > 0) {
        got += static_cast<std::size_t>(now);
        at_ += static_cast<std::uint64_t>(now);
      }
    }
    to.resize(old + got);
    return got > 0;
  }

private:
  std::string path_;
  std::uint64_t at_;
  int descriptor_ = -1;
};

/** A part of a cloud with room for so many points. */
CloudFile
partOf(const CloudFile& cloud, std::uint64_t points)
{
  CloudFile part = cloud;
  part.blob.width = static_cast<std::uint32_t>(points);
  part.blob.height = 1;
  part.blob.row_step = part.blob.width * part.blob.point_step;
  return part;
}

/** part(body, points) for bytes that hold so many points, from the first one to the
 * end.
 */
template <typename Part>
void
forEachBinary(const std::string& path,
              const PointRows& rows,
              std::uint64_t first,
              std::uint64_t end,
              const Part& part)
{
  const std::uint64_t size =
      std::uint64_t{rows.cloud.blob.width} * rows.cloud.blob.height;
  File file(path, rows.begin + first * rows.cloud.blob.point_step);
  std::string body;
  for (std::uint64_t begin = first; begin < end; begin += part_points) {
    const std::uint64_t points = std::min<std::uint64_t>(part_points, end - begin);
    body.clear();
    file.read(points * rows.cloud.blob.point_step, body);
    if (body.size() < points * rows.cloud.blob.point_step)
      throw InputError(
          path + ": truncated: the header promises " + std::to_string(size) +
          " points, but the file ends in point " +
          std::to_string(begin + body.size() / rows.cloud.blob.point_step) +
          "; expected a complete file");
    part(body, points);
  }
}

/** How many lines there are with something on them, and where the last one ends. */
struct Lines {
  std::uint64_t count = 0;
  std::size_t end = 0;
};

Lines
linesOf(std::string_view text, std::uint64_t most)
{
  Lines lines;
  std::string_view rest = text;
  while (lines.count < most && rest.find('\n') != std::string_view::npos) {
    lines.count += splitPoint(takeLine(rest)).empty() ? 0 : 1;
    lines.end = text.size() - rest.size();
  }
  return lines;
}

/** The same for lines. */
template <typename Part>
void
forEachText(const std::string& path, const PointRows& rows, const Part& part)
{
  const std::uint64_t size =
      std::uint64_t{rows.cloud.blob.width} * rows.cloud.blob.height;
  File file(path, rows.begin);
  std::string text;
  for (std::uint64_t begin = 0; begin < size;) {
    // Short lines: a part of the text has more of them than a part of the cloud.
    const bool is_enough =
        text.size() >= text_bytes && text.find('\n') != std::string::npos;
    const bool has_more = is_enough || file.read(text_bytes, text);
    if (!has_more && !text.empty() && text.back() != '\n')
      text += '\n';
    const Lines lines =
        linesOf(text, std::min<std::uint64_t>(part_points, size - begin));
    if (lines.count == 0 && !has_more)
      throw InputError(path + ": truncated: " + std::to_string(begin) +
                       " rows; expected " + std::to_string(size) + " by the header");
    if (lines.count > 0)
      try {
        part(std::string_view(text).substr(0, lines.end), lines.count);
      }
      catch (const InputError& error) {
        throw InputError(std::string(error.what()) + " (points counted from point " +
                         std::to_string(begin) + " on)");
      }
    begin += lines.count;
    text.erase(0, lines.end);
  }
}

} // namespace

CloudStream::CloudStream(const std::string& path, unsigned floats)
: path_(path)
, floats_(floats)
{
  std::string head;
  File(path, 0).read(head_bytes, head);
  format_ = cloudFormatOf(path, head, floats);
  if (format_ == CloudFormat::ply)
    rows_ = rowsOfPly(path, head);
  else if (format_ == CloudFormat::pcd)
    rows_ = rowsOfPcd(path, head);
  if (rows_) {
    // The names and types of the fields are those of a part of one point, of zeros.
    description_ = partOf(rows_->cloud, 1);
    description_.blob.data.resize(description_.blob.point_step);
    finish(description_);
    description_.blob.data.clear();
    description_.blob.width = rows_->cloud.blob.width;
    description_.blob.height = rows_->cloud.blob.height;
  }
  else {
    description_ = readAnyCloud(path, floats);
    description_.blob.data.clear();
    description_.blob.data.shrink_to_fit();
  }
}

std::string
CloudStream::state() const
{
  struct stat status {};
  if (::stat(path_.c_str(), &status) != 0)
    failToRead(path_, std::strerror(errno));
  return std::to_string(status.st_size) + " bytes, changed at " +
         std::to_string(status.st_mtim.tv_sec) + "." +
         std::to_string(status.st_mtim.tv_nsec);
}

void
CloudStream::finish(CloudFile& part) const
{
  if (format_ == CloudFormat::ply)
    usePclNamesOfPly(part);
  else
    finishPcd(part);
}

std::size_t
CloudStream::countSections() const
{
  if (!rows_ || rows_->is_text)
    return 1;
  const std::uint64_t of_section =
      std::clamp(size() / wanted_sections, min_section, max_section);
  return static_cast<std::size_t>(
      std::max<std::uint64_t>(1, (size() + of_section - 1) / of_section));
}

CloudStream::Range
CloudStream::rangeOf(std::size_t section) const
{
  const std::uint64_t sections = countSections();
  // Sections of equal size, without a product that may be too large.
  const std::uint64_t whole = size() / sections, rest = size() % sections;
  const auto beginOf = [&](std::uint64_t s) { return s * whole + std::min(s, rest); };
  return {beginOf(section), beginOf(section + 1)};
}

void
CloudStream::forEachPart(std::size_t section, const UsePart& use) const
{
  if (!rows_) {
    CloudFile cloud = readAnyCloud(path_, floats_);
    cloud.blob.width *= cloud.blob.height;
    cloud.blob.height = 1;
    use(cloud);
    return;
  }
  const auto part = [&](std::string_view body, std::uint64_t points) {
    CloudFile cloud = partOf(rows_->cloud, points);
    if (rows_->is_text)
      readAsciiPoints(cloud, body);
    else
      readBinaryPoints(cloud, body);
    finish(cloud);
    use(cloud);
  };
  const auto [begin, end] = rangeOf(section);
  if (rows_->is_text)
    forEachText(path_, *rows_, part);
  else
    forEachBinary(path_, *rows_, begin, end, part);
}

void
CloudStream::forEachPosition(std::size_t section, const UsePositions& use) const
{
  if (!rows_ || rows_->is_text) {
    forEachPart(section, [&](const CloudFile& cloud) {
      const std::vector<std::array<double, 3>> points = coordinatesOf(cloud);
      use(points.data(), points.size());
    });
    return;
  }
  CloudFile cloud = rows_->cloud;
  usePclNames(cloud); // those of coordinates; the rest is not needed
  const auto [begin, end] = rangeOf(section);
  forEachBinary(
      path_, *rows_, begin, end, [&](std::string_view body, std::uint64_t count) {
        const std::vector<std::array<double, 3>> points = coordinatesOf(
            cloud, reinterpret_cast<const std::uint8_t*>(body.data()), count);
        use(points.data(), points.size());
      });
}

void
CloudStream::forEachPosition(const UsePositions& use) const
{
  for (std::size_t section = 0; section < countSections(); ++section)
    forEachPosition(section, use);
}

} // namespace pcl::app
