/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "row_index.h"

#include "finite.h"
#include "parallel.h"
#include "radix_sort.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::kernels {
namespace {

/** Points are first sorted by cells of this fraction of the edge along x. */
constexpr double x_cells_an_edge = 8.0;

/** More digits of x than these are left to the sort within the rows. */
constexpr int most_x_bits = 16;

/** \brief The points to sort: some of those given, or all. */
struct Selection {
  const XYZView& points;
  const std::int32_t* indices;

  const float*
  operator[](std::size_t i) const
  {
    return points[indices ? static_cast<std::size_t>(indices[i]) : i];
  }
};

struct CellRange {
  std::int32_t first = std::numeric_limits<std::int32_t>::max();
  std::int32_t last = std::numeric_limits<std::int32_t>::min();

  void
  add(std::int32_t cell)
  {
    first = std::min(first, cell);
    last = std::max(last, cell);
  }

  int
  bits() const
  {
    int bits = 0;
    for (std::int64_t span = std::int64_t{last} - first; span > 0; span >>= 1) {
      ++bits;
    }
    return bits;
  }
};

struct Cells {
  CellRange x, y, z;
  std::size_t count = 0; ///< of finite points

  void
  merge(const Cells& other)
  {
    count += other.count;
    if (other.count > 0) {
      x.add(other.x.first), x.add(other.x.last);
      y.add(other.y.first), y.add(other.y.last);
      z.add(other.z.first), z.add(other.z.last);
    }
  }
};

constexpr std::size_t part_size = 8192;

/** \brief The cells that a part's finite points are in. */
Cells
cellsOf(const Selection& points,
        std::size_t begin,
        std::size_t end,
        double cells_a_metre)
{
  constexpr float infinity = std::numeric_limits<float>::infinity();
  float least[3] = {infinity, infinity, infinity};
  float most[3] = {-infinity, -infinity, -infinity};
  Cells cells;
  for (std::size_t i = begin; i < end; ++i) {
    const float* p = points[i];
    if (isFinite(p)) {
      for (int axis = 0; axis < 3; ++axis) {
        least[axis] = std::min(least[axis], p[axis]);
        most[axis] = std::max(most[axis], p[axis]);
      }
      ++cells.count;
    }
  }
  const auto add = [&](const float* p) {
    cells.x.add(cellOf(p[0], x_cells_an_edge * cells_a_metre));
    cells.y.add(cellOf(p[1], cells_a_metre));
    cells.z.add(cellOf(p[2], cells_a_metre));
  };
  if (cells.count > 0) {
    add(least);
    add(most);
  }
  return cells;
}

std::vector<Cells>
cellsOfParts(const Selection& points,
             std::size_t count,
             double cells_a_metre,
             unsigned threads)
{
  std::vector<Cells> parts((count + part_size - 1) / part_size);
  parallelFor(parts.size(), threads, [&](std::size_t part) {
    const std::size_t end = std::min(count, (part + 1) * part_size);
    parts[part] = cellsOf(points, part * part_size, end, cells_a_metre);
  });
  return parts;
}

/** \brief How the bits of a key are shared by (z cell, y cell, x cell). */
class KeyLayout {
public:
  KeyLayout(const Cells& all, double cells_a_metre)
  : all_(all)
  , cells_a_metre_(cells_a_metre)
  , y_bits_(all.y.bits())
  , row_bits_(y_bits_ + all.z.bits())
  , x_bits_(std::min({all.x.bits(), most_x_bits, 64 - row_bits_}))
  , x_shift_(all.x.bits() - x_bits_)
  {
    // Half the bytes to move if there are bits enough.
    constexpr int least_x_bits = 12;
    if (row_bits_ + std::min(x_bits_, least_x_bits) <= 32) {
      x_bits_ = std::min(x_bits_, 32 - row_bits_);
      x_shift_ = all.x.bits() - x_bits_;
    }
  }

  int
  bits() const
  {
    return x_bits_ + row_bits_;
  }

  template <typename Key>
  Key
  keyOf(const float* p) const
  {
    const Key x = offset<Key>(cellOf(p[0], x_cells_an_edge * cells_a_metre_), all_.x);
    const Key y = offset<Key>(cellOf(p[1], cells_a_metre_), all_.y);
    const Key z = offset<Key>(cellOf(p[2], cells_a_metre_), all_.z);
    return static_cast<Key>(((shifted(z, y_bits_) | y) << x_bits_) | (x >> x_shift_));
  }

  template <typename Key>
  Key
  rowOf(Key key) const
  {
    return static_cast<Key>(key >> x_bits_);
  }

  Row
  rowAt(std::uint64_t row, std::uint32_t begin) const
  {
    const std::uint64_t y = row & ((std::uint64_t{1} << y_bits_) - 1);
    return {static_cast<std::int32_t>(static_cast<std::int64_t>(row >> y_bits_) +
                                      all_.z.first),
            static_cast<std::int32_t>(static_cast<std::int64_t>(y) + all_.y.first),
            begin,
            0};
  }

private:
  template <typename Key>
  static Key
  offset(std::int32_t cell, const CellRange& range)
  {
    return static_cast<Key>(std::int64_t{cell} - range.first);
  }

  /** \brief A shift by all bits is not defined: there is nothing to shift then. */
  template <typename Key>
  static Key
  shifted(Key value, int bits)
  {
    return value == 0 ? value : static_cast<Key>(value << bits);
  }

