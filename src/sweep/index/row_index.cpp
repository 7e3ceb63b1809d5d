// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Sorts points into rows, by keys of their cells and then along x, and into clusters.

#include "sweep/index/row_index.h"

#include "common/finite.h"
#include "common/parallel.h"
#include "sweep/portable/targets.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace pcl::kernels {
namespace {

/** Points are first sorted by cells of this fraction of the edge along x: few share
 * one, and the sort within rows moves points a few places only. */
constexpr double x_cells_per_edge = 64.0;

/** More digits of x than these cost more than the sort within the rows. */
constexpr int max_x_bits = 16;

/** Threads take the points by parts of this size. */
constexpr std::size_t part_size = 8192;

/** \brief The points to sort: some of those given, or all. */
struct Selection {
  const XYZView& points;
  const std::int32_t* indices;
  std::size_t size;

  const float*
  operator[](std::size_t i) const
  {
    return points[indices ? static_cast<std::size_t>(indices[i]) : i];
  }
};

/** \brief The finite ones among a few points, as structure of arrays, filled up to
 * whole blocks with the first one. */
struct PointChunk {
  static constexpr std::size_t max_size = 256;

  // One more: what is not finite is written, but not kept.
  float at[3][max_size + block_size];
  std::uint32_t index[max_size + block_size];
  std::size_t count = 0;
  std::size_t padded = 0; ///< `count` rounded up to whole blocks

  /** \brief Those of [begin, end), at most max_size. */
  PointChunk(const Selection& points, std::size_t begin, std::size_t end)
  {
    for (std::size_t i = begin; i < end; ++i) {
      const float* p = points[i];
      index[count] = static_cast<std::uint32_t>(i);
      for (std::size_t axis = 0; axis < 3; ++axis)
        at[axis][count] = p[axis];
      count += isFinite(p) ? 1 : 0;
    }
    padded = (count + block_size - 1) / block_size * block_size;
    for (auto& coordinates : at)
      std::fill(coordinates + count, coordinates + padded, coordinates[0]);
  }
};

/** \brief visit(chunk) for the points of a part. */
template <typename Visit>
void
forEachChunk(const Selection& points, std::size_t part, const Visit& visit)
{
  const std::size_t end = std::min(points.size, (part + 1) * part_size);
  for (std::size_t begin = part * part_size; begin < end; begin += PointChunk::max_size)
    visit(PointChunk(points, begin, std::min(end, begin + PointChunk::max_size)));
}

/** \brief The cells that coordinates are in. */
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
    for (std::int64_t span = std::int64_t{last} - first; span > 0; span >>= 1)
      ++bits;
    return bits;
  }
};

/** \brief The cells that finite points are in, along x, y and z. */
struct Cells {
  CellRange axes[3];
  std::size_t count = 0; ///< of finite points

  void
  merge(const Cells& other)
  {
    count += other.count;
    for (std::size_t axis = 0; other.count > 0 && axis < 3; ++axis) {
      axes[axis].add(other.axes[axis].first);
      axes[axis].add(other.axes[axis].last);
    }
  }
};

/** \brief How many cells a meter has along x, y and z. */
using CellScales = std::array<double, 3>;

/** \brief The range of whole blocks of floats. */
std::pair<float, float>
rangeOf(const float* values, std::size_t count)
{
  float min[block_size], max[block_size];
  std::copy_n(values, block_size, min);
  std::copy_n(values, block_size, max);
  for (std::size_t i = block_size; i < count; i += block_size) {
    for (std::size_t lane = 0; lane < block_size; ++lane) {
      min[lane] = std::min(min[lane], values[i + lane]);
      max[lane] = std::max(max[lane], values[i + lane]);
    }
  }
  return {*std::min_element(min, min + block_size),
          *std::max_element(max, max + block_size)};
}

std::vector<Cells>
cellsOfParts(const Selection& points, const CellScales& scales, unsigned threads)
{
  std::vector<Cells> parts((points.size + part_size - 1) / part_size);
  parallelFor(parts.size(), threads, [&](std::size_t part) {
    Cells cells;
    forEachChunk(points, part, [&](const PointChunk& chunk) {
      cells.count += chunk.count;
      for (std::size_t axis = 0; chunk.count > 0 && axis < 3; ++axis) {
        const auto [min, max] = rangeOf(chunk.at[axis], chunk.padded);
        cells.axes[axis].add(cellOf(min, scales[axis]));
        cells.axes[axis].add(cellOf(max, scales[axis]));
      }
    });
    parts[part] = cells;
  });
  return parts;
}

