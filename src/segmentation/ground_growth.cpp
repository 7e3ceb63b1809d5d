/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "ground_growth.h"

#include "disjoint_sets.h"
#include "ground_votes.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace pcl::segmentation {
namespace {

constexpr float least_planar = 0.5f;
constexpr int hops = 3; // over cells that are no ground: a kerb, a pole

std::vector<char>
levelPatches(const GroundCells& cells, const GroundPatches& all, float max_slope)
{
  const float most = std::tan(max_slope) * std::tan(max_slope);
  std::vector<char> level(all.patches.size());
  for (std::size_t i = 0; i < level.size(); ++i) {
    const GroundPatch& p = all.patches[i];
    const float slope_x = p.slope_x + cells.slope_x,
                slope_y = p.slope_y + cells.slope_y;
    level[i] =
        p.planar >= least_planar && slope_x * slope_x + slope_y * slope_y <= most;
  }
  return level;
}

DisjointSets
connect(const GroundPatches& all, const std::vector<char>& level, float max_step)
{
  DisjointSets sets(level.size());
  for (std::size_t i = 0; i < level.size(); ++i) {
    for (const PatchSide side : {Outer, Left, Right}) {
      if (!level[i])
        break;
      const std::int32_t found = nextMarked(all.neighbors, level, i, side, hops);
      if (found == no_patch)
        continue;
      const auto j = static_cast<std::size_t>(found);
      if (continues(all.patches[i], all.patches[j], max_step) &&
          continues(all.patches[j], all.patches[i], max_step))
        sets.unite(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j));
    }
  }
  return sets;
}

/** Around a laser: a ring climbs the side of a car as gently as ground rises, and one
 * ring alone does not tell. What is not near the ground in the large is left out. */
void
levelOut(const CoarseGround& coarse, std::vector<Rest>& rest, std::vector<char>& ground)
{
  for (std::size_t i = 0; i < ground.size(); ++i)
    ground[i] = ground[i] && coarse.isNear(i);
  rest.erase(std::remove_if(rest.begin(),
                            rest.end(),
                            [&](const Rest& one) { return !coarse.isNear(one.patch); }),
             rest.end());
}

void
fitToGround(const GroundPatches& all,
            const std::vector<char>& ground,
            std::size_t cell,
            float max_step,
            GroundPatch& patch)
{
  std::array<const GroundPatch*, 4> others{};
  std::size_t count = 0;
  float slope_x = patch.slope_x, slope_y = patch.slope_y;
  for (const std::int32_t at : all.neighbors[cell]) {
    if (at != no_patch && ground[static_cast<std::size_t>(at)] &&
        continues(patch, all.patches[static_cast<std::size_t>(at)], 0.25f * max_step)) {
      others[count] = &all.patches[static_cast<std::size_t>(at)];
      slope_x += others[count]->slope_x;
      slope_y += others[count]->slope_y;
      ++count;
    }
  }
  patch.slope_x = slope_x / static_cast<float>(count + 1);
  patch.slope_y = slope_y / static_cast<float>(count + 1);
  fitPlane(patch, others.data(), count, prior_weight);
}

} // namespace

std::vector<char>
connectedGround(const GroundCells& cells,
                const GroundParameters& parameters,
                unsigned threads,
                GroundPatches& all)
{
  const std::size_t size = all.patches.size();
  const std::vector<char> level = levelPatches(cells, all, parameters.max_slope);
  DisjointSets sets = connect(all, level, parameters.max_step);
  std::vector<std::size_t> set_of(size, size), sizes(size, 0);
  for (std::size_t i = 0; i < size; ++i)
    if (level[i])
      ++sizes[set_of[i] = sets.find(static_cast<std::uint32_t>(i))];
  const auto largest = std::max_element(sizes.begin(), sizes.end());
  std::vector<char> ground(size, 0);
  if (largest == sizes.end() || *largest < least_patches)
    return ground;
  const auto main = static_cast<std::size_t>(largest - sizes.begin());
  std::vector<Rest> rest;
  for (std::size_t line = 0; line < cells.lineCount(); ++line) {
    for (std::size_t i = cells.lines[line]; i < cells.lines[line + 1]; ++i) {
      ground[i] = set_of[i] == main;
      if (level[i] && !ground[i])
        rest.push_back({i, line, set_of[i]});
    }
  }
  std::optional<CoarseGround> coarse;
  if (cells.around) {
    coarse.emplace(cells, all, level, parameters.max_step);
    levelOut(*coarse, rest, ground);
  }
  while (addLowSets(
      cells, all, coarse ? &*coarse : nullptr, parameters.max_step, rest, ground)) {
  }
  std::vector<GroundPatch> fitted = all.patches;
  forEachCell(cells, threads, [&](std::size_t i) {
    if (ground[i])
      fitToGround(all, ground, i, parameters.max_step, fitted[i]);
  });
  all.patches = std::move(fitted);
  return ground;
}

NearGround
nearGround(const GroundPatches& all, const std::vector<char>& ground, std::size_t cell)
{
  NearGround near;
  if (ground[cell])
    near.patches[near.count++] = static_cast<std::int32_t>(cell);
  for (const PatchSide side : {Inner, Outer, Right, Left}) {
    const std::int32_t found = nextMarked(all.neighbors, ground, cell, side, hops);
    if (found != no_patch)
      near.patches[near.count++] = found;
  }
  return near;
}

} // namespace pcl::segmentation
