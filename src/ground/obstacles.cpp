// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The feet of obstacles, and what hangs above the ground.

#include "ground/obstacles.h"

#include "ground/ground_patches.h"

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

/** The rays to the points of a sector, or line of cells. */
struct Sector {
  const GroundCells& cells;
  std::size_t first, last;   ///< cells
  std::vector<float> slopes; ///< of the rays: heights over ranges

  Sector(const GroundCells& all, std::size_t line)
  : cells(all)
  , first(all.lines[line])
  , last(all.lines[line + 1])
  , slopes(all.begins[last] - all.begins[first])
  {
    constexpr float tiny = std::numeric_limits<float>::min();
    const std::size_t begin = cells.begins[first];
    for (std::size_t i = 0; i < slopes.size(); ++i) {
      const float x = cells.x[begin + i], y = cells.y[begin + i];
      slopes[i] = cells.z[begin + i] / std::max(std::sqrt(x * x + y * y), tiny);
    }
  }

  /** How many rays to the points of some cells are below a slope. */
  std::size_t
  countBelow(float slope, std::size_t from, std::size_t to) const
  {
    const std::size_t begin = cells.begins[first];
    std::uint32_t count = 0;
    for (std::size_t i = cells.begins[from] - begin; i < cells.begins[to] - begin; ++i)
      count += slopes[i] < slope ? 1U : 0U;
    return count;
  }

  float
  lowestOf(std::size_t cell) const
  {
    const auto at = [&](std::size_t i) {
      return slopes.begin() +
             static_cast<std::ptrdiff_t>(cells.begins[i] - cells.begins[first]);
    };
    return *std::min_element(at(cell), at(cell + 1));
  }
};

/** The points near the lowest one of a cell, and how far the farthest point is. */
struct Bottom {
  float z = std::numeric_limits<float>::infinity(), range = 0.0f;
  std::size_t points = 0;

  Bottom(const GroundCells& cells, std::size_t cell, float max_step)
  {
    const std::size_t begin = cells.begins[cell], end = cells.begins[cell + 1];
    float squared = 0.0f;
    for (std::size_t i = begin; i < end; ++i) {
      z = std::min(z, cells.z[i]);
      squared = std::max(squared, cells.x[i] * cells.x[i] + cells.y[i] * cells.y[i]);
    }
    range = std::sqrt(squared);
    for (std::size_t i = begin; i < end; ++i)
      points += cells.z[i] - z < surface_steps * max_step ? 1U : 0U;
  }
};

void
markOverhangs(const Sector& sector, float max_step, std::vector<char>& hangs)
{
  float lowest_beyond = std::numeric_limits<float>::infinity();
  for (std::size_t cell = sector.last; cell-- > sector.first;) {
    const float lowest = sector.lowestOf(cell);
    if (lowest_beyond < lowest) {
      // Beside each other, in one sector, ground may be as different as a curb is high.
      const Bottom bottom(sector.cells, cell, max_step);
      const float slope = lowest - plane_error - max_step / bottom.range;
      const std::size_t beneath = sector.countBelow(slope, cell + 1, sector.last);
      // Wet ground mirrors: rays seem to pass beneath it. Below the sensor others like
      // them that end before it prove that it is ground.
      hangs[cell] =
          beneath > bottom.points &&
          (bottom.z > 0.0f || beneath > sector.countBelow(slope, sector.first, cell));
    }
    lowest_beyond = std::min(lowest_beyond, lowest);
  }
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

std::vector<char>
overhangsOf(const GroundCells& cells, float max_step, unsigned threads)
{
  std::vector<char> hangs(cells.size(), 0);
  if (cells.around)
    kernels::parallelFor(cells.lineCount(), threads, [&](std::size_t line) {
      if (cells.lines[line] < cells.lines[line + 1])
        markOverhangs(Sector(cells, line), max_step, hangs);
    });
  return hangs;
}

} // namespace pcl::segmentation
