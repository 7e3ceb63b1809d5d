// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The points of a tile on disk, in blocks, so that those near a border are read alone.

#include "tiling/tile_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numeric>

namespace pcl::tiling {
namespace {

// "PCLTILE", a version, then points, blocks and the check of the blocks.
constexpr std::array<char, 8> magic{'P', 'C', 'L', 'T', 'I', 'L', 'E', '1'};

struct Header {
  std::array<char, 8> magic{};
  std::uint64_t points = 0, blocks = 0;
  std::uint32_t check = 0, padding = 0;
};

/** A point, and its place among those of the tile. */
struct Entry {
  Position position;
  std::uint64_t place;
};

constexpr double blocks_along = 24.0; // edges: a border is a tenth of the tile then

/** The points in the order of blocks, each with the number of its block. */
struct Sorted {
  std::vector<std::uint32_t> order;
  std::vector<std::uint64_t> blocks; ///< where each begins, and the end
};

Sorted
sortedByBlock(const std::vector<Position>& points, const Box& box)
{
  double edge = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    edge = std::max(edge, box.high[axis] - box.low[axis]);
  const double scale = edge > 0.0 ? blocks_along / edge : 0.0;
  std::vector<std::uint32_t> keys;
  keys.reserve(points.size());
  for (const Position& p : points) {
    std::uint32_t key = 0;
    for (std::size_t axis = 3; axis-- > 0;)
      key = key << 8 | static_cast<std::uint32_t>((p[axis] - box.low[axis]) * scale);
    keys.push_back(key);
  }
  Sorted sorted;
  sorted.order.resize(points.size());
  std::iota(sorted.order.begin(), sorted.order.end(), 0U);
  std::stable_sort(sorted.order.begin(), sorted.order.end(), [&](auto a, auto b) {
    return keys[a] < keys[b];
  });
  for (std::size_t i = 0; i < points.size(); ++i)
    if (i == 0 || keys[sorted.order[i]] != keys[sorted.order[i - 1]])
      sorted.blocks.push_back(i);
  sorted.blocks.push_back(points.size());
  return sorted;
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

Bytes
encodeTile(const std::vector<Position>& points)
{
  const Sorted sorted = sortedByBlock(points, Box::of(points));
  std::vector<TileFile::Block> blocks;
  Bytes data;
  data.reserve(points.size() * sizeof(Entry));
  for (std::size_t b = 0; b + 1 < sorted.blocks.size(); ++b) {
    std::vector<Position> members;
    const std::size_t at = data.size();
    for (std::uint64_t i = sorted.blocks[b]; i < sorted.blocks[b + 1]; ++i) {
      members.push_back(points[sorted.order[i]]);
      put(Entry{members.back(), sorted.order[i]}, data);
    }
    blocks.push_back({Box::of(members),
                      sorted.blocks[b],
                      members.size(),
                      checksumOf(data.data() + at, data.size() - at)});
  }
  Bytes bytes;
  const Header header{magic,
                      points.size(),
                      blocks.size(),
                      checksumOf(blocks.data(), blocks.size() * sizeof(blocks[0]))};
  bytes.reserve(sizeof header + blocks.size() * sizeof(blocks[0]) + data.size());
  put(header, bytes);
  for (const TileFile::Block& block : blocks)
    put(block, bytes);
  bytes.insert(bytes.end(), data.begin(), data.end());
  return bytes;
}

TileFile::TileFile(const std::string& path) : path_(path)
{
  Header header;
  readAt(path, 0, &header, sizeof header);
  data_begin_ = sizeof header + header.blocks * sizeof(Block);
  const auto expected =
      static_cast<std::int64_t>(data_begin_ + header.points * sizeof(Entry));
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
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box_.low[axis] = std::min(box_.low[axis], block.box.low[axis]);
      box_.high[axis] = std::max(box_.high[axis], block.box.high[axis]);
    }
}

template <typename Use>
void
TileFile::forEachOf(std::size_t first, std::size_t end, const Use& use) const
{
  const std::uint64_t begin = blocks_[first].begin;
  std::vector<Entry> entries(blocks_[end - 1].begin + blocks_[end - 1].size - begin);
  readAt(path_,
         data_begin_ + begin * sizeof(Entry),
         entries.data(),
         entries.size() * sizeof(Entry));
  for (std::size_t b = first; b < end; ++b) {
    const Entry* const from = &entries[blocks_[b].begin - begin];
    if (checksumOf(from, blocks_[b].size * sizeof(Entry)) != blocks_[b].check)
      failDamaged(path_);
    for (std::uint64_t i = 0; i < blocks_[b].size; ++i)
      use(from[i].position, from[i].place);
  }
}

std::vector<Position>
TileFile::points() const
{
  std::vector<Position> points(size_);
  for (std::size_t b = 0; b < blocks_.size(); ++b)
    forEachOf(b, b + 1, [&](const Position& position, std::uint64_t place) {
      points.at(place) = position;
    });
  return points;
}

void
TileFile::addPointsIn(const Box& box, std::vector<Position>& points) const
{
  for (std::size_t b = 0; b < blocks_.size(); ++b)
    if (box.meets(blocks_[b].box))
      forEachOf(b, b + 1, [&](const Position& position, std::uint64_t) {
        if (box.holds(position))
          points.push_back(position);
      });
}

} // namespace pcl::tiling
