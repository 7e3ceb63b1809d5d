// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include "common/parallel.h"

#include <pcl/segmentation/ground_detection.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace pcl::segmentation {

/** \brief Points in cells of the plane across "up", cells in lines. Around a laser
 * scanner lines are sectors and cells grow with the range, as the distances between its
 * points do; elsewhere cells are squares of one size.
 *
 * Which cell a point is in depends on the points and not on their order. */
struct GroundCells {
  std::vector<std::uint32_t> begins; ///< of each occupied cell in the points, and end
  std::vector<std::uint32_t> bins;   ///< of each occupied cell, its place in its line
  std::vector<std::uint32_t> lines;  ///< the first occupied cell of each line, and end
  bool around = false;               ///< the last line is beside the first
  std::vector<std::uint32_t> positions; ///< of the points in the input
  std::vector<float> x, y, z;           ///< of the points, z along "up", metres
  float slope_x = 0.0f, slope_y = 0.0f; ///< of the plane that z is measured from
  float extent = 1.0f;                  ///< coordinates are not much larger, metres

  std::size_t
  size() const
  {
    return bins.size();
  }

  std::size_t
  lineCount() const
  {
    return lines.size() - 1;
  }
};

/** \brief visit(cell) for all occupied cells, line by line. */
template <typename Visit>
void
forEachCell(const GroundCells& cells, unsigned threads, const Visit& visit)
{
  constexpr std::size_t lines_a_task = 8;
  const std::size_t lines = cells.lineCount();
  kernels::parallelFor(
      (lines + lines_a_task - 1) / lines_a_task, threads, [&](std::size_t task) {
        const std::size_t last = std::min(lines, (task + 1) * lines_a_task);
        for (std::size_t i = cells.lines[task * lines_a_task]; i < cells.lines[last];
             ++i)
          visit(i);
      });
}

/** \brief Sort the finite points into cells. \param[in] up of any length but 0 */
GroundCells groundCells(const detail::GroundQuery& query,
                        const std::array<float, 3>& up);

// A squared range as a float: its exponent and three bits of its mantissa are a scale
// of 8 steps an octave, 16 an octave of the range: cells are 3.3 to 6.1 % of the range
// deep, 4.4 % in the mean.
constexpr int key_shift = 20;
constexpr int keys_an_octave = 8;
constexpr std::uint32_t keys = 1U << (31 - key_shift);
constexpr std::uint32_t no_cell = std::numeric_limits<std::uint32_t>::max();

/** \brief The least squared range of a key. */
float leastOf(std::uint32_t key);

/** \brief The points in the frame of the sensor, z up. */
struct Turned {
  std::vector<float> x, y, z;
  std::vector<std::uint32_t> cells; ///< first the keys of their ranges
};

/** \brief Points that are not finite get no cell. \param[in] direction "up", of any
 * length but 0 */
Turned turned(const detail::GroundQuery& input, const std::array<float, 3>& direction);

/** \brief How many finite points have each key. */
std::vector<std::uint32_t> countKeys(const Turned& points);

/** \brief The key that a share of the points does not exceed. */
std::uint32_t
keyAt(const std::vector<std::uint32_t>& counts, std::uint64_t points, double share);

} // namespace pcl::segmentation
