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
#include "key_layout.h"
#include "parallel.h"
#include "radix_sort.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::kernels {
namespace {

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

struct Coordinates {
  float x, y, z;

  bool
  operator<(const Coordinates& b) const
  {
    return x != b.x ? x < b.x : y != b.y ? y < b.y : z < b.z;
  }
};

/** \brief Sort a row anew. */
void
sortRow(RowIndex& index, std::uint32_t begin, std::uint32_t end)
{
  struct Point {
    Coordinates at;
    std::uint32_t order;
  };
  std::vector<Point> row;
  row.reserve(end - begin);
  for (std::uint32_t i = begin; i < end; ++i) {
    row.push_back({{index.x[i], index.y[i], index.z[i]}, index.order[i]});
  }
  std::stable_sort(row.begin(), row.end(), [](const Point& a, const Point& b) {
    return a.at < b.at;
  });
  for (std::uint32_t i = begin; i < end; ++i) {
    const Point& p = row[i - begin];
    index.x[i] = p.at.x;
    index.y[i] = p.at.y;
    index.z[i] = p.at.z;
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

/** \brief Sort a row by x; points of equal x by y, then by z: where they are among
 * those given does not matter. They are in order but within a cell: they move a few
 * places. Rows that take more than that (coordinates beyond the cells' range) are
 * sorted anew. */
void
finishRow(RowIndex& index, std::uint32_t begin, std::uint32_t end)
{
  const auto at = [&](std::uint32_t i) {
    return Coordinates{index.x[i], index.y[i], index.z[i]};
  };
  const float* x = index.x.data();
  std::ptrdiff_t moves_left = 16 * std::ptrdiff_t{end - begin} + 64;
  for (std::uint32_t i = begin + 1; i < end; ++i) {
    if (x[i] > x[i - 1] || !(at(i) < at(i - 1))) {
      continue;
    }
    std::uint32_t place = i;
    while (place > begin && at(i) < at(place - 1) && moves_left >= 0) {
      --place, --moves_left;
    }
    if (moves_left < 0) {
      sortRow(index, begin, end);
      return;
    }
    for (auto* array : {&index.x, &index.y, &index.z}) {
      rotateRight(array->data() + place, array->data() + i);
    }
    rotateRight(index.order.data() + place, index.order.data() + i);
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
