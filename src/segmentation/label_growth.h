/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include "surface_graph.h"

namespace pcl::segmentation {

/** \brief How labels spread to points without one. */
struct Growth {
  std::vector<char> open; ///< which points may take a label
  bool fitting = true;    ///< only where the surface goes on
};

/** \brief Give labels to the open points around labelled ones, round by round, as far
 * as an edge's band is wide. Of the labels around, a point takes the one whose surface,
 * continued, passes nearest to it. */
void growLabels(const detail::InstanceInput& input,
                const PointGrid& grid,
                const Growth& growth,
                Labels& labels);

} // namespace pcl::segmentation
