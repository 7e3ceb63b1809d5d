/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/features/xyz_view.h>
#include <pcl/pcl_shape_exports.h>

#include <cstdint>
#include <vector>

namespace pcl {

/** \brief The places of points: equal points are at one place, as many as there are.
 *
 * Points that differ by the sign of a zero are equal. A point that is not finite has a
 * place of its own. \ingroup features */
struct DistinctPoints {
  std::vector<std::int32_t> first; ///< at each place the first point, ascending
  std::vector<std::int32_t> place; ///< of each point, a position in `first`

  /** \brief Whether points are equal; if none are, both lists are empty. */
  bool
  hasRepeats() const
  {
    return !place.empty();
  }
};

/** \brief Find points that are equal, in a time that does not depend on how many are.
 */
PCL_SHAPE_EXPORTS DistinctPoints distinctPoints(const XYZView& points);

} // namespace pcl
