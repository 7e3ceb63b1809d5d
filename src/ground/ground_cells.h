// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The places of a scan, sorted into cells that follow their density.

#pragma once

#include "common/parallel.h"

#include <pcl/segmentation/shape_ground_segmentation.h>
#include <pcl/segmentation/impl/ground_likelihoods.hpp>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace pcl::segmentation {

constexpr std::uint32_t no_place = std::numeric_limits<std::uint32_t>::max();

/** \brief Points of a scan, each once, the sensor at 0, z up: however often a place was
 * measured or written, it counts once. */
struct GroundPlaces {
  std::vector<float> x, y, z;
  /** Of each point in the input; no_place for points that are not finite, and for
   * fillers: what drivers write, at the sensor or at 0, for rays that did not return.
   */
  std::vector<std::uint32_t> of_points;
};

/** \brief Which points are the same place does not depend on their order. \param[in] up
 * of any length but 0 */
GroundPlaces groundPlaces(const detail::GroundQuery& query, const Eigen::Vector3f& up);

/** \brief Cells per octave of the range around a laser: each is 3.3 to 6.1 % of its
 * range deep, as wide as the neighborhoods that normals need. */
constexpr std::uint32_t bins_per_octave = 16;

/** \brief Points in cells of the plane across "up", cells in lines. Around a laser
 * scanner lines are sectors and cells grow with the range, as the distances between its
 * points do; elsewhere cells are squares of one size.
 *
 * Which cell a point is in depends on the points and not on their order. */
struct GroundCells {
  std::vector<std::uint32_t> begins; ///< of each occupied cell in the points, and end
  std::vector<std::uint32_t> bins;   ///< of each occupied cell, its place in its line
  std::vector<std::uint32_t> lines;  ///< the first occupied cell of each line, and end
  std::vector<char> hangs;           ///< of each occupied cell, see overhangsOf()
  bool around = false;               ///< a laser: the last line is beside the first
  bool below_sensor = false;         ///< the plane that z is measured from is
  std::vector<std::uint32_t> places; ///< of the points, each once
  std::vector<float> x, y, z;        ///< of the points, z along "up", meters
  float slope_x = 0.0f, slope_y = 0.0f; ///< of the plane that z is measured from
  float sensor_z = 0.0f;                ///< of the sensor, above that plane
  float extent = 1.0f;                  ///< coordinates are not much larger, meters

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
  constexpr std::size_t lines_per_task = 8;
  const std::size_t lines = cells.lineCount();
  kernels::parallelFor(
      (lines + lines_per_task - 1) / lines_per_task, threads, [&](std::size_t task) {
        const std::size_t last = std::min(lines, (task + 1) * lines_per_task);
        for (std::size_t i = cells.lines[task * lines_per_task]; i < cells.lines[last];
             ++i)
          visit(i);
      });
}

/** \brief Sort places into cells. */
GroundCells groundCells(const GroundPlaces& places, unsigned threads);

} // namespace pcl::segmentation
