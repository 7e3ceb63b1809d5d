/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "block_sweep.h"

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
{
  splitIntoBlocks();
}

void
BlockSweep::splitIntoBlocks()
{
  for (std::size_t row = 0; row < queries_.rowCount(); ++row) {
    const std::uint32_t end = queries_.rows[row + 1].begin;
    std::uint32_t first = queries_.rows[row].begin;
    blocks_.push_back(first);
    for (std::uint32_t i = first + 1; i < end; ++i) {
      // Points far apart would share too large a box.
      const bool is_gap = queries_.x[i] - queries_.x[i - 1] > queries_.edge;
      if (i - first == block_size || is_gap) {
        blocks_.push_back(i);
        first = i;
      }
    }
  }
  blocks_.push_back(static_cast<std::uint32_t>(queries_.size()));
}

Box
BlockSweep::boxOf(std::size_t block) const
{
  const std::uint32_t begin = blocks_[block], end = blocks_[block + 1];
  const auto range = [begin, end](const std::vector<float>& values) {
    return std::minmax_element(values.begin() + begin, values.begin() + end);
  };
  const auto [y_min, y_max] = range(queries_.y);
  const auto [z_min, z_max] = range(queries_.z);
  return {queries_.x[begin], queries_.x[end - 1], *y_min, *y_max, *z_min, *z_max};
}

SweepBlock
BlockSweep::queriesOf(std::size_t index) const
{
  SweepBlock block{};
  block.x = surface_.x.data();
  block.y = surface_.y.data();
  block.z = surface_.z.data();
  block.order = surface_.order.data();
  block.queries_on_surface = on_surface_;
  if (normals_) {
    block.nx = normals_->x.data();
    block.ny = normals_->y.data();
    block.nz = normals_->z.data();
  }
  const std::uint32_t begin = blocks_[index];
  block.size = blocks_[index + 1] - begin;
  std::copy_n(queries_.x.data() + begin, block.size, block.qx);
  std::copy_n(queries_.y.data() + begin, block.size, block.qy);
  std::copy_n(queries_.z.data() + begin, block.size, block.qz);
  if (neighborhood_.radii) {
    setRadius(block, 0.0f);
    for (std::size_t i = 0; i < block.size; ++i) {
      block.r2[i] = squared(neighborhood_.radii[queries_.order[begin + i]]);
    }
  }
  return block;
}

void
BlockSweep::findCandidates(SweepBlock& block,
                           const Box& box,
                           RunFinder& finder,
                           double& reach) const
{
  if (neighborhood_.k > 0) {
    findNearest(block, box, finder, reach);
    return;
  }
  if (!neighborhood_.radii) {
    setRadius(block, squared(neighborhood_.radius));
  }
  const float largest = *std::max_element(block.r2, block.r2 + block.size);
  const auto& runs = finder.find(box, std::sqrt(static_cast<double>(largest)));
  block.runs = runs.data();
  block.run_count = runs.size();
}

void
BlockSweep::findNearest(SweepBlock& block,
                        const Box& box,
                        RunFinder& finder,
                        double& reach) const
{
  while (true) {
    const auto& runs = finder.find(box, reach);
    block.runs = runs.data();
    block.run_count = runs.size();
    setRadius(block, squared(reach));
    // Beyond the largest float every distance has been looked at.
    if (kernels_.nearest(block, neighborhood_.k) || std::isinf(squared(reach))) {
      break;
    }
    reach *= 1.5;
  }
  float largest = 0.0f;
  for (std::size_t i = 0; i < block.size; ++i) {
    largest =
        std::isfinite(block.kth_d2[i]) ? std::max(largest, block.kth_d2[i]) : largest;
  }
  reach = std::max(1.1 * std::sqrt(static_cast<double>(largest)), 1e-3 * queries_.edge);
}

} // namespace pcl::kernels
