/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "neighborhood.h"
#include "sweep_block.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace pcl {
namespace kernels {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

Neighbor
relativeTo(const SweepBlock& block, std::size_t query, std::uint32_t j)
{
  const float point[] = {block.x[j], block.y[j], block.z[j]};
  const float from[] = {block.qx[query], block.qy[query], block.qz[query]};
  return neighborAt(point, from, j);
}

bool
isNeighbor(const SweepBlock& block, std::size_t query, const Neighbor& candidate)
{
  return candidate.d2 < block.r2[query] ||
         (candidate.d2 == block.tie_d2[query] &&
          block.order[candidate.position] <= block.tie_index[query]);
}

/** \brief The neighbors of a query, in a buffer that the thread keeps from call to
 * call. */
const Neighbors&
findNeighbors(const SweepBlock& block, std::size_t query)
{
  thread_local Neighbors found;
  std::size_t count = 0;
  for (std::size_t r = 0; r < block.run_count; ++r) {
    const Run run = block.runs[r];
    found.resize(std::max(found.size(), count + (run.end - run.begin)));
    for (std::uint32_t j = run.begin; j < run.end; ++j) {
      const Neighbor candidate = relativeTo(block, query, j);
      found[count] = candidate;
      count += isNeighbor(block, query, candidate) ? 1 : 0;
    }
  }
  found.resize(count);
  return found;
}

bool
containsItself(const SweepBlock& block, const Neighbors& neighbors)
{
  return block.queries_on_surface || anyAtQuery(neighbors);
}

void
normals(const SweepBlock& block, NormalResult* results)
{
  for (std::size_t i = 0; i < block.size; ++i) {
    const Neighbors& neighbors = findNeighbors(block, i);
    results[i] = normalOf(neighbors, containsItself(block, neighbors));
  }
}

/** \brief The query's own normal, or that of the nearest surface point. */
UnitNormal
queryNormal(const SweepBlock& block, std::size_t query, const Neighbors& neighbors)
{
  if (block.queries_on_surface) {
    return {block.qnx[query], block.qny[query], block.qnz[query]};
  }
  const auto nearest = std::min_element(
      neighbors.begin(), neighbors.end(), [&](const Neighbor& a, const Neighbor& b) {
        return a.d2 != b.d2 ? a.d2 < b.d2
                            : block.order[a.position] < block.order[b.position];
      });
  if (nearest == neighbors.end()) {
    return {nan, nan, nan};
  }
  const std::uint32_t j = nearest->position;
  return {block.nx[j], block.ny[j], block.nz[j]};
}

void
inad(const SweepBlock& block, double outlier_rate, INADResult* results)
{
  const float* const normals[] = {block.nx, block.ny, block.nz};
  for (std::size_t i = 0; i < block.size; ++i) {
    const Neighbors& neighbors = findNeighbors(block, i);
    results[i] = inadOf(neighbors,
                        queryNormal(block, i, neighbors),
                        normals,
                        containsItself(block, neighbors),
                        outlier_rate);
  }
}

void
count(const SweepBlock& block, std::uint32_t* results)
{
  for (std::size_t i = 0; i < block.size; ++i) {
    const Neighbors& neighbors = findNeighbors(block, i);
    results[i] = static_cast<std::uint32_t>(neighbors.size() -
                                            (containsItself(block, neighbors) ? 1 : 0));
  }
}

bool
nearest(SweepBlock& block, std::size_t k)
{
  thread_local std::vector<std::pair<float, std::uint32_t>> distances;
  for (std::size_t i = 0; i < block.size; ++i) {
    distances.clear();
    for (const Neighbor& n : findNeighbors(block, i)) {
      distances.emplace_back(n.d2, block.order[n.position]);
    }
    if (distances.size() < k) {
      return false;
    }
    const auto kth = distances.begin() + static_cast<std::ptrdiff_t>(k - 1);
    std::nth_element(distances.begin(), kth, distances.end());
    block.tie_d2[i] = kth->first;
    block.tie_index[i] = kth->second;
    block.r2[i] = kth->first;
  }
  return true;
}

} // namespace

const KernelTable&
portableKernels()
{
  static const KernelTable table{normals, inad, count, nearest};
  return table;
}

} // namespace kernels
} // namespace pcl
