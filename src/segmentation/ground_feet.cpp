/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "ground_feet.h"

#include <algorithm>
#include <cmath>

namespace pcl::segmentation {
namespace {

constexpr float reach_steps = 0.3f;    // sideways
constexpr float lowest_steps = 0.5f;   // upwards: two rings on the side of a car
constexpr float highest_steps = 10.0f; // what is higher may hang over it

struct Span {
  float low, high;
};

Span
heightsOf(const GroundCells& cells, std::size_t cell)
{
  const auto [low, high] = std::minmax_element(
      cells.z.begin() + cells.begins[cell], cells.z.begin() + cells.begins[cell + 1]);
  return {*low, *high};
}

/** Cells from first to last: one and those directly beside it in its line. */
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
  const float reach = reach_steps * step;
  // What stands leans towards the plane of the ground by nothing to all of its slope.
  const float lean_x = 0.5f * cells.slope_x, lean_y = 0.5f * cells.slope_y;
  const float lean = std::hypot(lean_x, lean_y);
  constexpr std::size_t block = 64; // the compiler makes vectors of a block
  const std::size_t end = cells.begins[column.last + 1];
  for (std::size_t at = cells.begins[column.first]; at < end; at += block) {
    int found = 0;
    for (std::size_t i = at; i < std::min(end, at + block); ++i) {
      const float above = cells.z[i] - z, most = reach + lean * above;
      const float dx = cells.x[i] - x + lean_x * above;
      const float dy = cells.y[i] - y + lean_y * above;
      found |= static_cast<int>(dx * dx + dy * dy < most * most) &
               static_cast<int>(above > lowest_steps * step) &
               static_cast<int>(above < highest_steps * step);
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
  std::vector<Span> heights(cells.size());
  forEachCell(cells, threads, [&](std::size_t i) { heights[i] = heightsOf(cells, i); });
  std::vector<char> feet(cells.positions.size(), 0);
  forEachCell(cells, threads, [&](std::size_t cell) {
    const Column column = columnOf(cells, cell);
    float high = heights[cell].high;
    for (std::size_t i = column.first; i <= column.last; ++i)
      high = std::max(high, heights[i].high);
    const float low = heights[cell].low;
    if (high - low <= lowest_steps * max_step)
      return;
    for (std::size_t i = cells.begins[cell]; i < cells.begins[cell + 1]; ++i)
      if (cells.z[i] - low < max_step)
        feet[i] = isBeneath(cells, i, column, max_step);
  });
  return feet;
}

} // namespace pcl::segmentation
