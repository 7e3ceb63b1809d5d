// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Primitives fitted to the points of instances and faces.

#pragma once

#include "instances/instance_points.h"
#include "instances/primitives/primitives.h"

#include <cstdint>
#include <vector>

namespace pcl::segmentation {

/** \brief Some points of a cloud around an origin, in units of their mean spacing. */
struct SurfaceSample : PrimitiveSample {
  float unit = 0.0f; ///< meters
};

/** \brief At most so many of the members with a normal, evenly in their order.
 * \param[in] members sorted by position: their order in the cloud must not matter to
 * what RANSAC draws */
SurfaceSample sampleOf(const detail::InstanceInput& input,
                       const std::vector<std::uint32_t>& members,
                       std::size_t max_points,
                       const Eigen::Vector3f& origin);

} // namespace pcl::segmentation
