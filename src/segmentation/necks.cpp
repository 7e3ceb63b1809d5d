/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "necks.h"

#include "../kernels/finite.h"
#include "../kernels/parallel.h"
#include "disjoint_sets.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

namespace pcl::segmentation {
namespace {

using detail::InstanceInput;
using Eigen::Vector3f;

// In spacings; doc/instances.md has the reason of each number.
constexpr float wide_spacings = 4.0f;
constexpr float border_spacings = 3.0f;
constexpr float least_edge_share = 0.5f; // edge points for each other point

/** What is at the border of two parts. */
struct Border {
  std::size_t edge = 0; ///< points
  std::size_t free = 0; ///< points
};

using Borders = std::map<std::pair<std::int32_t, std::int32_t>, Border>;

bool
isWide(const InstanceInput& input,
       const PointGrid& points,
       const SurfaceNodes& nodes,
       const SurfaceNode& node)
{
  bool has_edge = false;
  nodes.forEachWithin(
      node.center, wide_spacings * node.spacing, [&](std::uint32_t k, float) {
        has_edge = has_edge || nodes.nodes()[k].on_step > 0.0f;
      });
  points.forEachWithin(
      node.center, wide_spacings * node.spacing, [&](std::uint32_t i, float) {
        has_edge = has_edge || input.edge[i] > edge_threshold;
      });
  return !has_edge;
}

/** Components of the nodes that are apart from edges; -1 for the others. */
Labels
widePartsOf(const InstanceInput& input,
            const PointGrid& points,
            const SurfaceNodes& nodes,
            const Links& links)
{
  std::vector<char> wide(links.size(), 0);
  kernels::parallelForRanges(
      wide.size(), input.threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
          wide[k] = !links[k].empty() && isWide(input, points, nodes, nodes.nodes()[k]);
      });
  DisjointSets sets(links.size());
  for (std::size_t k = 0; k < links.size(); ++k)
    for (const std::uint32_t other : links[k])
      if (wide[k] && wide[other])
        sets.unite(static_cast<std::uint32_t>(k), other);
  Labels parts(links.size(), -1);
  for (std::size_t k = 0; k < links.size(); ++k)
    if (wide[k])
      parts[k] = static_cast<std::int32_t>(sets.find(static_cast<std::uint32_t>(k)));
  return parts;
}

/** Round by round the other nodes take the part of the nearest node linked to them. */
void
spread(const SurfaceNodes& nodes, const Links& links, Labels& parts)
{
  for (bool changed = true; changed;) {
    changed = false;
    Labels next = parts;
    for (std::size_t k = 0; k < links.size(); ++k) {
      if (parts[k] >= 0)
        continue;
      std::tuple<float, std::int32_t> nearest;
      for (const std::uint32_t other : links[k]) {
        const Vector3f between = nodes.nodes()[other].center - nodes.nodes()[k].center;
        const std::tuple<float, std::int32_t> candidate(between.squaredNorm(),
                                                        parts[other]);
        if (parts[other] >= 0 && (next[k] < 0 || candidate < nearest)) {
          nearest = candidate;
          next[k] = parts[other];
          changed = true;
        }
      }
    }
    parts = std::move(next);
  }
}

/** Count a point at the borders of the parts of one component that it is near. */
void
countAt(const InstanceInput& input,
        std::size_t i,
        const SurfaceNodes& nodes,
        const Labels& labels,
        const Labels& parts,
        Borders& borders)
{
  std::array<std::pair<std::int32_t, std::int32_t>, 4> seen;
  std::size_t count = 0;
  bool on_step = false;
  float nearest = std::numeric_limits<float>::infinity();
  const auto visit = [&](std::uint32_t k, float squared) {
    if (squared < nearest) {
      nearest = squared;
      on_step = nodes.nodes()[k].on_step > 0.0f;
    }
    const std::pair<std::int32_t, std::int32_t> part(labels[k], parts[k]);
    const auto end = seen.begin() + static_cast<std::ptrdiff_t>(count);
    if (parts[k] >= 0 && count < seen.size() &&
        std::find(seen.begin(), end, part) == end)
      seen[count++] = part;
  };
  nodes.forEachWithin(
      positionOf(input.points, i), border_spacings * input.spacings[i], visit);
  for (std::size_t a = 0; a < count; ++a)
    for (std::size_t b = a + 1; b < count; ++b) {
      if (seen[a].first != seen[b].first)
        continue;
      Border& border = borders[std::minmax(seen[a].second, seen[b].second)];
      ++(on_step || input.edge[i] > edge_threshold ? border.edge : border.free);
    }
}

Borders
bordersOf(const InstanceInput& input,
          const SurfaceNodes& nodes,
          const Labels& labels,
          const Labels& parts)
{
  constexpr std::size_t size = 8192;
  std::vector<Borders> some((input.points.size + size - 1) / size);
  kernels::parallelFor(some.size(), input.threads, [&](std::size_t p) {
    const std::size_t end = std::min(input.points.size, (p + 1) * size);
    for (std::size_t i = p * size; i < end; ++i)
      if (kernels::isFinite(input.points[i]))
        countAt(input, i, nodes, labels, parts, some[p]);
  });
  Borders all;
  for (const Borders& borders : some)
    for (const auto& [parts_of, border] : borders) {
      all[parts_of].edge += border.edge;
      all[parts_of].free += border.free;
    }
  return all;
}

} // namespace

Labels
cutNecks(const InstanceInput& input,
         const PointGrid& points,
         const SurfaceNodes& nodes,
         const Links& links,
         const Labels& labels)
{
  Labels parts = widePartsOf(input, points, nodes, links);
  spread(nodes, links, parts);
  DisjointSets sets(parts.size());
  for (const auto& [parts_of, border] : bordersOf(input, nodes, labels, parts))
    if (static_cast<float>(border.edge) <
        least_edge_share * static_cast<float>(border.free))
      sets.unite(static_cast<std::uint32_t>(parts_of.first),
                 static_cast<std::uint32_t>(parts_of.second));
  Labels result(labels);
  for (std::size_t k = 0; k < parts.size(); ++k)
    if (parts[k] >= 0)
      result[k] =
          static_cast<std::int32_t>(sets.find(static_cast<std::uint32_t>(parts[k])));
  return result;
}

} // namespace pcl::segmentation
