// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "sweep/prepared_sweep.h"

#include "common/finite.h"
#include "common/number_text.h"
#include "sweep/index/row_width.h"
#include "sweep/portable/targets.h"

#include <pcl/features/sweep_index.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace pcl {
namespace {

using namespace kernels;

void
checkRadius(double radius)
{
  if (!(radius > 0.0) || !std::isfinite(radius)) {
    throw std::invalid_argument("radius " + detail::numberText(radius) +
                                ": it must be positive and finite (metres)");
  }
}

void
checkSize(const NeighborhoodSize& size, std::size_t queries)
{
  const int given = (size.radius != 0.0) + (size.radii != nullptr) + (size.k != 0);
  if (given != 1) {
    throw std::invalid_argument("set one of radius, radii and k, not " +
                                std::to_string(given) + " of them");
  }
  if (size.radii)
    std::for_each(size.radii, size.radii + queries, checkRadius);
  else if (size.k == 0)
    checkRadius(size.radius);
}

std::size_t
countFinite(const XYZView& points, unsigned threads)
{
  std::atomic<std::size_t> count{0};
  parallelForRanges(points.size, threads, [&](std::size_t begin, std::size_t end) {
    count += kernels::countFinite({points[begin], points.stride, end - begin});
  });
  return count;
}

} // namespace

NeighborhoodSweep::Prepared::Prepared(const NeighborhoodSweep& sweep,
                                      const NeighborhoodSize& size,
                                      Rows rows)
: sweep_(sweep)
{
  constexpr std::size_t most = std::numeric_limits<std::int32_t>::max();
  if (sweep.surface_.size > most || sweep.size() > most)
    throw std::invalid_argument("more than 2^31 - 1 points: split the cloud");
  checkSize(size, sweep.size());
  const std::size_t finite = countFinite(sweep.surface_, sweep.threads_);
  if (size.k > finite) {
    throw std::invalid_argument("k " + std::to_string(size.k) + ": it must be 1 to " +
                                std::to_string(finite) +
                                ", the number of finite points");
  }
  if (sweep.size() == 0 || finite == 0)
    return;
  const bool by_radius = rows == Rows::by_radius && size.radius > 0.0;
  const double edge = by_radius ? rowWidthOf(size.radius)
                                : rowWidth(size, sweep.surface_, sweep.size());
  SweepIndex index;
  surface_ = (sweep.index_ ? *sweep.index_ : index)
                 .rowsOf(sweep.surface_, finite, {edge, by_radius}, sweep.threads_);
  if (sweep.own_queries_ || sweep.has_indices_) {
    own_queries_ = buildRowIndex(sweep.queryPoints(),
                                 sweep.indices_,
                                 sweep.size(),
                                 surface_->edge,
                                 sweep.threads_);
  }
  blocks_.emplace(*surface_, queries(), size, kernels::chosenKernels());
  blocks_->setQueriesOnSurface(!sweep.own_queries_);
  blocks_->setRowsByRadius(by_radius);
}

void
NeighborhoodSweep::Prepared::setNormals(const XYZView& normals)
{
  if (blocks_) {
    normals_ = unitNormals(normals, surface_.get(), sweep_.threads_);
    blocks_->setNormals(normals_);
  }
}

} // namespace pcl
