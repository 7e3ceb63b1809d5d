// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The points of a section of the sources on disk, sorted by tile.

#include "tiling/section_file.h"

#include "tiling/coordinates.h"

#include <array>
#include <cstddef>

namespace pcl::tiling {
namespace {

/** Which points of a group are of a tile: an entry of the group's table. */
struct Entry {
  std::uint32_t begin = 0, count = 0;
  std::uint32_t points_check = 0;
  std::uint32_t own_check = 0; ///< of what is before it

  std::uint32_t
  check() const
  {
    return checksumOf(this, offsetof(Entry, own_check));
  }
};

/** Before each table. */
struct GroupHeader {
  std::uint64_t points = 0;
  std::uint64_t coordinate = 0; ///< how many bytes it has
};

std::size_t
bytesOfPoint(bool are_floats)
{
  return 3 * (are_floats ? sizeof(float) : sizeof(double));
}

} // namespace

SectionWriter::SectionWriter(WholeFile& file, std::size_t tiles, std::size_t at_a_time)
: file_(file)
, tiles_(tiles)
, at_a_time_(at_a_time)
{}

void
SectionWriter::add(const Position& point, std::size_t tile)
{
  points_.push_back(point);
  tile_of_.push_back(static_cast<std::uint32_t>(tile));
  are_floats_ = are_floats_ && areFloats(point);
  if (points_.size() == at_a_time_)
    finish();
}

void
SectionWriter::finish()
{
  if (points_.empty())
    return;
  if (are_floats_)
    write<float>();
  else
    write<double>();
  points_.clear();
  tile_of_.clear();
  are_floats_ = true;
}

template <typename Coordinate>
void
SectionWriter::write()
{
  using Point = std::array<Coordinate, 3>;
  std::vector<Entry> table(tiles_);
  for (const std::uint32_t tile : tile_of_)
    ++table[tile].count;
  for (std::size_t tile = 1; tile < tiles_; ++tile)
    table[tile].begin = table[tile - 1].begin + table[tile - 1].count;
  std::vector<Point> sorted(points_.size());
  std::vector<std::uint32_t> next;
  for (const Entry& entry : table)
    next.push_back(entry.begin);
  for (std::size_t i = 0; i < points_.size(); ++i)
    sorted[next[tile_of_[i]]++] = coordinatesAs<Coordinate>(points_[i]);
  for (Entry& entry : table) {
    entry.points_check =
        checksumOf(sorted.data() + entry.begin, entry.count * sizeof(Point));
    entry.own_check = entry.check();
  }
  const GroupHeader header{sorted.size(), sizeof(Coordinate)};
  file_.write(&header, sizeof header);
  file_.write(table.data(), table.size() * sizeof(Entry));
  file_.write(sorted.data(), sorted.size() * sizeof(Point));
}

SectionFile::SectionFile(const std::string& path, std::size_t tiles)
: path_(path)
, tiles_(tiles)
{
  const std::int64_t size = sizeOfFile(path);
  if (size < 0)
    throw TilingError(path + ": is not there; expected the points of a section");
  for (std::uint64_t at = 0; static_cast<std::int64_t>(at) < size;) {
    GroupHeader header;
    if (size - static_cast<std::int64_t>(at) <
        static_cast<std::int64_t>(sizeof header + tiles * sizeof(Entry)))
      failDamaged(path);
    readAt(path, at, &header, sizeof header);
    const bool are_floats = header.coordinate == sizeof(float);
    if (header.points > points_sorted_at_a_time ||
        (!are_floats && header.coordinate != sizeof(double)))
      failDamaged(path);
    groups_.push_back({at + sizeof header, header.points, are_floats});
    at = pointsBegin(groups_.back()) + header.points * bytesOfPoint(are_floats);
    if (static_cast<std::int64_t>(at) > size)
      failDamaged(path);
  }
}

std::uint64_t
SectionFile::pointsBegin(const Group& group) const
{
  return group.begin + tiles_ * sizeof(Entry);
}

std::vector<std::uint64_t>
SectionFile::counts() const
{
  std::vector<std::uint64_t> counts(tiles_);
  std::vector<Entry> table(tiles_);
  for (const Group& group : groups_) {
    readAt(path_, group.begin, table.data(), table.size() * sizeof(Entry));
    for (std::size_t tile = 0; tile < tiles_; ++tile) {
      if (table[tile].check() != table[tile].own_check)
        failDamaged(path_);
      counts[tile] += table[tile].count;
    }
  }
  return counts;
}

void
SectionFile::addPointsOf(std::size_t tile, std::vector<Position>& points) const
{
  for (const Group& group : groups_) {
    Entry entry;
    readAt(path_, group.begin + tile * sizeof entry, &entry, sizeof entry);
    if (entry.check() != entry.own_check ||
        std::uint64_t{entry.begin} + entry.count > group.points)
      failDamaged(path_);
    if (entry.count == 0)
      continue;
    if (group.are_floats)
      addPoints<float>(group, entry.begin, entry.count, entry.points_check, points);
    else
      addPoints<double>(group, entry.begin, entry.count, entry.points_check, points);
  }
}

template <typename Coordinate>
void
SectionFile::addPoints(const Group& group,
                       std::uint64_t first,
                       std::size_t count,
                       std::uint32_t check,
                       std::vector<Position>& points) const
{
  std::vector<std::array<Coordinate, 3>> read(count);
  const std::size_t bytes = count * sizeof read[0];
  readAt(path_, pointsBegin(group) + first * sizeof read[0], read.data(), bytes);
  if (checksumOf(read.data(), bytes) != check)
    failDamaged(path_);
  for (const auto& coordinates : read)
    points.push_back(positionOf(coordinates));
}

} // namespace pcl::tiling
