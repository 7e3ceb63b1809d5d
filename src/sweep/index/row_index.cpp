// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "sweep/index/row_index.h"

#include "common/parallel.h"
#include "sweep/index/radix_sort.h"
#include "sweep/portable/targets.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace pcl::kernels {
namespace {

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
  for (std::uint32_t i = begin; i < end; ++i)
    row.push_back({{index.x[i], index.y[i], index.z[i]}, index.order[i]});
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
    if (x[i] > x[i - 1] || !(at(i) < at(i - 1)))
      continue;
    std::uint32_t place = i;
    while (place > begin && at(i) < at(place - 1) && moves_left >= 0)
      --place, --moves_left;
    if (moves_left < 0) {
      sortRow(index, begin, end);
      return;
    }
    for (auto* array : {&index.x, &index.y, &index.z})
      rotateRight(array->data() + place, array->data() + i);
    rotateRight(index.order.data() + place, index.order.data() + i);
  }
}

} // namespace

void
finishRows(RowIndex& index, unsigned threads)
{
  constexpr std::size_t rows_a_task = 32;
  const std::size_t tasks = (index.rowCount() + rows_a_task - 1) / rows_a_task;
  parallelFor(tasks, threads, [&](std::size_t task) {
    const std::size_t end = std::min(index.rowCount(), (task + 1) * rows_a_task);
    for (std::size_t row = task * rows_a_task; row < end; ++row)
      finishRow(index, index.rows[row].begin, index.rows[row + 1].begin);
  });
}

namespace {

constexpr std::size_t part_size = 8192;

/** \brief The least and the most of whole blocks of floats. */
std::pair<float, float>
rangeOf(const float* values, std::size_t count)
{
  float least[block_size], most[block_size];
  std::copy_n(values, block_size, least);
  std::copy_n(values, block_size, most);
  for (std::size_t i = block_size; i < count; i += block_size) {
    for (std::size_t lane = 0; lane < block_size; ++lane) {
      least[lane] = std::min(least[lane], values[i + lane]);
      most[lane] = std::max(most[lane], values[i + lane]);
    }
  }
  return {*std::min_element(least, least + block_size),
          *std::max_element(most, most + block_size)};
}

/** \brief The cells that a part's finite points are in. */
Cells
cellsOf(const Selection& points,
        std::size_t begin,
        std::size_t end,
        double cells_a_metre)
{
  Cells cells;
  forEachChunk(points, begin, end, [&](const PointChunk& chunk) {
    if (chunk.count() == 0)
      return;
    const auto add = [&](std::size_t axis, double scale, CellRange& range) {
      const auto [least, most] = rangeOf(chunk.coordinates(axis), chunk.padded());
      range.add(cellOf(least, scale));
      range.add(cellOf(most, scale));
    };
    add(0, x_cells_an_edge * cells_a_metre, cells.x);
    add(1, cells_a_metre, cells.y);
    add(2, cells_a_metre, cells.z);
    cells.count += chunk.count();
  });
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

/** \brief Write the entries of a chunk's points. \return where the next ones go */
template <typename Key>
Keyed<Key>*
writeEntries(const PointChunk& chunk,
             double cells_a_metre,
             const KeyLayout& layout,
             Keyed<Key>* out)
{
  std::int32_t x[PointChunk::most], y[PointChunk::most], z[PointChunk::most];
  const auto setCells = [&](std::size_t axis, double scale, std::int32_t* cells) {
    chosenKernels().cells(chunk.coordinates(axis), chunk.padded(), scale, cells);
  };
  setCells(0, x_cells_an_edge * cells_a_metre, x);
  setCells(1, cells_a_metre, y);
  setCells(2, cells_a_metre, z);
  for (std::size_t i = 0; i < chunk.count(); ++i)
    *out++ = {layout.keyOf<Key>(x[i], y[i], z[i]), chunk.index(i)};
  return out;
}

template <typename Key>
RawVector<Keyed<Key>>
sortedEntries(const Selection& points,
              const std::vector<Cells>& parts,
              std::size_t count,
              double cells_a_metre,
              const KeyLayout& layout,
              unsigned threads)
{
  std::vector<std::size_t> begins(parts.size() + 1, 0);
  for (std::size_t part = 0; part < parts.size(); ++part)
    begins[part + 1] = begins[part] + parts[part].count;
  RawVector<Keyed<Key>> entries(begins.back());
  parallelFor(parts.size(), threads, [&](std::size_t part) {
    Keyed<Key>* out = entries.data() + begins[part];
    const std::size_t end = std::min(count, (part + 1) * part_size);
    forEachChunk(points, part * part_size, end, [&](const PointChunk& chunk) {
      out = writeEntries(chunk, cells_a_metre, layout, out);
    });
  });
  radixSort(entries, layout.bits(), threads);
  return entries;
}

/** \brief The points in the order of the entries, and their rows. */
template <typename Key>
void
fill(const Selection& points,
     const RawVector<Keyed<Key>>& entries,
     const KeyLayout& layout,
     RowIndex& index,
     unsigned threads)
{
  for (auto* array : {&index.x, &index.y, &index.z})
    resizePadded(*array, entries.size());
  resizePadded(index.order, entries.size());
  parallelForRanges(entries.size(), threads, [&](std::size_t begin, std::size_t end) {
    const auto pointAt = [&](std::size_t i) { return points[entries[i].index]; };
    forEachPoint(begin, end, pointAt, [&](std::size_t i, const float* p) {
      index.order[i] = entries[i].index;
      index.x[i] = p[0];
      index.y[i] = p[1];
      index.z[i] = p[2];
    });
  });
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Key row = layout.rowOf(entries[i].key);
    if (i == 0 || row != layout.rowOf(entries[i - 1].key))
      index.rows.push_back(layout.rowAt(row, static_cast<std::uint32_t>(i)));
  }
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
  for (const Cells& part : parts)
    all.merge(part);
  if (all.count > 0) {
    const KeyLayout layout(all);
    const auto sortBy = [&](auto key) {
      using Key = decltype(key);
      const auto entries = sortedEntries<Key>(
          selection, parts, count, index.cellsAMetre(), layout, threads);
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