  const Cells& all_;
  double cells_a_metre_;
  int y_bits_, row_bits_, x_bits_, x_shift_;
};

template <typename Key>
std::vector<Keyed<Key>>
sortedEntries(const Selection& points,
              const std::vector<Cells>& parts,
              std::size_t count,
              const KeyLayout& layout,
              unsigned threads)
{
  std::vector<std::size_t> begins(parts.size() + 1, 0);
  for (std::size_t part = 0; part < parts.size(); ++part) {
    begins[part + 1] = begins[part] + parts[part].count;
  }
  std::vector<Keyed<Key>> entries(begins.back());
  parallelFor(parts.size(), threads, [&](std::size_t part) {
    std::size_t at = begins[part];
    for (std::size_t i = part * part_size; i < std::min(count, (part + 1) * part_size);
         ++i) {
      if (isFinite(points[i])) {
        entries[at++] = {layout.keyOf<Key>(points[i]), static_cast<std::uint32_t>(i)};
      }
    }
  });
  radixSort(entries, layout.bits(), threads);
  return entries;
}

/** \brief The points in the order of the entries, and their rows. */
template <typename Key>
void
fill(const Selection& points,
     const std::vector<Keyed<Key>>& entries,
     const KeyLayout& layout,
     RowIndex& index,
     unsigned threads)
{
  for (auto* array : {&index.x, &index.y, &index.z}) {
    array->resize(entries.size() + row_padding);
  }
  index.order.resize(entries.size() + row_padding);
  parallelForRanges(entries.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const float* p = points[entries[i].index];
      index.order[i] = entries[i].index;
      index.x[i] = p[0];
      index.y[i] = p[1];
      index.z[i] = p[2];
    }
  });
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Key row = layout.rowOf(entries[i].key);
    if (i == 0 || row != layout.rowOf(entries[i - 1].key)) {
      index.rows.push_back(layout.rowAt(row, static_cast<std::uint32_t>(i)));
    }
  }
}

/** \brief Sort a row by x anew. */
void
sortRow(RowIndex& index, std::uint32_t begin, std::uint32_t end)
{
  struct Point {
    float x, y, z;
    std::uint32_t order;
  };
  std::vector<Point> row;
  row.reserve(end - begin);
  for (std::uint32_t i = begin; i < end; ++i) {
    row.push_back({index.x[i], index.y[i], index.z[i], index.order[i]});
  }
  std::stable_sort(
      row.begin(), row.end(), [](const Point& a, const Point& b) { return a.x < b.x; });
  for (std::uint32_t i = begin; i < end; ++i) {
    const Point& p = row[i - begin];
    index.x[i] = p.x;
    index.y[i] = p.y;
    index.z[i] = p.z;
    index.order[i] = p.order;
  }
}

template <typename T>
void
rotateRight(T* first, T* last)
{
  const T moved = *last;
  std::copy_backward(first, last, last + 1);
  *first = moved;
}

/** \brief Sort a row by x. Its points are in order but within a cell: they move a few
 * places. Rows that take more than that (coordinates beyond the cells' range) are
 * sorted anew. */
void
finishRow(RowIndex& index, std::uint32_t begin, std::uint32_t end)
{
  const float* x = index.x.data();
  std::ptrdiff_t moves_left = 16 * std::ptrdiff_t{end - begin} + 64;
  for (std::uint32_t i = begin + 1; i < end; ++i) {
    if (!(x[i] < x[i - 1])) {
      continue;
    }
    std::uint32_t at = i;
    while (at > begin && x[at - 1] > x[i] && moves_left >= 0) {
      --at, --moves_left;
    }
    if (moves_left < 0) {
      sortRow(index, begin, end);
      return;
    }
    for (auto* array : {&index.x, &index.y, &index.z}) {
      rotateRight(array->data() + at, array->data() + i);
    }
    rotateRight(index.order.data() + at, index.order.data() + i);
  }
}

void
finishRows(RowIndex& index, unsigned threads)
{
  constexpr std::size_t rows_a_task = 32;
  const std::size_t tasks = (index.rowCount() + rows_a_task - 1) / rows_a_task;
  parallelFor(tasks, threads, [&](std::size_t task) {
    const std::size_t end = std::min(index.rowCount(), (task + 1) * rows_a_task);
    for (std::size_t row = task * rows_a_task; row < end; ++row) {
      finishRow(index, index.rows[row].begin, index.rows[row + 1].begin);
    }
  });
}

} // namespace

RowIndex
buildRowIndex(const XYZView& points,
              const std::int32_t* indices,
              std::size_t count,
              double edge,
              unsigned threads)
{
  const Selection selection{points, indices};
  RowIndex index;
  index.edge = edge;
  const std::vector<Cells> parts =
      cellsOfParts(selection, count, index.cellsAMetre(), threads);
  Cells all;
  for (const Cells& part : parts) {
    all.merge(part);
  }
  if (all.count > 0) {
    const KeyLayout layout(all, index.cellsAMetre());
    const auto sortBy = [&](auto key) {
      using Key = decltype(key);
      const auto entries = sortedEntries<Key>(selection, parts, count, layout, threads);
      fill(selection, entries, layout, index, threads);
    };
    layout.bits() <= 32 ? sortBy(std::uint32_t{}) : sortBy(std::uint64_t{});
  }
  index.rows.push_back({0, 0, static_cast<std::uint32_t>(all.count), 0});
  finishRows(index, threads);
  makeClusters(index, threads);
  return index;
}

} // namespace pcl::kernels
