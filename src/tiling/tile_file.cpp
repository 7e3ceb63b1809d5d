// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The points of a tile on disk, in blocks, so that those near a border are read alone.

#include "tiling/tile_file.h"

#include "tiling/coordinates.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <type_traits>
#include <utility>

namespace pcl::tiling {
namespace {

// "PCLTILE", a version, then points, blocks, and the check of the blocks.
constexpr std::array<char, 8> magic{'P', 'C', 'L', 'T', 'I', 'L', 'E', '2'};

struct Header {
  std::array<char, 8> magic{};
  std::uint64_t points = 0, blocks = 0;
  std::uint32_t check = 0, coordinate = 0; ///< how many bytes it has
};

/** A point, and its place among those of the tile, of which there are fewer than 2^32.
 */
template <typename Coordinate>
struct Entry {
  std::array<Coordinate, 3> position;
  std::conditional_t<sizeof(Coordinate) == 4, std::uint32_t, std::uint64_t> place;
};

constexpr double blocks_along = 24.0;   // edges: a border is a tenth of the tile then
constexpr std::size_t cells_along = 25; // the last one has the farthest points
constexpr std::size_t all_cells = cells_along * cells_along * cells_along;

/** Of each point the cell of the tile's box, numbered along x, y and z. */
std::vector<std::uint16_t>
cellsOf(const std::vector<Position>& points)
{
  const Box box = Box::of(points);
  double edge = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    edge = std::max(edge, box.high[axis] - box.low[axis]);
  const double scale = edge > 0.0 ? blocks_along / edge : 0.0;
  std::vector<std::uint16_t> cells;
  cells.reserve(points.size());
  for (const Position& p : points) {
    std::size_t cell = 0;
    for (std::size_t axis = 3; axis-- > 0;)
      cell = cell * cells_along +
             static_cast<std::size_t>((p[axis] - box.low[axis]) * scale);
    cells.push_back(static_cast<std::uint16_t>(cell));
  }
  return cells;
}

} // namespace

Box
Box::of(const std::vector<Position>& points)
{
  Box box{points.front(), points.front()};
  for (const Position& p : points)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.low[axis] = std::min(box.low[axis], p[axis]);
      box.high[axis] = std::max(box.high[axis], p[axis]);
    }
  return box;
}

Box
Box::grown(double by) const
{
  Box box = *this;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.low[axis] -= by;
    box.high[axis] += by;
  }
  return box;
}

void
Box::add(const Box& other)
{
  for (std::size_t axis = 0; axis < 3; ++axis) {
    low[axis] = std::min(low[axis], other.low[axis]);
    high[axis] = std::max(high[axis], other.high[axis]);
  }
}

template <typename Coordinate>
Bytes
TileFile::encoded(const std::vector<Position>& points)
{
  using Point = Entry<Coordinate>;
  const std::vector<std::uint16_t> cells = cellsOf(points);
  std::vector<Block> blocks(all_cells);
  for (const std::uint16_t cell : cells)
    ++blocks[cell].size;
  const auto isEmpty = [](const Block& block) { return block.size == 0; };
  const auto empty = std::count_if(blocks.begin(), blocks.end(), isEmpty);
  std::uint64_t before = 0;
  for (Block& block : blocks) {
    block.begin = before;
    before += std::exchange(block.size, 0);
  }
  const std::size_t begin =
      sizeof(Header) + (all_cells - static_cast<std::size_t>(empty)) * sizeof(Block);
  Bytes bytes(begin + points.size() * sizeof(Point));
  std::uint8_t* const data = bytes.data() + begin;
  for (std::size_t i = 0; i < points.size(); ++i) {
    Block& block = blocks[cells[i]];
    const Box box{points[i], points[i]};
    if (isEmpty(block))
      block.box = box;
    block.box.add(box);
    Point point{coordinatesAs<Coordinate>(points[i]), {}};
    point.place = static_cast<decltype(point.place)>(i);
    std::memcpy(
        data + (block.begin + block.size++) * sizeof point, &point, sizeof point);
  }
  blocks.erase(std::remove_if(blocks.begin(), blocks.end(), isEmpty), blocks.end());
  for (Block& block : blocks)
    block.check =
        checksumOf(data + block.begin * sizeof(Point), block.size * sizeof(Point));
  const std::size_t size = blocks.size() * sizeof(Block);
  const Header header{magic,
                      points.size(),
                      blocks.size(),
                      checksumOf(blocks.data(), size),
                      sizeof(Coordinate)};
  std::memcpy(bytes.data(), &header, sizeof header);
  std::memcpy(bytes.data() + sizeof header, blocks.data(), size);
  return bytes;
}

