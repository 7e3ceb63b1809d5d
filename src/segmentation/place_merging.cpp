/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "place_merging.h"

#include "point_grid.h"

#include <algorithm>

namespace pcl::segmentation {

std::vector<std::size_t>
representativesOf(const std::vector<Place>& places, float radius)
{
  constexpr float same_direction = 0.7071f; // cosine of 45 degrees
  const XYZView positions{places.empty() ? nullptr : places[0].position.data(),
                          sizeof(Place) / sizeof(float),
                          places.size()};
  const PointGrid grid(positions, radius);
  std::vector<std::size_t> representatives;
  representatives.reserve(places.size());
  for (std::size_t p = 0; p < places.size(); ++p) {
    std::size_t best = p;
    grid.forEachWithin(places[p].position, radius, [&](std::uint32_t other, float) {
      if (other < best && representatives[other] == other &&
          places[other].normal.dot(places[p].normal) > same_direction)
        best = other;
    });
    representatives.push_back(best);
  }
  return representatives;
}

} // namespace pcl::segmentation
