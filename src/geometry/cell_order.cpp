// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Sorts points by cells: digit by digit of their numbers, if these fit in one word.

#include "geometry/cell_order.h"

#include "common/radix_sort.h"

#include <algorithm>

namespace pcl::segmentation {
namespace {

/** The numbers of cells along an axis, as few bits as hold them. */
struct Axis {
  std::int32_t first;
  int bits;
};

std::array<Axis, 3>
axesOf(const std::vector<CellPoint>& points)
{
  Cell low = points.front().cell, high = low;
  for (const CellPoint& p : points)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], p.cell[axis]);
      high[axis] = std::max(high[axis], p.cell[axis]);
    }
  std::array<Axis, 3> axes{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    axes[axis].first = low[axis];
    for (std::int64_t span = std::int64_t{high[axis]} - low[axis]; span > 0; span >>= 1)
      ++axes[axis].bits;
  }
  return axes;
}

template <typename Key>
void
sortByKey(const std::array<Axis, 3>& axes,
          int bits,
          std::vector<CellPoint>& points,
          unsigned threads)
{
  kernels::RawVector<kernels::Keyed<Key>> entries(points.size());
  kernels::parallelForEach(points.size(), threads, [&](std::size_t i) {
    Key key = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::int64_t number = std::int64_t{points[i].cell[axis]} - axes[axis].first;
      // A shift by all bits is not defined: the key is 0 before it then.
      key = key == 0 ? static_cast<Key>(number)
                     : static_cast<Key>(key << axes[axis].bits | Key(number));
    }
    entries[i] = {key, static_cast<std::uint32_t>(i)};
  });
  kernels::radixSort(entries, bits, threads);
  std::vector<CellPoint> sorted(points.size());
  kernels::parallelForEach(points.size(), threads, [&](std::size_t i) {
    sorted[i] = points[entries[i].index];
  });
  points = std::move(sorted);
}

} // namespace

Cell
cellOf(const float* position, float size)
{
  constexpr float far = 0x1p30f;
  Cell cell;
  for (std::size_t axis = 0; axis < 3; ++axis)
    cell[axis] = floorOf(std::clamp(position[axis] / size, -far, far));
  return cell;
}

void
sortByCell(std::vector<CellPoint>& points, unsigned threads)
{
  if (points.empty())
    return;
  const std::array<Axis, 3> axes = axesOf(points);
  const int bits = axes[0].bits + axes[1].bits + axes[2].bits;
  if (bits <= 32)
    sortByKey<std::uint32_t>(axes, bits, points, threads);
  else if (bits <= 64)
    sortByKey<std::uint64_t>(axes, bits, points, threads);
  else // points far from all others
    std::stable_sort(
        points.begin(), points.end(), [](const CellPoint& a, const CellPoint& b) {
          return a.cell < b.cell;
        });
}

std::vector<std::size_t>
beginsOfCells(const std::vector<CellPoint>& sorted, unsigned threads)
{
  auto begins = kernels::collectForEach<std::size_t>(
      static_cast<std::uint32_t>(sorted.size()),
      threads,
      [&](std::uint32_t i, std::vector<std::size_t>& of_part) {
        if (i == 0 || !areSame(sorted[i].cell, sorted[i - 1].cell))
          of_part.push_back(i);
      });
  begins.push_back(sorted.size());
  return begins;
}

} // namespace pcl::segmentation
