// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// How wide rows of cells should be.

#pragma once

#include <pcl/features/neighborhood_sweep.h>

#include <cstddef>

namespace pcl::kernels {

/** \brief The width of rows. Only the time depends on it, not the results.
 *
 * Wide enough for a cluster of points to be about as long as the row is wide: the
 * distance to the 64th neighbor, where most points are. With larger neighborhoods, rows
 * may be wider: fewer of them are to be looked at. Both were measured on depth images.
 * One point of the surface at least is finite, and there is a query.
 */
double
rowWidth(const NeighborhoodSize& size, const XYZView& surface, std::size_t queries);

/** \brief A width that follows from the radius alone, whatever the points. */
inline double
rowWidthOf(double radius)
{
  constexpr double radii_per_row = 0.85; // the fastest on depth images
  return radii_per_row * radius;
}

} // namespace pcl::kernels
