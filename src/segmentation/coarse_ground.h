/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include "ground_patches.h"

namespace pcl::segmentation {

/** \brief The ground around a laser in the large: a plane for each octave of the range,
 * fitted to patches that are ground, most of them. */
class CoarseGround {
public:
  CoarseGround(const GroundCells& cells,
               const GroundPatches& all,
               const std::vector<char>& is_level,
               float max_step);

  /** \brief Whether a patch is at the height of the ground there. */
  bool isNear(std::size_t patch) const;

  /** \brief How much higher a patch is than another one, along the ground. */
  double
  rise(std::size_t from, std::size_t to) const
  {
    const Plane& plane = planes_[octaveOf(from)];
    return above(plane, to) - above(plane, from);
  }

private:
  struct Plane {
    double z = 0.0, slope_x = 0.0, slope_y = 0.0;
  };

  double above(const Plane& plane, std::size_t patch) const;

  bool isNear(const Plane& plane, std::size_t patch) const;

  /** To the patches near it, if they are enough. */
  void refit(const std::vector<std::size_t>& patches, Plane& plane) const;

  std::size_t octaveOf(std::size_t patch) const;

  const GroundCells& cells_;
  const GroundPatches& all_;
  float max_step_;
  std::vector<Plane> planes_; ///< from the inside outwards
};

} // namespace pcl::segmentation
