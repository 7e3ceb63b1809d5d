/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "ground_planes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::segmentation {
namespace {

// Points nearer to a line than 1/100 of their distances do not tell a plane.
constexpr float least_determinant = 1e-4f;
constexpr float turn = 0.01f; // that a plane may be off, per metre
// By how much ground may leave its own plane, per metre: 0.6 m at 20 m, as on a crest
// with a radius of 330 m.
constexpr float bend = 0.03f;

/** How steep the way from a patch to another one is. */
float
steepness(const GroundPatch& from, const GroundPatch& to)
{
  return std::abs(to.low - from.low) /
         std::max(std::hypot(to.x - from.x, to.y - from.y),
                  std::numeric_limits<float>::min());
}

/** Of the neighbors on opposite sides the one that is reached less steeply: where the
 * surface ends on one side, the other one still tells its slope. */
const GroundPatch*
levelOne(const std::vector<GroundPatch>& low,
         const GroundPatch& patch,
         std::int32_t one,
         std::int32_t other)
{
  const auto at = [&](std::int32_t i) {
    return i == no_patch ? nullptr : &low[static_cast<std::size_t>(i)];
  };
  const GroundPatch *a = at(one), *b = at(other);
  if (!a || !b)
    return a ? a : b;
  return steepness(patch, *a) <= steepness(patch, *b) ? a : b;
}

} // namespace

float
mostRise(const GroundPatch& a, const GroundPatch& b, float max_step)
{
  return max_step + bend * std::hypot(b.x - a.x, b.y - a.y);
}

bool
continues(const GroundPatch& a, const GroundPatch& b, float max_step)
{
  return std::abs(a.above(b.x, b.y, b.z)) <= mostRise(a, b, max_step);
}

bool
fitPlane(GroundPatch& patch,
         const GroundPatch* const* others,
         std::size_t count,
         float prior_weight)
{
  // Around the patch: the plane need not go through it.
  float n = 1.0f, x = 0.0f, y = 0.0f, z = 0.0f;
  float xx = 0.0f, xy = 0.0f, yy = 0.0f, xz = 0.0f, yz = 0.0f;
  for (std::size_t i = 0; i < count; ++i) {
    const float dx = others[i]->x - patch.x, dy = others[i]->y - patch.y;
    const float dz = others[i]->low - patch.low;
    n += 1.0f;
    x += dx, y += dy, z += dz;
    xx += dx * dx, xy += dx * dy, yy += dy * dy;
    xz += dx * dz, yz += dy * dz;
  }
  x /= n, y /= n, z /= n;
  xx = xx / n - x * x + prior_weight;
  yy = yy / n - y * y + prior_weight;
  xy = xy / n - x * y;
  xz = xz / n - x * z + prior_weight * patch.slope_x;
  yz = yz / n - y * z + prior_weight * patch.slope_y;
  const float determinant = xx * yy - xy * xy;
  if (!(determinant > least_determinant * (xx + yy) * (xx + yy)))
    return false;
  patch.slope_x = (xz * yy - yz * xy) / determinant;
  patch.slope_y = (yz * xx - xz * xy) / determinant;
  patch.z = patch.low + z - patch.slope_x * x - patch.slope_y * y;
  return true;
}

bool
fitRobustly(const std::vector<GroundPatch>& low,
            const PatchNeighbors& neighbors,
            float near,
            GroundPatch& patch)
{
  const GroundPatch* const along =
      levelOne(low, patch, neighbors[Inner], neighbors[Outer]);
  const GroundPatch* const across =
      levelOne(low, patch, neighbors[Right], neighbors[Left]);
  if (!across)
    return false;
  const float weight = along ? 0.0f : prior_weight;
  std::array<const GroundPatch*, 4> others{across, along};
  if (!fitPlane(patch, others.data(), along ? 2 : 1, weight))
    return false;
  std::size_t count = 0;
  for (const std::int32_t neighbor : neighbors) {
    if (neighbor == no_patch)
      continue;
    const GroundPatch& other = low[static_cast<std::size_t>(neighbor)];
    const float distance = std::abs(other.x - patch.x) + std::abs(other.y - patch.y);
    if (std::abs(patch.above(other.x, other.y, other.low)) < near + turn * distance)
      others[count++] = &other;
  }
  fitPlane(patch, others.data(), count, weight);
  return true;
}

} // namespace pcl::segmentation
