// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Fewer points where dense parts of a cloud meet sparse ones.

#include "features/even_sampling.h"

#include "common/finite.h"
#include "geometry/voxel_means.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>

namespace pcl::detail {
namespace {

using Cell = std::array<std::int32_t, 3>;

// Spacings are sorted into levels, two to an octave.
constexpr double levels_per_octave = 2.0;
// A change by more than a factor of 1.4 to 2 over this many spacings of the sparser
// part is a step: neighborhoods are up to 7 spacings wide, on either side of a point.
constexpr double reach_spacings = 6.0;
constexpr int max_level_step = 1;
constexpr std::size_t min_points = 4;  // fewer in a cell are strays
constexpr double voxel_spacings = 0.5; // the mean distance of points at random
constexpr double max_cell = 1 << 30;
constexpr int no_level = std::numeric_limits<int>::min();

double
spacingOf(int level)
{
  return std::exp2(level / levels_per_octave);
}

int
levelOf(float spacing)
{
  return spacing > 0.0f && std::isfinite(spacing)
             ? static_cast<int>(std::floor(levels_per_octave *
                                           std::log2(static_cast<double>(spacing))))
             : no_level;
}

Cell
cellOf(const float* point, double size)
{
  Cell cell{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    cell[axis] = static_cast<std::int32_t>(
        std::clamp(std::floor(point[axis] / size), -max_cell, max_cell));
  return cell;
}

/** The cells that hold enough points of a level, and those around them; sorted. */
std::vector<Cell>
cellsAround(const XYZView& points, const std::vector<std::size_t>& members, double size)
{
  std::vector<Cell> of_points;
  of_points.reserve(members.size());
  for (const std::size_t i : members)
    of_points.push_back(cellOf(points[i], size));
  std::sort(of_points.begin(), of_points.end());
  std::vector<Cell> cells;
  for (std::size_t begin = 0, end = 0; begin < of_points.size(); begin = end) {
    const Cell& cell = of_points[begin];
    while (end < of_points.size() && of_points[end] == cell)
      ++end;
    if (end - begin < min_points)
      continue;
    for (std::int32_t x = -1; x <= 1; ++x)
      for (std::int32_t y = -1; y <= 1; ++y)
        for (std::int32_t z = -1; z <= 1; ++z)
          cells.push_back({cell[0] + x, cell[1] + y, cell[2] + z});
  }
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

/** The level that each point should have: its own, or about that of what is near. */
std::vector<int>
wantedLevels(const XYZView& points, const std::vector<int>& levels)
{
  std::map<int, std::vector<std::size_t>, std::greater<>> members;
  for (std::size_t i = 0; i < levels.size(); ++i)
    if (levels[i] != no_level)
      members[levels[i]].push_back(i);
  std::vector<int> wanted = levels;
  for (const auto& [level, of_level] : members) {
    const double size = reach_spacings * spacingOf(level);
    const std::vector<Cell> cells = cellsAround(points, of_level, size);
    for (std::size_t i = 0; i < levels.size(); ++i)
      if (wanted[i] != no_level && wanted[i] < level - max_level_step &&
          std::binary_search(cells.begin(), cells.end(), cellOf(points[i], size)))
        wanted[i] = level;
  }
  return wanted;
}

} // namespace

std::vector<float>
evenSampling(const XYZView& points, const std::vector<float>& spacings)
{
  std::vector<int> levels(points.size);
  for (std::size_t i = 0; i < points.size; ++i)
    levels[i] = kernels::isFinite(points[i]) ? levelOf(spacings[i]) : no_level;
  const std::vector<int> wanted = wantedLevels(points, levels);
  std::vector<float> even;
  std::map<int, std::vector<float>> too_dense;
  for (std::size_t i = 0; i < points.size; ++i) {
    if (!kernels::isFinite(points[i]))
      continue;
    std::vector<float>& to = wanted[i] == levels[i] ? even : too_dense[wanted[i]];
    to.insert(to.end(), points[i], points[i] + 3);
  }
  for (const auto& [level, positions] : too_dense) {
    const XYZView view{positions.data(), 3, positions.size() / 3};
    const double size = voxel_spacings * spacingOf(level);
    const std::vector<float> means =
        problemOfResolution(size, view).empty() ? voxelMeans(view, size) : positions;
    even.insert(even.end(), means.begin(), means.end());
  }
  return even;
}

} // namespace pcl::detail
