// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// How wide the band of edge points along a crease is.

#pragma once

namespace pcl::segmentation {

/** \brief How far edge points are from their crease, in spacings. Without noise it is
 * two mean distances between points; with noise, the width that INAD can tell apart. */
inline float
edgeBand(double noise)
{
  return 1.02f + 4.0f * static_cast<float>(noise);
}

} // namespace pcl::segmentation
