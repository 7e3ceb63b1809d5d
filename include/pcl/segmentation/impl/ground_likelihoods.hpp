/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/features/neighborhood_sweep.h>
#include <pcl/types.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl {

struct GroundParameters;

namespace detail {

/** \brief The points to look for ground among. */
struct GroundQuery {
  XYZView points;
  const pcl::index_t* indices = nullptr; ///< of the points to label
  std::size_t size = 0;                  ///< of the indices
  const float* origin = nullptr;         ///< where the sensor is: x, y, z
  unsigned threads = 0;
};

/** \brief Returns an error message, or an empty string if the query and the parameters
 * are valid. */
PCL_SHAPE_EXPORTS std::string problemOf(const GroundQuery& query,
                                        const GroundParameters& parameters);

/** \brief The likelihood of ground at each index, NaN where the point is not finite.
 * doc/ground.md has the steps. */
PCL_SHAPE_EXPORTS std::vector<float>
groundLikelihoods(const GroundQuery& query, const GroundParameters& parameters);

} // namespace detail
} // namespace pcl
