// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What hangs above the ground: ceilings, bridges, canopies.

#include "ground/overhangs.h"

#include "ground/ground_patches.h"

#include <cmath>

namespace pcl::segmentation {
namespace {

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
