/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "ground_patches.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace pcl::segmentation {
namespace {

// A surface is as thick: above the noise, below a low kerb.
constexpr float thickness_steps = 0.25f;
constexpr float paper_bin = 0.157f; // 9 degrees: of 10 bins over 90

/** The mean of the points near the lowest one that carries nothing, if there is one not
 * far above the bottom of the cell. Sums are of whole numbers: the order of the points
 * does not matter. */
std::optional<GroundPatch>
lowestSurface(const GroundCells& cells,
              const std::vector<char>& feet,
              std::size_t cell,
              float max_step)
{
  const std::size_t begin = cells.begins[cell], end = cells.begins[cell + 1];
  constexpr float none = std::numeric_limits<float>::infinity();
  float bottom = none, low = none;
  for (std::size_t i = begin; i < end; ++i) {
    bottom = std::min(bottom, cells.z[i]);
    low = feet[i] ? low : std::min(low, cells.z[i]);
  }
  if (!(low - bottom < max_step))
    return std::nullopt;
  const float unit = cells.extent / (1 << 24), units = 1.0f / unit;
  const auto whole = [units](float value) {
    constexpr float most = 1LL << 40; // of a point that is far beyond all others
    return static_cast<std::int64_t>(std::clamp(value * units, -most, most));
  };
  std::int64_t count = 0, x = 0, y = 0, z = 0;
  for (std::size_t i = begin; i < end; ++i) {
    if (!feet[i] && cells.z[i] - low < thickness_steps * max_step) {
      ++count;
      x += whole(cells.x[i]);
      y += whole(cells.y[i]);
      z += whole(cells.z[i] - low);
    }
  }
  const float share = unit / static_cast<float>(count);
  GroundPatch patch;
  patch.x = static_cast<float>(x) * share;
  patch.y = static_cast<float>(y) * share;
  patch.z = patch.low = low + static_cast<float>(z) * share;
  return patch;
}

struct Normal {
  float x, y, z;
};

Normal
normalOf(const GroundPatch& patch)
{
  const float z = 1.0f / std::sqrt(1.0f + patch.slope_x * patch.slope_x +
                                   patch.slope_y * patch.slope_y);
  return {-patch.slope_x * z, -patch.slope_y * z, z};
}

/** The likelihood of a plane by the angles between its normal and its neighbors', of
 * which the larger half is left out: a surface may end there. Chords stand for the
 * angles: below 30 degrees they differ by a hundredth. */
float
planarLikelihood(const GroundPatches& all,
                 const std::vector<char>& has_plane,
                 std::size_t patch)
{
  const Normal n = normalOf(all.patches[patch]);
  std::array<float, 4> angles{};
  std::size_t count = 0;
  for (const std::int32_t other : all.neighbors[patch]) {
    if (other == no_patch || !has_plane[static_cast<std::size_t>(other)])
      continue;
    const Normal m = normalOf(all.patches[static_cast<std::size_t>(other)]);
    angles[count++] = std::sqrt((n.x - m.x) * (n.x - m.x) + (n.y - m.y) * (n.y - m.y) +
                                (n.z - m.z) * (n.z - m.z));
  }
  if (count == 0)
    return 0.0f;
  std::sort(angles.begin(), angles.begin() + static_cast<std::ptrdiff_t>(count));
  const std::size_t half = (count + 1) / 2;
  const float mean = std::accumulate(angles.begin(), angles.begin() + half, 0.0f) /
                     static_cast<float>(half);
  const float bins = mean / paper_bin;
  return 1.0f / (1.0f + bins * bins);
}

} // namespace

GroundPatches
groundPatches(const GroundCells& cells,
              const std::vector<char>& feet,
              const GroundParameters& parameters,
              unsigned threads)
{
  GroundPatches all;
  all.patches.resize(cells.size());
  std::vector<GroundPatch> low(cells.size());
  std::vector<char> has_surface(cells.size()), has_plane(cells.size());
  forEachCell(cells, threads, [&](std::size_t i) {
    const auto found = lowestSurface(cells, feet, i, parameters.max_step);
    has_surface[i] = found.has_value();
    low[i] = found.value_or(GroundPatch());
  });
  all.neighbors = patchNeighbors(cells, has_surface, threads);
  forEachCell(cells, threads, [&](std::size_t i) {
    all.patches[i] = low[i];
    has_plane[i] = has_surface[i] && fitRobustly(low,
                                                 all.neighbors[i],
                                                 thickness_steps * parameters.max_step,
                                                 all.patches[i]);
  });
  forEachCell(cells, threads, [&](std::size_t i) {
    all.patches[i].planar = has_plane[i] ? planarLikelihood(all, has_plane, i) : 0.0f;
  });
  return all;
}

} // namespace pcl::segmentation