/** \brief How the bits of a key are shared by (z cell, y cell, x cell). */
class KeyLayout {
public:
  explicit KeyLayout(const Cells& all)
  : first_{all.axes[0].first, all.axes[1].first, all.axes[2].first}
  , y_bits_(all.axes[1].bits())
  , row_bits_(y_bits_ + all.axes[2].bits())
  , x_bits_(std::min({all.axes[0].bits(), max_x_bits, 64 - row_bits_}))
  {
    // Half the bytes to move if there are bits enough.
    constexpr int min_x_bits = 12;
    if (row_bits_ + std::min(x_bits_, min_x_bits) <= 32)
      x_bits_ = std::min(x_bits_, 32 - row_bits_);
    x_shift_ = all.axes[0].bits() - x_bits_;
  }

  int
  bits() const
  {
    return x_bits_ + row_bits_;
  }

  /** \brief The key of a point in these cells. */
  template <typename Key>
  Key
  keyOf(std::int32_t x_cell, std::int32_t y_cell, std::int32_t z_cell) const
  {
    const auto offset = [this](std::int32_t cell, std::size_t axis) {
      return static_cast<Key>(std::int64_t{cell} - first_[axis]);
    };
    const Key x = offset(x_cell, 0), y = offset(y_cell, 1), z = offset(z_cell, 2);
    // A shift by all bits is not defined: there is nothing to shift then.
    const Key row = z == 0 ? y : static_cast<Key>(z << y_bits_) | y;
    return static_cast<Key>((row << x_bits_) | (x >> x_shift_));
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
                                      first_[2]),
            static_cast<std::int32_t>(static_cast<std::int64_t>(y) + first_[1]),
            begin,
            0};
  }

private:
  std::int32_t first_[3];
  int y_bits_, row_bits_, x_bits_, x_shift_;
};

