// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The points of a cloud that are near some of them.

#include "features/spacing/points_near.h"

#include "common/finite.h"
#include "common/parallel.h"
#include "geometry/cells_around.h"
#include "geometry/point_grid.h"

#include <algorithm>

namespace pcl::detail {

PointsNear::PointsNear(const XYZView& points,
                       const pcl::Indices& some,
                       double reach,
                       int cells,
                       unsigned threads)
{
  if (some.empty())
    return;
  segmentation::CellsAround around(reach, cells, some.size());
  for (const pcl::index_t i : some)
    around.add(segmentation::positionOf(points, static_cast<std::size_t>(i)));
  indices_ = kernels::collectForEach<pcl::index_t>(
      static_cast<std::uint32_t>(points.size),
      threads,
      [&](std::uint32_t i, pcl::Indices& near) {
        if (around.mayHold(segmentation::positionOf(points, i)) &&
            kernels::isFinite(points[i]))
          near.push_back(static_cast<pcl::index_t>(i));
      });
  for (const pcl::index_t i : some)
    some_.push_back(static_cast<pcl::index_t>(
        std::lower_bound(indices_.begin(), indices_.end(), i) - indices_.begin()));
  positions_ = positionsAt(points, indices_);
}

} // namespace pcl::detail
