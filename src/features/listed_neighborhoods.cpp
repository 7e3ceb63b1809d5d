// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The statistics of the sweep over neighbors that a search method lists.

#include "common/finite.h"
#include "common/parallel.h"
#include "sweep/portable/neighborhood.h"

#include <pcl/features/impl/neighborhoods.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::detail {
namespace {

using namespace kernels;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

void
collectNeighbors(const XYZView& surface,
                 const pcl::Indices& found,
                 const float* q,
                 Neighbors& neighbors)
{
  neighbors.clear();
  for (const pcl::index_t index : found) {
    const auto position = static_cast<std::uint32_t>(index);
    if (isFinite(surface[position]))
      neighbors.push_back(neighborAt(surface[position], q, position));
  }
}

/** \brief The position of the nearest neighbor; of equally near ones the first. */
std::uint32_t
nearestOf(const Neighbors& neighbors)
{
  const auto nearest = std::min_element(
      neighbors.begin(), neighbors.end(), [](const Neighbor& a, const Neighbor& b) {
        return a.d2 != b.d2 ? a.d2 < b.d2 : a.position < b.position;
      });
  return nearest->position;
}

} // namespace

/** visit(result's position, the query's surface point or -1, neighbors, whether it is
 * one of them). A query without neighbors or that is not finite is passed over. */
template <typename Visit>
void
Neighborhoods::forEachListed(const NeighborhoodSize& size, const Visit& visit) const
{
  const bool on_surface = input_.first == surface_.first;
  const std::size_t count = this->size();
  constexpr std::size_t queries_a_task = 1024;
  const std::size_t tasks = (count + queries_a_task - 1) / queries_a_task;
  parallelFor(tasks, threads_, [&](std::size_t task) {
    pcl::Indices found;
    std::vector<float> squared_distances;
    Neighbors neighbors;
    const std::size_t end = std::min(count, (task + 1) * queries_a_task);
    for (std::size_t i = task * queries_a_task; i < end; ++i) {
      const auto own = static_cast<std::uint32_t>(pointAt(i));
      const float* q = input_[own];
      if (!isFinite(q))
        continue;
      found.clear();
      finder_(pointAt(i),
              size.radii ? size.radii[i] : size.radius,
              static_cast<int>(size.k),
              found,
              squared_distances);
      collectNeighbors(surface_, found, q, neighbors);
      if (neighbors.empty())
        continue;
      const bool contains_itself =
          on_surface
              ? std::any_of(neighbors.begin(),
                            neighbors.end(),
                            [own](const Neighbor& n) { return n.position == own; })
              : anyAtQuery(neighbors);
      visit(i, on_surface ? own : nearestOf(neighbors), neighbors, contains_itself);
    }
  });
}

bool
Neighborhoods::computeListedNormals(const NeighborhoodSize& size,
                                    float* normals,
                                    float* curvature,
                                    std::size_t stride) const
{
  const std::size_t count = this->size();
  for (std::size_t i = 0; i < count; ++i) {
    std::fill_n(normals + i * stride, 3, nan);
    curvature[i * stride] = nan;
  }
  forEachListed(size,
                [&](std::size_t i,
                    std::uint32_t,
                    const Neighbors& neighbors,
                    bool contains_itself) {
                  const NormalResult result = normalOf(neighbors, contains_itself);
                  float* normal = normals + i * stride;
                  normal[0] = result.x;
                  normal[1] = result.y;
                  normal[2] = result.z;
                  curvature[i * stride] = result.curvature;
                });
  bool is_finite = true;
  for (std::size_t i = 0; i < count; ++i)
    is_finite = is_finite && !std::isnan(normals[i * stride]);
  return is_finite;
}

bool
Neighborhoods::computeListedINAD(const NeighborhoodSize& size,
                                 const XYZView& normals,
                                 double outlier_rate,
                                 float* mu_sigma) const
{
  checkINADInput(surface_.size, normals.size, outlier_rate);
  const UnitNormals unit = unitNormals(normals, nullptr, threads_);
  const float* const arrays[] = {unit.x.data(), unit.y.data(), unit.z.data()};
  const std::size_t count = this->size();
  std::fill_n(mu_sigma, 2 * count, nan);
  forEachListed(size,
                [&](std::size_t i,
                    std::uint32_t own,
                    const Neighbors& neighbors,
                    bool contains_itself) {
                  const INADResult result = inadOf(
                      neighbors, unit[own], arrays, contains_itself, outlier_rate);
                  mu_sigma[2 * i] = result.mu;
                  mu_sigma[2 * i + 1] = result.sigma;
                });
  return std::none_of(
      mu_sigma, mu_sigma + 2 * count, [](float v) { return std::isnan(v); });
}

} // namespace pcl::detail
