// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The places of a scan: its different points, in the frame of the sensor.

#pragma once

#include <pcl/segmentation/shape_ground_segmentation.h>
#include <pcl/segmentation/impl/ground_likelihoods.hpp>

#include <cstdint>
#include <limits>
#include <vector>

namespace pcl::segmentation {

constexpr std::uint32_t no_place = std::numeric_limits<std::uint32_t>::max();

/** \brief Points of a scan, each once, the sensor at 0, z up: however often a place was
 * measured or written, it counts once. */
struct GroundPlaces {
  std::vector<float> x, y, z;
  /** Of each point in the input; no_place for points that are not finite, and for
   * fillers: what drivers write, at the sensor or at 0, for rays that did not return.
   */
  std::vector<std::uint32_t> of_points;
};

/** \brief Which points are the same place does not depend on their order. \param[in] up
 * of any length but 0 */
GroundPlaces groundPlaces(const detail::GroundQuery& query, const Eigen::Vector3f& up);

} // namespace pcl::segmentation
