// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A street and what stands in it.

#pragma once

#include "scene/street_ground.h"

#include <cstdint>
#include <vector>

namespace pcl::scene {

/** \brief A street with what stands in it, in the sensor's frame. */
struct Street {
  explicit Street(const StreetProfile& profile) : ground(profile) {}

  StreetGround ground;
  std::vector<Solid> solids;
  std::vector<std::uint32_t> instances; /**< of each solid: a car is several */
  std::uint32_t objects = 0;            /**< instances 1 to this */
};

/** \brief House fronts with gaps, parked and driving cars, poles, hedges, boxes and
 * people on both sides of a road that rises, bends upwards or downwards and undulates.
 */
Street randomStreet(std::uint64_t seed);

} // namespace pcl::scene