Bytes
encodeTile(const std::vector<Position>& points)
{
  return std::all_of(points.begin(), points.end(), areFloats)
             ? TileFile::encoded<float>(points)
             : TileFile::encoded<double>(points);
}

TileFile::TileFile(const std::string& path) : path_(path)
{
  Header header;
  readAt(path, 0, &header, sizeof header);
  data_begin_ = sizeof header + header.blocks * sizeof(Block);
  are_floats_ = header.coordinate == sizeof(float);
  const std::size_t point = are_floats_ ? sizeof(Entry<float>) : sizeof(Entry<double>);
  const auto expected = static_cast<std::int64_t>(data_begin_ + header.points * point);
  if (header.magic != magic || header.blocks == 0 || header.blocks > header.points ||
      sizeOfFile(path) != expected)
    failDamaged(path);
  size_ = header.points;
  blocks_.resize(header.blocks);
  readAt(path, sizeof header, blocks_.data(), blocks_.size() * sizeof(Block));
  if (checksumOf(blocks_.data(), blocks_.size() * sizeof(Block)) != header.check)
    failDamaged(path);
  box_ = blocks_.front().box;
  for (const Block& block : blocks_)
    box_.add(block.box);
}

template <typename Coordinate, typename Use>
void
TileFile::forEachOf(std::size_t first, std::size_t end, const Use& use) const
{
  const std::uint64_t begin = blocks_[first].begin;
  std::vector<Entry<Coordinate>> entries(blocks_[end - 1].begin +
                                         blocks_[end - 1].size - begin);
  readAt(path_,
         data_begin_ + begin * sizeof entries[0],
         entries.data(),
         entries.size() * sizeof entries[0]);
  for (std::size_t b = first; b < end; ++b) {
    const auto* const from = &entries[blocks_[b].begin - begin];
    if (checksumOf(from, blocks_[b].size * sizeof entries[0]) != blocks_[b].check)
      failDamaged(path_);
    for (std::uint64_t i = 0; i < blocks_[b].size; ++i)
      use(positionOf(from[i].position), from[i].place);
  }
}

template <typename Is, typename Use>
void
TileFile::forEachOfThose(const Is& isWanted, const Use& use) const
{
  constexpr std::uint64_t points_at_a_time = 1 << 17; // some megabytes
  for (std::size_t first = 0; first < blocks_.size(); ++first) {
    std::size_t end = first;
    std::uint64_t points = 0;
    while (end < blocks_.size() && points < points_at_a_time && isWanted(blocks_[end]))
      points += blocks_[end++].size;
    if (end == first)
      continue;
    if (are_floats_)
      forEachOf<float>(first, end, use);
    else
      forEachOf<double>(first, end, use);
    first = end - 1;
  }
}

std::vector<Position>
TileFile::points() const
{
  std::vector<Position> points(size_);
  forEachOfThose([](const Block&) { return true; },
                 [&](const Position& position, std::uint64_t place) {
                   points.at(place) = position;
                 });
  return points;
}

void
TileFile::addPointsIn(const Box& box,
                      std::vector<Position>& points,
                      std::vector<std::uint32_t>& places) const
{
  forEachOfThose([&](const Block& block) { return box.meets(block.box); },
                 [&](const Position& position, std::uint64_t place) {
                   if (!box.holds(position))
                     return;
                   points.push_back(position);
                   places.push_back(static_cast<std::uint32_t>(place));
                 });
}

} // namespace pcl::tiling
