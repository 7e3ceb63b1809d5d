// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Walks over the queries block by block, each with the surface points around it.

#include "sweep/block_sweep.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace pcl::kernels {
namespace {

/** \brief Float, as pcl::KdTreeFLANN squares it. */
float
squared(double radius)
{
  return static_cast<float>(radius * radius);
}

void
setRadius(SweepBlock& block, float r2)
{
  std::fill_n(block.r2, block.size, r2);
  std::fill_n(block.tie_d2, block.size, -1.0f);
}

/** Whether all values of [begin, end) have the same bits: NaN is as good as a number.
 */
bool
areSame(const float* values, std::uint32_t begin, std::uint32_t end)
{
  return std::all_of(values + begin + 1, values + end, [&](const float& value) {
    return std::memcmp(&value, values + begin, sizeof value) == 0;
  });
}

} // namespace

bool
BlockSweep::repeatsTheOneBefore(std::size_t block) const
{
  const auto& box = queries.clusters.box;
  for (std::size_t axis = 0; block > 0 && axis < 3; ++axis)
    if (box[axis][block] != box[axis + 3][block] ||
        box[axis][block - 1] != box[axis + 3][block - 1] ||
        box[axis][block - 1] != box[axis][block])
      return false;
  const bool has_query_normals = normals && queries_on_surface;
  if (block == 0 || (has_query_normals && &queries != &surface))
    return false;
  const std::uint32_t begin = queries.clusters.begin[block - 1];
  const std::uint32_t end = queries.clusters.begin[block + 1];
  if (has_query_normals)
    for (const auto* coordinates : {&normals->x, &normals->y, &normals->z})
      if (!areSame(coordinates->data(), begin, end))
        return false;
  return !neighborhood.radii ||
         std::all_of(&queries.order[begin], &queries.order[end], [&](std::uint32_t i) {
           return neighborhood.radii[i] == neighborhood.radii[queries.order[begin]];
         });
}

SweepBlock
BlockSweep::queriesOf(std::size_t index) const
{
  SweepBlock block{};
  block.x = surface.x.data();
  block.y = surface.y.data();
  block.z = surface.z.data();
  block.order = surface.order.data();
  block.cluster_begin = surface.clusters.begin.data();
  for (std::size_t side = 0; side < 6; ++side)
    block.cluster_box[side] = surface.clusters.box[side].data();
  block.queries_on_surface = queries_on_surface;
  block.rows_by_radius = rows_by_radius;
  if (normals) {
    block.nx = normals->x.data();
    block.ny = normals->y.data();
    block.nz = normals->z.data();
  }
  const std::uint32_t begin = queries.clusters.begin[index];
  block.size = queries.clusters.begin[index + 1] - begin;
  block.box = boxOf(index);
  // Whole blocks, with what follows the queries: compilers make vectors of them.
  std::copy_n(queries.x.data() + begin, block_size, block.qx);
  std::copy_n(queries.y.data() + begin, block_size, block.qy);
  std::copy_n(queries.z.data() + begin, block_size, block.qz);
  if (normals && &queries == &surface) {
    std::copy_n(block.nx + begin, block_size, block.qnx);
    std::copy_n(block.ny + begin, block_size, block.qny);
    std::copy_n(block.nz + begin, block_size, block.qnz);
  }
  if (neighborhood.k == 0)
    setRadius(block, squared(neighborhood.radius));
  if (neighborhood.radii)
    for (std::size_t i = 0; i < block.size; ++i)
      block.r2[i] = squared(neighborhood.radii[queries.order[begin + i]]);
  return block;
}

Box
BlockSweep::boxOf(std::size_t block) const
{
  const auto& box = queries.clusters.box;
  return {box[0][block],
          box[3][block],
          box[1][block],
          box[4][block],
          box[2][block],
          box[5][block]};
}

BlockSweep::BlockGroup
BlockSweep::groupFrom(std::size_t first, std::size_t end) const
{
  // The runs of a longer group hold clusters that are far from most of its blocks.
  constexpr std::size_t max_blocks = 8;
  constexpr double max_edges = 8.0;
  BlockGroup group{first, first + 1, boxOf(first)};
  while (group.end < std::min(end, first + max_blocks)) {
    const Box next = boxOf(group.end);
    const Box both{std::min(group.box.x_min, next.x_min),
                   std::max(group.box.x_max, next.x_max),
                   std::min(group.box.y_min, next.y_min),
                   std::max(group.box.y_max, next.y_max),
                   std::min(group.box.z_min, next.z_min),
                   std::max(group.box.z_max, next.z_max)};
    const double longest = std::max(
        {both.x_max - both.x_min, both.y_max - both.y_min, both.z_max - both.z_min});
    if (!(longest <= max_edges * queries.edge))
      break;
    group.box = both;
    ++group.end;
  }
  return group;
}

double
BlockSweep::largestRadius(const BlockGroup& group) const
{
  if (!neighborhood.radii)
    return std::sqrt(static_cast<double>(squared(neighborhood.radius)));
  const auto& begin = queries.clusters.begin;
  float largest = 0.0f;
  for (std::uint32_t i = begin[group.begin]; i < begin[group.end]; ++i)
    largest = std::max(largest, squared(neighborhood.radii[queries.order[i]]));
  return std::sqrt(static_cast<double>(largest));
}

bool
BlockSweep::findNearest(SweepBlock& block, RunFinder& finder, double& reach) const
{
  const KernelTable& kernels = chosenKernels();
  constexpr double step = 1.5; // about twice the points of a surface
  // After a stray, far from all others, the next block must not hold the whole cloud:
  // five steps from the edge of a cell, and few blocks need more.
  constexpr double max_reach_edges = 8.0;
  const double most = std::max(max_reach_edges * queries.edge, step * reach);
  bool is_far_enough = true;
  setRadius(block, squared(reach));
  // Beyond the largest float every distance has been looked at.
  while (!kernels.nearest(block, neighborhood.k) && !std::isinf(squared(reach))) {
    is_far_enough = false;
    reach *= step;
    const auto& runs = finder.find(block.box, reach);
    block.runs = runs.data();
    block.run_count = runs.size();
    setRadius(block, squared(reach));
  }
  float largest = 0.0f;
  for (std::size_t i = 0; i < block.size; ++i)
    if (std::isfinite(block.kth_d2[i]))
      largest = std::max(largest, block.kth_d2[i]);
  // Seldom too short for the next block; not 0, which would never grow.
  reach = std::clamp(
      1.1 * std::sqrt(static_cast<double>(largest)), 1e-3 * queries.edge, most);
  return is_far_enough;
}

} // namespace pcl::kernels
