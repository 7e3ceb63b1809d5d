// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Streets and other places, and what stands in them.

#pragma once

#include "scene/worlds/street_ground.h"

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

/** \brief Where a scanner may be. */
enum class StreetPlace {
  Town,
  Bumps,   /**< a town with speed bumps, and driveways that fall or rise behind walls */
  Bridge,  /**< a town below a bridge */
  Canopy,  /**< a town below trees */
  Country, /**< grass, ditches, fields and embankments */
  Deck,    /**< the top of a parking deck, the street around it is lower */
  Garage,  /**< a low ceiling on beams and pillars */
  Tunnel,  /**< a road with walls and a ceiling */
  Corridor, /**< narrow, with a ceiling */
  Hall      /**< wide and high, with shelves */
};

/** \brief House fronts with gaps, parked and driving cars, poles, hedges, boxes and
 * people on both sides of a road that rises, bends upwards or downwards and undulates;
 * or what another place has. */
Street randomStreet(std::uint64_t seed, StreetPlace place = StreetPlace::Town);

} // namespace pcl::scene
