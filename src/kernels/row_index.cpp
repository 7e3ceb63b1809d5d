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

/** \brief Keys of (z cell, y cell, x cell): 64 bits, of which x gets what the others
 * leave. */
class KeyMaker {
public:
  KeyMaker(const Cells& all, double cells_a_metre)
  : all_(all)
  , cells_a_metre_(cells_a_metre)
  , y_bits_(all.y.bits())
  , x_bits_(std::min(all.x.bits(), 64 - y_bits_ - all.z.bits()))
  , x_shift_(all.x.bits() - x_bits_)
  {}

  int
  bits() const
  {
    return x_bits_ + y_bits_ + all_.z.bits();
  }

  std::uint64_t
  keyOf(const float* p) const
  {
    const std::uint64_t x =
        offset(cellOf(p[0], x_cells_an_edge * cells_a_metre_), all_.x);
    const std::uint64_t y = offset(cellOf(p[1], cells_a_metre_), all_.y);
    const std::uint64_t z = offset(cellOf(p[2], cells_a_metre_), all_.z);
    return (((z << y_bits_) | y) << x_bits_) | (x >> x_shift_);
  }

  std::uint64_t
  rowOf(std::uint64_t key) const
  {
    return key >> x_bits_;
  }

  Row
  rowAt(std::uint64_t row, std::uint32_t begin) const
  {
    const std::uint64_t y = row & ((std::uint64_t{1} << y_bits_) - 1);
    return {static_cast<std::int32_t>(static_cast<std::int64_t>(row >> y_bits_) +
                                      all_.z.first),
            static_cast<std::int32_t>(static_cast<std::int64_t>(y) + all_.y.first),
            begin};
  }

private:
  static std::uint64_t
  offset(std::int32_t cell, const CellRange& range)
  {
    return static_cast<std::uint64_t>(std::int64_t{cell} - range.first);
  }

  const Cells& all_;
  double cells_a_metre_;
  int y_bits_, x_bits_, x_shift_;
};

KeyedIndices
sortedEntries(const Selection& points,
              const std::vector<Cells>& parts,
              std::size_t count,
              const Cells& all,
              const KeyMaker& keys,
              unsigned threads)
{
  std::vector<std::size_t> begins(parts.size() + 1, 0);
  for (std::size_t part = 0; part < parts.size(); ++part) {
    begins[part + 1] = begins[part] + parts[part].count;
  }
  KeyedIndices entries;
  entries.keys.resize(all.count);
  entries.indices.resize(all.count);
  parallelFor(parts.size(), threads, [&](std::size_t part) {
    std::size_t at = begins[part];
    for (std::size_t i = part * part_size; i < std::min(count, (part + 1) * part_size);
         ++i) {
      if (isFinite(points[i])) {
        entries.keys[at] = keys.keyOf(points[i]);
        entries.indices[at++] = static_cast<std::uint32_t>(i);
      }
    }
  });
  radixSort(entries, keys.bits(), threads);
  return entries;
}

/** \brief Sort a row by x. Its points are in order but within a cell: they move a few
 * places. Rows that take more than that (coordinates beyond the cells' range) are
 * sorted anew. */
void
sortRow(const Selection& points, std::uint32_t* first, std::uint32_t* last)
{
  const auto x = [&](std::uint32_t i) { return points[i][0]; };
  std::ptrdiff_t moves_left = 16 * (last - first) + 64;
  for (std::uint32_t* i = first + 1; i < last; ++i) {
    const std::uint32_t moved = *i;
    const float moved_x = x(moved);
    std::uint32_t* at = i;
    for (; at > first && x(at[-1]) > moved_x; --at, --moves_left) {
      *at = at[-1];
    }
    *at = moved;
    if (moves_left < 0) {
      std::sort(first, last, [&](std::uint32_t a, std::uint32_t b) {
        return x(a) != x(b) ? x(a) < x(b) : a < b;
      });
      return;
    }
  }
}

void
gather(const Selection& points, RowIndex& index, unsigned threads)
{
  for (auto* array : {&index.x, &index.y, &index.z}) {
    array->resize(index.size() + row_padding);
  }
  constexpr std::size_t rows_a_task = 32;
  const std::size_t tasks = (index.rowCount() + rows_a_task - 1) / rows_a_task;
  parallelFor(tasks, threads, [&](std::size_t task) {
    const std::size_t end = std::min(index.rowCount(), (task + 1) * rows_a_task);
    for (std::size_t row = task * rows_a_task; row < end; ++row) {
      std::uint32_t* order = index.order.data();
      sortRow(points, order + index.rows[row].begin, order + index.rows[row + 1].begin);
    }
  });
  parallelForRanges(index.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const float* p = points[index.order[i]];
      index.x[i] = p[0];
      index.y[i] = p[1];
      index.z[i] = p[2];
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
    const KeyMaker keys(all, index.cellsAMetre());
    KeyedIndices entries = sortedEntries(selection, parts, count, all, keys, threads);
    for (std::size_t i = 0; i < entries.keys.size(); ++i) {
      const std::uint64_t row = keys.rowOf(entries.keys[i]);
      if (i == 0 || row != keys.rowOf(entries.keys[i - 1])) {
        index.rows.push_back(keys.rowAt(row, static_cast<std::uint32_t>(i)));
      }
    }
    index.order = std::move(entries.indices);
  }
  index.rows.push_back({0, 0, static_cast<std::uint32_t>(index.order.size())});
  index.order.resize(index.order.size() + row_padding);
  gather(selection, index, threads);
  return index;
}

} // namespace pcl::kernels
