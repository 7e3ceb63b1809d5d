// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "sweep/block_sweep.h"

#include <algorithm>
#include <cmath>

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

} // namespace

BlockSweep::BlockSweep(const RowIndex& surface,
                       const RowIndex& queries,
                       const NeighborhoodSize& neighborhood,
                       const KernelTable& kernels)
: surface_(surface)
, queries_(queries)
, neighborhood_(neighborhood)
, kernels_(kernels)
{}

SweepBlock
BlockSweep::queriesOf(std::size_t index) const
{
  SweepBlock block{};
  block.x = surface_.x.data();
  block.y = surface_.y.data();
  block.z = surface_.z.data();
  block.order = surface_.order.data();
  block.cluster_begin = surface_.clusters.begin.data();
  for (std::size_t side = 0; side < 6; ++side)
    block.cluster_box[side] = surface_.clusters.box[side].data();
  block.queries_on_surface = on_surface_;
  block.rows_by_radius = rows_by_radius_;
  if (normals_) {
    block.nx = normals_->x.data();
    block.ny = normals_->y.data();
    block.nz = normals_->z.data();
  }
  const Clusters& clusters = queries_.clusters;
  const std::uint32_t begin = clusters.begin[index];
  block.size = clusters.begin[index + 1] - begin;
  block.box = boxOf(index);
  // A whole block each time, with what follows the queries: compilers make vectors of
  // it.
  std::copy_n(queries_.x.data() + begin, block_size, block.qx);
  std::copy_n(queries_.y.data() + begin, block_size, block.qy);
  std::copy_n(queries_.z.data() + begin, block_size, block.qz);
  if (normals_ && &queries_ == &surface_) {
    std::copy_n(block.nx + begin, block_size, block.qnx);
    std::copy_n(block.ny + begin, block_size, block.qny);
    std::copy_n(block.nz + begin, block_size, block.qnz);
  }
  if (neighborhood_.k == 0)
    setRadius(block, squared(neighborhood_.radius));
  if (neighborhood_.radii)
    for (std::size_t i = 0; i < block.size; ++i)
      block.r2[i] = squared(neighborhood_.radii[queries_.order[begin + i]]);
  return block;
}

Box
BlockSweep::boxOf(std::size_t block) const
{
  const auto& box = queries_.clusters.box;
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
  constexpr std::size_t most_blocks = 8;
  BlockGroup group{first, first + 1, boxOf(first)};
  while (group.end < std::min(end, first + most_blocks)) {
    const Box next = boxOf(group.end);
    const Box both{std::min(group.box.x_min, next.x_min),
                   std::max(group.box.x_max, next.x_max),
                   std::min(group.box.y_min, next.y_min),
                   std::max(group.box.y_max, next.y_max),
                   std::min(group.box.z_min, next.z_min),
                   std::max(group.box.z_max, next.z_max)};
    const double longest = std::max(
        {both.x_max - both.x_min, both.y_max - both.y_min, both.z_max - both.z_min});
    if (!(longest <= 8.0 * queries_.edge))
      break;
    group.box = both;
    ++group.end;
  }
  return group;
}

double
BlockSweep::largestRadius(const BlockGroup& group) const
{
  if (!neighborhood_.radii)
    return std::sqrt(static_cast<double>(squared(neighborhood_.radius)));
  const auto& begin = queries_.clusters.begin;
  float largest = 0.0f;
  for (std::uint32_t i = begin[group.begin]; i < begin[group.end]; ++i)
    largest = std::max(largest, squared(neighborhood_.radii[queries_.order[i]]));
  return std::sqrt(static_cast<double>(largest));
}

bool
BlockSweep::findNearest(SweepBlock& block, RunFinder& finder, double& reach) const
{
  bool is_far_enough = true;
  setRadius(block, squared(reach));
  // Beyond the largest float every distance has been looked at.
  while (!kernels_.nearest(block, neighborhood_.k) && !std::isinf(squared(reach))) {
    is_far_enough = false;
    reach *= 1.5;
    const auto& runs = finder.find(block.box, reach);
    block.runs = runs.data();
    block.run_count = runs.size();
    setRadius(block, squared(reach));
  }
  float largest = 0.0f;
  for (std::size_t i = 0; i < block.size; ++i) {
    largest =
        std::isfinite(block.kth_d2[i]) ? std::max(largest, block.kth_d2[i]) : largest;
  }
  reach = std::max(1.1 * std::sqrt(static_cast<double>(largest)), 1e-3 * queries_.edge);
  return is_far_enough;
}

} // namespace pcl::kernels
