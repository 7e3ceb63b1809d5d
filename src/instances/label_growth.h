// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Labels of points: how they spread over edges, and their order.

#pragma once

#include "geometry/point_grid.h"
#include "instances/instance_points.h"

#include <array>
#include <cstdint>
#include <vector>

namespace pcl::segmentation {

/** \brief How labels spread to points without one. */
struct Growth {
  std::vector<char> open; ///< which points may take a label
  bool fitting = true;    ///< only where the surface continues
};

/** \brief Give labels to the open points around labeled ones, round by round, as far as
 * an edge's band is wide. Of the labels around, a point takes the one whose surface,
 * continued, passes nearest to it. */
void growLabels(const detail::InstanceInput& input,
                const PointGrid& grid,
                const Growth& growth,
                Labels& labels);

/** \brief How far away points can influence a point's label by growth, in spacings. */
float growthReach(double noise);

/** \brief The points of a label. */
struct LabelSize {
  std::size_t points = 0;
  std::array<float, 3> first{}; ///< of their positions, in the order of coordinates
};

/** \brief The rank of each label: by the number of points, the most first, ties by the
 * first point; -1 for those with fewer points, or none. */
std::vector<std::int32_t> ranksOf(const std::vector<LabelSize>& labels,
                                  std::size_t min_points);

/** \brief Sort labels by their number of points, the largest first, ties by the first
 * point in the order of coordinates; drop those with fewer points. */
void
sortLabels(const detail::InstanceInput& input, std::size_t min_points, Labels& labels);

} // namespace pcl::segmentation
