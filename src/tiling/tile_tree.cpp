// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Where points are dense, and how space is cut into tiles of few points.

#include "tiling/tile_tree.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace pcl::tiling {
namespace {

constexpr std::uint64_t points_of_cell = 64; // enough to know how dense they are
constexpr double neighbors = 12.0, pi = 3.14159265358979;

/** Of numbers that are whole: the bits at their end are mostly zeros, and each factor
 * carries the others to the front. The factors are those of MurmurHash3's last mixing,
 * and 2^64 over the golden ratio. */
std::size_t
hashOf(const CellKey& key)
{
  std::array<std::uint64_t, 3> bits{};
  std::memcpy(bits.data(), key.data(), sizeof bits);
  std::uint64_t hash = (bits[0] >> 32 ^ bits[0]) * 0xff51afd7ed558ccdU;
  hash = (hash >> 29 ^ hash ^ bits[1]) * 0xc4ceb9fe1a85ec53U;
  hash = (hash >> 29 ^ hash ^ bits[2]) * 0x9e3779b97f4a7c15U;
  return hash ^ hash >> 32;
}

/** 2 to the power of an exponent, as std::ldexp() has it, for each point once. */
double
powerOfTwo(int exponent)
{
  constexpr int bias = 1023, digits = 52;
  const std::uint64_t bits = static_cast<std::uint64_t>(bias + exponent) << digits;
  double power = 0.0;
  std::memcpy(&power, &bits, sizeof power);
  return power;
}

/** std::floor(), but 0 has one sign: it is not a function of the library here. */
double
wholeBelow(double x)
{
  constexpr double all_are_whole = 4503599627370496.0; // 2^52
  if (!(std::abs(x) < all_are_whole))
    return x;
  const auto whole = static_cast<double>(static_cast<std::int64_t>(x));
  return whole > x ? whole - 1.0 : whole;
}

using Cells = std::vector<Cell>;

std::uint64_t
countOf(Cells::iterator begin, Cells::iterator end)
{
  std::uint64_t count = 0;
  for (auto cell = begin; cell != end; ++cell)
    count += cell->count;
  return count;
}

/** The axis along which cells reach farthest, and how many cells that are. */
std::pair<int, double>
longestAxis(Cells::iterator begin, Cells::iterator end)
{
  std::pair<int, double> longest{0, 0.0};
  for (int axis = 0; axis < 3; ++axis) {
    const auto at = static_cast<std::size_t>(axis);
    const auto [low, high] =
        std::minmax_element(begin, end, [at](const Cell& a, const Cell& b) {
          return a.key[at] < b.key[at];
        });
    const double cells = high->key[at] - low->key[at] + 1.0;
    if (cells > longest.second)
      longest = {axis, cells};
  }
  return longest;
}

/** Cuts cells into tiles, and appends their nodes. */
class Cutter {
public:
  Cutter(double cell, std::uint64_t max_points, double max_edge)
  : cell_(cell)
  , max_points_(max_points)
  , max_edge_(max_edge)
  {}

  std::size_t
  cut(Cells::iterator begin, Cells::iterator end)
  {
    const std::size_t at = nodes_.size();
    nodes_.emplace_back();
    const auto [axis, cells] = longestAxis(begin, end);
    const bool is_short = max_edge_ <= 0.0 || cells * cell_ <= max_edge_;
    if (cells == 1.0 || (is_short && countOf(begin, end) <= max_points_)) {
      nodes_[at].first = tiles_++;
      return at;
    }
    const auto [middle, border] = middleOf(begin, end, static_cast<std::size_t>(axis));
    const std::size_t first = cut(begin, middle), second = cut(middle, end);
    nodes_[at] = {axis, border, first, second};
    return at;
  }

  std::vector<TileTree::Node>
  nodes()
  {
    return std::move(nodes_);
  }

private:
  /** The first cell of the second part, with half of the points before it, and its key.
   */
  static std::pair<Cells::iterator, double>
  middleOf(Cells::iterator begin, Cells::iterator end, std::size_t axis)
  {
    std::sort(begin, end, [axis](const Cell& a, const Cell& b) {
      return a.key[axis] < b.key[axis];
    });
    const std::uint64_t all = countOf(begin, end);
    std::uint64_t before = 0, best_off = all;
    auto best = begin;
    for (auto cell = begin; cell != end; ++cell) {
      const bool is_border = cell != begin && cell->key[axis] != (cell - 1)->key[axis];
      const std::uint64_t off = 2 * before > all ? 2 * before - all : all - 2 * before;
      if (is_border && off < best_off) {
        best_off = off;
        best = cell;
      }
      before += cell->count;
    }
    return {best, best->key[axis]};
  }

  double cell_;
  std::uint64_t max_points_;
  double max_edge_;
  std::size_t tiles_ = 0;
  std::vector<TileTree::Node> nodes_;
};

} // namespace

CellKey
CellGrid::keyOf(const float* point) const
{
  const double scale = powerOfTwo(-exponent);
  CellKey key;
  for (std::size_t axis = 0; axis < 3; ++axis)
    key[axis] = wholeBelow(scale * static_cast<double>(point[axis]));
  return key;
}

CellKey
CellGrid::keyOf(const CellGrid& finer, const CellKey& key) const
{
  const double scale = powerOfTwo(finer.exponent - exponent);
  CellKey result;
  for (std::size_t axis = 0; axis < 3; ++axis)
    result[axis] = wholeBelow(scale * key[axis]);
  return result;
}

double
CellGrid::size() const
{
  return powerOfTwo(exponent);
}