template <typename Key>
RawVector<Keyed<Key>>
sortedEntries(const Selection& points,
              const std::vector<Cells>& parts,
              const CellScales& scales,
              const KeyLayout& layout,
              unsigned threads)
{
  std::vector<std::size_t> begins(parts.size() + 1, 0);
  for (std::size_t part = 0; part < parts.size(); ++part)
    begins[part + 1] = begins[part] + parts[part].count;
  RawVector<Keyed<Key>> entries(begins.back());
  parallelFor(parts.size(), threads, [&](std::size_t part) {
    Keyed<Key>* out = entries.data() + begins[part];
    forEachChunk(points, part, [&](const PointChunk& chunk) {
      std::int32_t cells[3][PointChunk::max_size];
      for (std::size_t axis = 0; axis < 3; ++axis)
        chosenKernels().cells(chunk.at[axis], chunk.padded, scales[axis], cells[axis]);
      for (std::size_t i = 0; i < chunk.count; ++i) {
        *out++ = {layout.keyOf<Key>(cells[0][i], cells[1][i], cells[2][i]),
                  chunk.index[i]};
      }
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

/** \brief Sort a row anew. */
void
sortRow(RowIndex& index, std::uint32_t begin, std::uint32_t end)
{
  std::vector<std::tuple<float, float, float, std::uint32_t>> row;
  row.reserve(end - begin);
  for (std::uint32_t i = begin; i < end; ++i)
    row.emplace_back(index.x[i], index.y[i], index.z[i], index.order[i]);
  std::sort(row.begin(), row.end());
  for (std::uint32_t i = begin; i < end; ++i)
    std::tie(index.x[i], index.y[i], index.z[i], index.order[i]) = row[i - begin];
}

/** \brief Sort a row by x; points of equal x by y, then by z: where they are among
 * those given does not matter. They are in order but within a cell: they move a few
 * places. Rows that take more than that (coordinates beyond the cells' range) are
 * sorted anew. */
void
finishRow(RowIndex& index, std::uint32_t begin, std::uint32_t end)
{
  const auto at = [&](std::uint32_t i) {
    return std::tie(index.x[i], index.y[i], index.z[i]);
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
    const auto move = [&](auto* values) {
      std::rotate(values + place, values + i, values + i + 1);
    };
    for (auto* array : {&index.x, &index.y, &index.z})
      move(array->data());
    move(index.order.data());
  }
}

/** \brief Sort the points of each row by x, y and z. They are sorted by cells of x. */
void
finishRows(RowIndex& index, unsigned threads)
{
  constexpr std::size_t rows_per_task = 32; // some hundred points
  const std::size_t tasks = (index.rowCount() + rows_per_task - 1) / rows_per_task;
  parallelFor(tasks, threads, [&](std::size_t task) {
    const std::size_t end = std::min(index.rowCount(), (task + 1) * rows_per_task);
    for (std::size_t row = task * rows_per_task; row < end; ++row)
      finishRow(index, index.rows[row].begin, index.rows[row + 1].begin);
  });
}

/** \brief Sets where clusters begin. */
void
splitRows(RowIndex& index)
{
  std::vector<std::uint32_t>& begin = index.clusters.begin;
  begin.reserve(index.size() / (block_size / 2) + index.rowCount() + 1);
  const float* x = index.x.data();
  const auto far = static_cast<float>(index.edge);
  for (std::size_t row = 0; row < index.rowCount(); ++row) {
    index.rows[row].first_cluster = static_cast<std::uint32_t>(begin.size());
    const std::uint32_t end = index.rows[row + 1].begin;
    for (std::uint32_t first = index.rows[row].begin; first < end;) {
      begin.push_back(first);
      const std::uint32_t max_end =
          std::min(end, first + static_cast<std::uint32_t>(block_size));
      std::uint32_t last = first + 1;
      // Points far apart would share too large a box.
      if (!(x[max_end - 1] - x[first] > far))
        last = max_end;
      while (last < max_end && !(x[last] - x[last - 1] > far))
        ++last;
      first = last;
    }
  }
  index.rows.back().first_cluster = static_cast<std::uint32_t>(begin.size());
  begin.push_back(static_cast<std::uint32_t>(index.size()));
}

/** \brief The range of at most block_size values, behind which as many may be read. */
void
setRange(const float* values, std::uint32_t count, float& min, float& max)
{
  // Without branches, and with numbers as wide as floats: compilers make vectors of it.
  constexpr std::uint32_t size = block_size;
  float low[size], high[size];
  const float first = values[0];
  for (std::uint32_t i = 0; i < size; ++i) {
    const float value = values[i];
    low[i] = high[i] = i < count ? value : first;
  }
  for (std::uint32_t half = size / 2; half > 0; half /= 2) {
    for (std::uint32_t i = 0; i < half; ++i) {
      low[i] = std::min(low[i], low[i + half]);
      high[i] = std::max(high[i], high[i + half]);
    }
  }
  min = low[0];
  max = high[0];
}

/** \brief Splits the rows into clusters, with the boxes around them. */
void
makeClusters(RowIndex& index, unsigned threads)
{
  splitRows(index);
  Clusters& clusters = index.clusters;
  for (auto& side : clusters.box)
    side.resize(clusters.size() + block_size, nan);
  parallelForRanges(clusters.size(), threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t c = first; c < last; ++c) {
      const std::uint32_t begin = clusters.begin[c], end = clusters.begin[c + 1];
      clusters.box[0][c] = index.x[begin];
      clusters.box[3][c] = index.x[end - 1];
      setRange(
          index.y.data() + begin, end - begin, clusters.box[1][c], clusters.box[4][c]);
      setRange(
          index.z.data() + begin, end - begin, clusters.box[2][c], clusters.box[5][c]);
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
  const Selection selection{points, indices, count};
  RowIndex index;
  index.edge = edge;
  const double scale = index.cellsPerMeter();
  const CellScales scales{x_cells_per_edge * scale, scale, scale};
  const std::vector<Cells> parts = cellsOfParts(selection, scales, threads);
  Cells all;
  for (const Cells& part : parts)
    all.merge(part);
  if (all.count > 0) {
    const KeyLayout layout(all);
    const auto sortBy = [&](auto key) {
      using Key = decltype(key);
      const auto entries =
          sortedEntries<Key>(selection, parts, scales, layout, threads);
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
