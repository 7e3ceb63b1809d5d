// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The feet of obstacles: low points that have others above them.

#include "ground/obstacle_feet.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::segmentation {
namespace {

// Where the points above a foot are, in steps.
constexpr float max_aside = 0.3f;  // 6 cm: straight above, but for noise
constexpr float min_above = 1.0f;  // what is not as high is grass, or a curb
constexpr float max_above = 10.0f; // what is higher may hang over the ground

/** A cell and those directly beside it in its line, from first to last. */
struct Column {
  std::size_t first, last;
};

Column
columnOf(const GroundCells& cells, std::size_t cell)
{
  const auto isBeside = [&](std::size_t a, std::size_t b) {
    return cells.bins[b] == cells.bins[a] + 1; // never so at the end of a line
  };
  return {cell > 0 && isBeside(cell - 1, cell) ? cell - 1 : cell,
          cell + 1 < cells.size() && isBeside(cell, cell + 1) ? cell + 1 : cell};
}

bool
isBeneath(const GroundCells& cells, std::size_t point, const Column& column, float step)
{
  const float x = cells.x[point], y = cells.y[point], z = cells.z[point];
  const float reach = max_aside * max_aside * step * step;
  // Sensors stand upright on sloping ground, or as the ground lies: the column above
  // may lean downhill by up to the ground's slope.
  const float slope = std::hypot(cells.slope_x, cells.slope_y);
  const float downhill = -1.0f / std::max(slope, std::numeric_limits<float>::min());
  const float down_x = downhill * cells.slope_x, down_y = downhill * cells.slope_y;
  constexpr std::size_t block = 64; // the compiler makes vectors of a block
  const std::size_t end = cells.begins[column.last + 1];
  for (std::size_t at = cells.begins[column.first]; at < end; at += block) {
    int found = 0;
    for (std::size_t i = at; i < std::min(end, at + block); ++i) {
      const float dx = cells.x[i] - x, dy = cells.y[i] - y, above = cells.z[i] - z;
      const float down = dx * down_x + dy * down_y;
      const float lean = std::max(0.0f, std::min(down, slope * above));
      found |=
          static_cast<int>(dx * dx + dy * dy - lean * (2.0f * down - lean) < reach) &
          static_cast<int>(above > min_above * step) &
          static_cast<int>(above < max_above * step);
    }
    if (found != 0)
      return true;
  }
  return false;
}

} // namespace

std::vector<char>
feetOf(const GroundCells& cells, float max_step, unsigned threads)
{
  std::vector<float> lowest(cells.size()), highest(cells.size());
  forEachCell(cells, threads, [&](std::size_t i) {
    const auto [low, high] = std::minmax_element(cells.z.begin() + cells.begins[i],
                                                 cells.z.begin() + cells.begins[i + 1]);
    lowest[i] = *low;
    highest[i] = *high;
  });
  std::vector<char> feet(cells.places.size(), 0);
  forEachCell(cells, threads, [&](std::size_t cell) {
    const Column column = columnOf(cells, cell);
    const float low = lowest[cell];
    const float high = *std::max_element(
        highest.begin() + static_cast<std::ptrdiff_t>(column.first),
        highest.begin() + static_cast<std::ptrdiff_t>(column.last) + 1);
    if (high - low <= min_above * max_step)
      return;
    for (std::size_t i = cells.begins[cell]; i < cells.begins[cell + 1]; ++i)
      if (cells.z[i] - low < max_step)
        feet[i] = isBeneath(cells, i, column, max_step);
  });
  return feet;
}

} // namespace pcl::segmentation