void
CellCounts::add(const CellKey& key, std::uint64_t count)
{
  const std::size_t mask = slots_.size() - 1;
  std::size_t at = hashOf(key) & mask;
  while (slots_[at].count > 0 && slots_[at].key != key)
    at = (at + 1) & mask;
  if (slots_[at].count == 0) {
    slots_[at].key = key;
    ++size_;
  }
  slots_[at].count += count;
  if (2 * size_ > slots_.size())
    grow();
}

void
CellCounts::prepare(const CellKey& key) const
{
  __builtin_prefetch(&slots_[hashOf(key) & (slots_.size() - 1)], 1);
}

void
CellCounts::grow()
{
  std::vector<Cell> old(2 * slots_.size());
  old.swap(slots_);
  size_ = 0;
  for (const Cell& cell : old)
    if (cell.count > 0)
      add(cell.key, cell.count);
}

std::vector<Cell>
CellCounts::cells() const
{
  std::vector<Cell> cells;
  cells.reserve(size_);
  for (const Cell& cell : slots_)
    if (cell.count > 0)
      cells.push_back(cell);
  return cells;
}

std::vector<Cell>
CellCounts::sorted() const
{
  std::vector<Cell> cells = this->cells();
  std::sort(cells.begin(), cells.end(), [](const Cell& a, const Cell& b) {
    return a.key < b.key;
  });
  return cells;
}

CellCounts
CellCounts::coarser(int doublings) const
{
  const CellGrid larger{doublings};
  CellCounts result(slots_.size());
  for (const auto& [key, count] : slots_)
    if (count > 0)
      result.add(larger.keyOf(CellGrid{}, key), count);
  return result;
}

DensityCells::DensityCells(std::size_t max_cells, int exponent)
: max_cells_(max_cells)
, first_exponent_(exponent)
, grid_{exponent}
{}

template <typename KeyAt, typename CountAt>
void
DensityCells::addEach(std::size_t count, const KeyAt& keyAt, const CountAt& countAt)
{
  // Some at a time, whose cells are fetched at once: the table is larger than a cache.
  std::array<CellKey, 32> keys;
  for (std::size_t begin = 0; begin < count; begin += keys.size()) {
    const std::size_t size = std::min(keys.size(), count - begin);
    for (std::size_t i = 0; i < size; ++i) {
      keys[i] = keyAt(begin + i);
      counts_.prepare(keys[i]);
    }
    for (std::size_t i = 0; i < size; ++i)
      counts_.add(keys[i], countAt(begin + i));
    bound();
  }
}

void
DensityCells::add(const float* points, std::size_t count)
{
  addEach(
      count,
      [&](std::size_t i) { return grid_.keyOf(points + 3 * i); },
      [](std::size_t) { return std::uint64_t{1}; });
}

bool
DensityCells::areSmallest() const
{
  return grid_.exponent > first_exponent_ || grid_.exponent == min_exponent;
}

void
DensityCells::add(const CellGrid& grid, const std::vector<Cell>& cells)
{
  if (grid_.exponent < grid.exponent) {
    counts_ = counts_.coarser(grid.exponent - grid_.exponent);
    grid_ = grid;
  }
  addEach(
      cells.size(),
      [&](std::size_t i) { return grid_.keyOf(grid, cells[i].key); },
      [&](std::size_t i) { return cells[i].count; });
}

void
DensityCells::bound()
{
  while (counts_.size() > max_cells_) {
    CellCounts larger = counts_.coarser(doublings_);
    if (doublings_ > 1 && larger.size() <= max_cells_) {
      doublings_ /= 2; // smaller cells may be few enough, too
      continue;
    }
    counts_ = std::move(larger);
    grid_.exponent += doublings_;
  }
}

double
DensityCells::typicalDistance() const
{
  if (counts_.size() < 2)
    return 0.0;
  CellCounts counts = counts_;
  Cells cells = counts.cells();
  const std::uint64_t all = countOf(cells.begin(), cells.end());
  CellGrid grid = grid_;
  const auto isCoarse = [&] {
    return counts.size() * points_of_cell <= all || counts.size() < 2 * points_of_cell;
  };
  for (; !isCoarse(); ++grid.exponent)
    counts = counts.coarser(1);
  cells = counts.cells();
  std::sort(cells.begin(), cells.end(), [](const Cell& a, const Cell& b) {
    return a.count < b.count;
  });
  std::uint64_t before = 0;
  const auto middle = std::find_if(cells.begin(), cells.end(), [&](const Cell& cell) {
    return 2 * (before += cell.count) >= all;
  });
  // Of a surface that crosses the cell: a circle with so many points.
  return grid.size() * std::sqrt(neighbors / (pi * static_cast<double>(middle->count)));
}

TileTree::TileTree(const DensityCells& cells, std::uint64_t max_points, double max_edge)
: grid_(cells.grid())
{
  Cells list = cells.counts().cells();
  if (list.empty()) {
    nodes_.emplace_back();
    return;
  }
  Cutter cutter(grid_.size(), max_points, max_edge);
  cutter.cut(list.begin(), list.end());
  nodes_ = cutter.nodes();
}

std::size_t
TileTree::tileOf(const CellKey& key) const
{
  const Node* node = &nodes_.front();
  while (node->axis >= 0)
    node =
        &nodes_[key[static_cast<std::size_t>(node->axis)] < node->cut ? node->first
                                                                      : node->second];
  return node->first;
}

std::size_t
TileTree::tileOf(const float* point) const
{
  // A whole number is above the one below a point if and only if it is above the point.
  const double cells = powerOfTwo(-grid_.exponent);
  const Node* node = &nodes_.front();
  while (node->axis >= 0) {
    const double at = cells * static_cast<double>(point[node->axis]);
    node = &nodes_[at < node->cut ? node->first : node->second];
  }
  return node->first;
}

std::size_t
TileTree::size() const
{
  return (nodes_.size() + 1) / 2;
}

} // namespace pcl::tiling
