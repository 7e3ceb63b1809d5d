// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The kernels in plain C++: one query after the other, from lists of its neighbors.

#include "sweep/portable/neighborhood.h"

#include <algorithm>
#include <cmath>

namespace pcl::kernels {

namespace {

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

/** \brief Whether a cluster's box is so near that it may hold neighbors. */
bool
isNear(const SweepBlock& block, std::size_t query, std::uint32_t cluster)
{
  const float at[] = {block.qx[query], block.qy[query], block.qz[query]};
  float d2 = 0.0f;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float apart = std::max({0.0f,
                                  block.cluster_box[axis][cluster] - at[axis],
                                  at[axis] - block.cluster_box[axis + 3][cluster]});
    d2 += apart * apart;
  }
  // Sums round: a little further than the neighbors.
  const float reach2 = std::max(block.r2[query], block.tie_d2[query]);
  return d2 <= reach2 * (1.0f + 1e-5f) + std::numeric_limits<float>::min();
}

/** \brief The neighbors of a query, in a buffer that the thread keeps from call to
 * call. */
const Neighbors&
findNeighbors(const SweepBlock& block, std::size_t query)
{
  thread_local Neighbors found;
  std::size_t count = 0;
  const auto addOf = [&](std::uint32_t cluster) {
    const std::uint32_t begin = block.cluster_begin[cluster];
    const std::uint32_t end = block.cluster_begin[cluster + 1];
    found.resize(std::max(found.size(), count + (end - begin)));
    for (std::uint32_t j = begin; j < end; ++j) {
      const Neighbor candidate = relativeTo(block, query, j);
      found[count] = candidate;
      count += isNeighbor(block, query, candidate) ? 1 : 0;
    }
  };
  for (std::size_t r = 0; r < block.run_count; ++r) {
    for (std::uint32_t c = block.runs[r].begin; c < block.runs[r].end; ++c)
      if (isNear(block, query, c))
        addOf(c);
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
  for (std::size_t i = 0; i < block.size; ++i)
    results[i] = normalAt(block, i);
}

/** \brief The nearest neighbor, of equally near ones the one of the smallest index. */
const Neighbor*
nearestOf(const SweepBlock& block, const Neighbors& neighbors)
{
  const auto nearest = std::min_element(
      neighbors.begin(), neighbors.end(), [&](const Neighbor& a, const Neighbor& b) {
        return a.d2 != b.d2 ? a.d2 < b.d2
                            : block.order[a.position] < block.order[b.position];
      });
  return nearest == neighbors.end() ? nullptr : &*nearest;
}

void
inad(const SweepBlock& block, double outlier_rate, INADResult* results)
{
  const float* const normals[] = {block.nx, block.ny, block.nz};
  const OwnPoints own = ownPointsOf(block);
  for (std::size_t i = 0; i < block.size; ++i) {
    results[i] = inadOf(findNeighbors(block, i),
                        {own.nx[i], own.ny[i], own.nz[i]},
                        normals,
                        own.is_neighbor[i] != 0,
                        outlier_rate);
  }
}

void
count(const SweepBlock& block, std::uint32_t* results)
{
  for (std::size_t i = 0; i < block.size; ++i) {
    const Neighbors& neighbors = findNeighbors(block, i);
    const bool has_own = !neighbors.empty() && containsItself(block, neighbors);
    results[i] = static_cast<std::uint32_t>(neighbors.size() - (has_own ? 1 : 0));
  }
}

/** \brief Of equally far ones, those of the smallest indices. */
bool
narrowToNearest(SweepBlock& block, std::size_t query, std::size_t k)
{
  thread_local std::vector<std::pair<float, std::uint32_t>> distances;
  distances.clear();
  for (const Neighbor& n : findNeighbors(block, query))
    distances.emplace_back(n.d2, block.order[n.position]);
  if (distances.size() < k) {
    block.kth_d2[query] = nan;
    return false;
  }
  const auto kth = distances.begin() + static_cast<std::ptrdiff_t>(k - 1);
  std::nth_element(distances.begin(), kth, distances.end());
  block.kth_d2[query] = block.tie_d2[query] = block.r2[query] = kth->first;
  block.tie_index[query] = kth->second;
  return true;
}

bool
nearest(SweepBlock& block, std::size_t k)
{
  bool all = true;
  for (std::size_t i = 0; i < block.size; ++i)
    all = narrowToNearest(block, i, k) && all;
  return all;
}

void
cells(const float* coordinates,
      std::size_t count,
      double cells_per_meter,
      std::int32_t* out)
{
  std::transform(coordinates, coordinates + count, out, [=](float coordinate) {
    return cellOf(coordinate, cells_per_meter);
  });
}

std::uint32_t
countLess(const float* values, std::size_t count, float bound)
{
  return static_cast<std::uint32_t>(
      std::count_if(values, values + count, [bound](float v) { return v < bound; }));
}

} // namespace

OwnPoints
ownPointsOf(const SweepBlock& block)
{
  OwnPoints own{};
  for (std::size_t i = 0; i < block.size; ++i) {
    UnitNormal normal{block.qnx[i], block.qny[i], block.qnz[i]};
    bool is_neighbor = true;
    if (!block.queries_on_surface) {
      const Neighbor* nearest = nearestOf(block, findNeighbors(block, i));
      is_neighbor = nearest && nearest->d2 == 0.0f;
      normal = {nan, nan, nan};
      if (nearest) {
        const std::uint32_t j = nearest->position;
        normal = {block.nx[j], block.ny[j], block.nz[j]};
      }
    }
    own.nx[i] = normal.x;
    own.ny[i] = normal.y;
    own.nz[i] = normal.z;
    own.is_neighbor[i] = is_neighbor && !std::isnan(normal.x) ? 1 : 0;
  }
  return own;
}

bool
spansSurface(const SweepBlock& block, std::size_t query)
{
  return spansSurface(findNeighbors(block, query));
}

NormalResult
normalAt(const SweepBlock& block, std::size_t query)
{
  const Neighbors& neighbors = findNeighbors(block, query);
  return normalOf(neighbors, containsItself(block, neighbors));
}

bool
isAtSurfacePoint(const SweepBlock& block, std::size_t query)
{
  return anyAtQuery(findNeighbors(block, query));
}

const KernelTable&
portableKernels()
{
  static const KernelTable table{normals, inad, count, nearest, cells, countLess};
  return table;
}

} // namespace pcl::kernels
