/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "run_finder.h"

#include <algorithm>
#include <tuple>

namespace pcl::kernels {
namespace {

/** \brief The first position in [begin, end) whose x is not less than the bound. Looks
 * a few steps around a guess, then bisects. */
std::uint32_t
slide(const float* x,
      std::uint32_t begin,
      std::uint32_t end,
      std::uint32_t guess,
      double bound)
{
  constexpr int steps = 8;
  constexpr std::uint32_t stride = 8;
  std::uint32_t position = guess;
  for (int i = 0; i < steps && position + stride < end && x[position + stride] < bound;
       ++i) {
    position += stride;
  }
  for (std::uint32_t i = 0; i < stride && position < end && x[position] < bound; ++i) {
    ++position;
  }
  for (int i = 0; i < steps && position > begin && x[position - 1] >= bound; ++i) {
    --position;
  }
  const bool is_first = position == begin || x[position - 1] < bound;
  const bool is_enough = position == end || x[position] >= bound;
  if (is_first && is_enough) {
    return position;
  }
  const float* first = is_first ? x + position : x + begin;
  const float* last = is_first ? x + end : x + position;
  return static_cast<std::uint32_t>(
      std::partition_point(first, last, [bound](float v) { return v < bound; }) - x);
}

} // namespace

void
RunFinder::selectRows(const Window& window)
{
  window_ = window;
  rows_.clear();
  cursors_.clear();
  const auto begin = surface_.rows.begin();
  const auto end = surface_.rows.end() - 1;
  auto row = begin;
  std::int32_t iz = window.z_first;
  while (true) {
    row = std::lower_bound(row,
                           end,
                           std::make_tuple(iz, window.y_first),
                           [](const Row& r, const auto& key) {
                             return std::make_tuple(r.iz, r.iy) < key;
                           });
    for (; row != end && row->iz == iz && row->iy <= window.y_last; ++row) {
      rows_.push_back(static_cast<std::uint32_t>(row - begin));
      cursors_.push_back({row->begin, row->begin});
    }
    if (row == end || row->iz > window.z_last || iz == window.z_last) {
      return;
    }
    iz = std::max(row->iz, iz + (row->iz == iz ? 1 : 0));
  }
}

const std::vector<Run>&
RunFinder::find(const Box& box, double reach)
{
  // The squares that decide are rounded to float: reach a little further.
  const double far = reach * (1.0 + 1e-6);
  const double cells = surface_.cellsAMetre();
  const Window window{cellOf(box.z_min - far, cells),
                      cellOf(box.z_max + far, cells),
                      cellOf(box.y_min - far, cells),
                      cellOf(box.y_max + far, cells)};
  const auto key = [](const Window& w) {
    return std::tie(w.z_first, w.z_last, w.y_first, w.y_last);
  };
  if (key(window) != key(window_)) {
    selectRows(window);
  }

  const double x_first = box.x_min - far;
  const double x_last = box.x_max + far;
  const float* x = surface_.x.data();
  runs_.clear();
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const std::uint32_t begin = surface_.rows[rows_[i]].begin;
    const std::uint32_t end = surface_.rows[rows_[i] + 1].begin;
    Run& cursor = cursors_[i];
    cursor.begin = slide(x, begin, end, cursor.begin, x_first);
    cursor.end = slide(x, begin, end, std::max(cursor.begin, cursor.end), x_last);
    if (cursor.begin < cursor.end) {
      runs_.push_back(cursor);
    }
  }
  return runs_;
}

} // namespace pcl::kernels
