/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "row_index.h"

#include "key_layout.h"
#include "parallel.h"
#include "point_chunk.h"
#include "prefetch.h"
#include "radix_sort.h"
#include "row_order.h"
#include "targets.h"

#include <algorithm>
#include <utility>

namespace pcl::kernels {
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
    if (chunk.count() == 0) {
      return;
    }
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
  for (std::size_t i = 0; i < chunk.count(); ++i) {
    *out++ = {layout.keyOf<Key>(x[i], y[i], z[i]), chunk.index(i)};
  }
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
  for (std::size_t part = 0; part < parts.size(); ++part) {
    begins[part + 1] = begins[part] + parts[part].count;
  }
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
  for (auto* array : {&index.x, &index.y, &index.z}) {
    resizePadded(*array, entries.size());
  }
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
    if (i == 0 || row != layout.rowOf(entries[i - 1].key)) {
      index.rows.push_back(layout.rowAt(row, static_cast<std::uint32_t>(i)));
    }
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
  for (const Cells& part : parts) {
    all.merge(part);
  }
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
