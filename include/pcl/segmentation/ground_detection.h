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

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl {

/** \brief What counts as ground. \ingroup segmentation */
struct GroundParameters {
  std::array<float, 3> up{0.0f, 0.0f, 1.0f}; ///< of any length but 0
  float max_slope = 0.35f; ///< of the ground towards "up", radians: 20 degrees
  float max_step = 0.2f;   ///< that ground continues over, metres: a high kerb
};

namespace detail {

/** \brief The points to look for ground among. */
struct GroundQuery {
  XYZView points;
  const std::int32_t* indices = nullptr;         ///< null: all points
  std::size_t size = 0;                          ///< of the indices, or of the points
  std::array<float, 3> origin{0.0f, 0.0f, 0.0f}; ///< the sensor's
  unsigned threads = 0;
};

/** \brief The likelihood of ground at each point, NaN where it is not finite. See
 * doc/ground.md for the steps. */
PCL_SHAPE_EXPORTS std::vector<float>
groundLikelihoods(const GroundQuery& query, const GroundParameters& parameters);

/** \brief What is wrong with parameters: the name, its value, and what is allowed. */
PCL_SHAPE_EXPORTS std::string problemOf(const GroundParameters& parameters);

} // namespace detail
} // namespace pcl
