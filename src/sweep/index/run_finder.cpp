// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Finds the runs of clusters that lie within a distance of a box.

#include "sweep/index/run_finder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace pcl::kernels {
namespace {

/** \brief The first position in [begin, end) whose value is not less than the bound.
 * Looks around a guess, then bisects. block_size values behind the last may be read. */
std::uint32_t
slide(const KernelTable& kernels,
      const float* values,
      std::uint32_t begin,
      std::uint32_t end,
      std::uint32_t guess,
      float bound)
{
  // Bounds of the next box mostly are a few clusters further, seldom nearer.
  constexpr std::uint32_t window = block_size, steps_back = 6;
  const bool is_short = end - begin <= window;
  const std::uint32_t first =
      is_short || guess - begin <= steps_back ? begin : guess - steps_back;
  const std::uint32_t count = std::min(end - first, window);
  // Without branches: how far the bound has moved cannot be predicted.
  const std::uint32_t less = kernels.countLess(values + first, count, bound);
  const bool is_after_first = less > 0 || first == begin;
  const bool is_before_last = less < count || first + count == end;
  if (is_after_first && is_before_last)
    return first + less;
  const float* from = is_after_first ? values + first + count : values + begin;
  const float* to = is_after_first ? values + end : values + first;
  return static_cast<std::uint32_t>(
      std::partition_point(from, to, [bound](float v) { return v < bound; }) - values);
}

/** \brief By how much intervals are apart, 0 if they overlap. */
double
distance(double a_min, double a_max, double b_min, double b_max)
{
  return std::max({0.0, b_min - a_max, a_min - b_max});
}

/** Of coordinates' cells, in cells: far more than it is, far less than costs time. */
constexpr double rounding = 1e-5;

/** \brief The bounds of a cell, a little further out than rounding may put its points.
 */
double
lowerBound(std::int32_t cell, double edge)
{
  return cell <= -max_cell ? -std::numeric_limits<double>::infinity()
                           : (cell - rounding) * edge;
}

double
upperBound(std::int32_t cell, double edge)
{
  return cell >= max_cell ? std::numeric_limits<double>::infinity()
                          : (cell + 1.0 + rounding) * edge;
}

/** \brief As a float, not less far that way (1 or -1): rounding moves it by at most
 * 2^-24 of it, or half the smallest positive float. */
float
roundedOutwards(double value, double way)
{
  constexpr double min = std::numeric_limits<float>::denorm_min();
  return static_cast<float>(value + way * (0x1p-23 * std::abs(value) + min));
}

} // namespace

/** The window of the box's own rows, so that it stays the same along them. */
RunFinder::Window
RunFinder::windowOf(const Box& box, double far) const
{
  const double cells = surface_.cellsPerMeter();
  // From one end of the cells to the other, if need be.
  const double steps =
      std::floor(std::min(2.0 * max_cell, far * cells + rounding)) + 1.0;
  const auto reach = static_cast<std::int64_t>(steps);
  const auto cell = [&](float v, std::int64_t offset) {
    const std::int64_t moved = cellOf(v, cells) + offset;
    return static_cast<std::int32_t>(
        std::clamp<std::int64_t>(moved, -max_cell, max_cell));
  };
  return {cell(box.z_min, -reach),
          cell(box.z_max, reach),
          cell(box.y_min, -reach),
          cell(box.y_max, reach)};
}

void
RunFinder::selectRows(const Window& window)
{
  window_ = window;
  rows_.clear();
  const auto end = surface_.rows.end() - 1;
  auto row = surface_.rows.begin();
  const double edge = surface_.edge;
  std::int32_t iz = window.z_first;
  while (true) {
    row = std::lower_bound(row,
                           end,
                           std::make_tuple(iz, window.y_first),
                           [](const Row& r, const auto& key) {
                             return std::make_tuple(r.iz, r.iy) < key;
                           });
    for (; row != end && row->iz == iz && row->iy <= window.y_last; ++row) {
      rows_.push_back({lowerBound(row->iy, edge),
                       upperBound(row->iy, edge),
                       lowerBound(row->iz, edge),
                       upperBound(row->iz, edge),
                       row->first_cluster,
                       row[1].first_cluster,
                       {row->first_cluster, row->first_cluster, row->iz}});
    }
    if (row == end || row->iz > window.z_last || iz == window.z_last)
      return;
    iz = std::max(row->iz, iz + (row->iz == iz ? 1 : 0));
  }
}

const std::vector<ClusterRun>&
RunFinder::find(const Box& box, double reach)
{
  // The squares that decide are rounded to float: reach a little further.
  const double far = reach * (1.0 + 1e-6);
  const Window window = windowOf(box, far);
  const auto key = [](const Window& w) {
    return std::tie(w.z_first, w.z_last, w.y_first, w.y_last);
  };
  if (key(window) != key(window_))
    selectRows(window);

  const float x_first = roundedOutwards(box.x_min - far, -1.0);
  const float x_last = roundedOutwards(box.x_max + far, 1.0);
  const float* x_min = surface_.clusters.box[0].data();
  const float* x_max = surface_.clusters.box[3].data();
  runs_.clear();
  for (NearRow& row : rows_) {
    const double dy = distance(row.y_min, row.y_max, box.y_min, box.y_max);
    const double dz = distance(row.z_min, row.z_max, box.z_min, box.z_max);
    if (dy * dy + dz * dz > far * far)
      continue;
    ClusterRun& run = row.cursor;
    run.begin = slide(kernels_, x_max, row.begin, row.end, run.begin, x_first);
    run.end = slide(
        kernels_, x_min, row.begin, row.end, std::max(run.begin, run.end), x_last);
    if (run.begin < run.end)
      runs_.push_back(run);
  }
  return runs_;
}

} // namespace pcl::kernels
