// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Tables, floors, shelves: large planes with things before them and nothing behind.

#pragma once

#include "geometry/point_grid.h"
#include "geometry/principal_axes.h"
#include "instances/instance_points.h"

#include <cstdint>
#include <vector>

namespace pcl::segmentation {

/** \brief What things stand on. */
struct Support {
  Plane<float> plane;                ///< the normal is towards the viewpoint
  float offset = 0.0f;               ///< how far its points are off, in spacings
  std::vector<std::uint32_t> points; ///< on it, and on no other one
  /** A little above the plane where things touch it, as cameras smear it there. They
   * are of no object, though they may be of an object's face. */
  std::vector<std::uint32_t> smeared;
  std::vector<std::uint32_t> rim; ///< of its walls: level, beside it
};

/** \brief The supports of a cloud, as wavy as a depth camera makes them.
 * \param[in] members which points may be on one */
std::vector<Support> supportPlanes(const detail::InstanceInput& input,
                                   const PointGrid& grid,
                                   const std::vector<char>& members);

} // namespace pcl::segmentation
