// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Keeps the sorted points of a surface from one computation to the next.

#include "common/parallel.h"
#include "sweep/index/row_index.h"

#include <pcl/features/sweep_index.h>

#include <atomic>

namespace pcl {
namespace {

using namespace kernels;

/** \brief Rows may be this many times as wide, or as narrow, as they are to be: it
 * takes less longer than sorting. */
constexpr double max_times_wider = 4.0, max_times_narrower = 1.7;

bool
areEqual(const RowIndex& rows, const XYZView& points, unsigned threads)
{
  std::atomic<bool> are_equal{true};
  parallelForRanges(rows.size(), threads, [&](std::size_t begin, std::size_t end) {
    unsigned differing = 0;
    const auto pointAt = [&](std::size_t i) { return points[rows.order[i]]; };
    forEachPoint(begin, end, pointAt, [&](std::size_t i, const float* p) {
      // Bits, not conditions: which would be branches.
      differing |= unsigned{rows.x[i] != p[0]} | unsigned{rows.y[i] != p[1]} |
                   unsigned{rows.z[i] != p[2]};
    });
    if (differing != 0)
      are_equal = false;
  });
  return are_equal;
}

} // namespace

void
SweepIndex::clear()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  rows_.reset();
}

std::size_t
SweepIndex::getSortCount() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return sort_count_;
}

std::shared_ptr<const RowIndex>
SweepIndex::keptFor(const XYZView& points,
                    std::size_t finite_points,
                    const RowWidth& width)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!rows_ || points_ != points.size || rows_->size() != finite_points)
    return nullptr;
  const bool fits = width.is_exact
                        ? rows_->edge == width.width
                        : rows_->edge <= max_times_wider * width.width &&
                              rows_->edge * max_times_narrower >= width.width;
  return fits ? rows_ : nullptr;
}

std::shared_ptr<const RowIndex>
SweepIndex::rowsOf(const XYZView& points,
                   std::size_t finite_points,
                   const RowWidth& width,
                   unsigned threads)
{
  auto rows = keptFor(points, finite_points, width);
  if (rows && areEqual(*rows, points, threads))
    return rows;
  // Not both at a time.
  rows.reset();
  clear();
  rows = std::make_shared<const RowIndex>(
      buildRowIndex(points, nullptr, points.size, width.width, threads));
  const std::lock_guard<std::mutex> lock(mutex_);
  rows_ = rows;
  points_ = points.size;
  ++sort_count_;
  return rows;
}

} // namespace pcl
