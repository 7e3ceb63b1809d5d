/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "ground_votes.h"

#include <algorithm>
#include <cmath>

namespace pcl::segmentation {
namespace {

constexpr int most_hops = 24; // to the ground before and behind what hides it

struct Votes {
  std::size_t patches = 0, low = 0, high = 0;
};

} // namespace

bool
addLowSets(const GroundCells& cells,
           const GroundPatches& all,
           const CoarseGround* coarse,
           float max_step,
           std::vector<Rest>& rest,
           std::vector<char>& ground)
{
  const auto isLow = [&](std::size_t base, std::size_t patch) {
    const GroundPatch &a = all.patches[base], &b = all.patches[patch];
    return coarse ? std::abs(coarse->rise(base, patch)) <= mostRise(a, b, max_step)
                  : continues(a, b, max_step);
  };
  std::vector<Votes> votes(ground.size());
  for (const auto& [patch, line, set] : rest) {
    ++votes[set].patches;
    const std::uint32_t bin = cells.bins[patch];
    for (const std::int32_t base :
         {nextMarked(all.neighbors, ground, patch, Inner, most_hops),
          nextMarked(all.neighbors, ground, patch, Outer, most_hops),
          markedAside(cells, ground, line, bin, false, most_hops),
          markedAside(cells, ground, line, bin, true, most_hops)})
      if (base != no_patch)
        ++(isLow(static_cast<std::size_t>(base), patch) ? votes[set].low
                                                        : votes[set].high);
  }
  const auto isGround = [&](const Rest& one) {
    const Votes& of_set = votes[one.set];
    return of_set.patches >= least_patches && of_set.low > of_set.high;
  };
  for (const Rest& one : rest)
    ground[one.patch] = isGround(one);
  const std::size_t before = rest.size();
  rest.erase(std::remove_if(rest.begin(), rest.end(), isGround), rest.end());
  return rest.size() < before;
}

} // namespace pcl::segmentation
