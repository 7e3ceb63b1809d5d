/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "part_borders.h"

#include "disjoint_sets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

namespace pcl::segmentation {
namespace {

using Eigen::Vector3f;

// doc/instances.md has the reason of each number.
constexpr float curved_gap = 1.25f, clearly_worse = 2.0f;
constexpr double both_sides = 0.25;

/** How two parts meet. */
struct Border {
  double pairs = 0.0;        ///< of nodes
  double squared_gaps = 0.0; ///< between the two surfaces, in spacings
  double cosines = 0.0;      ///< of their normals
  double steps = 0.0;        ///< squared, between nodes, in spacings
  std::array<double, 2> before{},
      behind{}; ///< of either's nodes and the other's surface
};

using Pair = std::pair<std::uint32_t, std::uint32_t>;
using Borders = std::map<Pair, Border>;

void
addSide(const SurfaceNode& node,
        const ShapePrimitive& other,
        std::size_t which,
        Border& border)
{
  const Vector3f away = node.center - footOn(other, node.center);
  const double side = away.dot(normalOf(other, node.center)) / node.spacing;
  border.before[which] += std::max(0.0, side);
  border.behind[which] += std::max(0.0, -side);
}

void
addPair(const SurfaceNode& node,
        const SurfaceNode& other,
        const ShapePrimitive& a,
        const ShapePrimitive& b,
        Border& border)
{
  const Vector3f middle = 0.5f * (node.center + other.center);
  const float area = node.spacing * other.spacing;
  const float sign = node.normal.dot(other.normal) < 0.0f ? -1.0f : 1.0f;
  const Vector3f normal = 0.5f * (node.normal + sign * other.normal);
  const float step = normal.dot(other.center - node.center);
  ++border.pairs;
  border.squared_gaps += (footOn(a, middle) - footOn(b, middle)).squaredNorm() / area;
  border.cosines += std::abs(normalOf(a, middle).dot(normalOf(b, middle)));
  border.steps += step * step / area;
  addSide(node, b, 0, border);
  addSide(other, a, 1, border);
}

Borders
bordersOf(const SurfacePiece& piece, const std::vector<SurfacePart>& parts)
{
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> part_of(piece.size(), none);
  for (std::uint32_t p = 0; p < parts.size(); ++p)
    for (const std::uint32_t node : parts[p].nodes)
      part_of[node] = p;
  Borders borders;
  for (std::uint32_t node = 0; node < piece.size(); ++node) {
    const std::uint32_t p = part_of[node];
    if (p == none)
      continue;
    piece.forEachAround(node, [&](std::uint32_t other) {
      const std::uint32_t q = part_of[other];
      if (q != none && q > p)
        addPair(piece[node],
                piece[other],
                parts[p].surface,
                parts[q].surface,
                borders[{p, q}]);
    });
  }
  return borders;
}

/** Without a step or a crease. */
bool
goesOn(const Border& border, float gap_limit)
{
  return border.squared_gaps < gap_limit * gap_limit * border.pairs &&
         border.cosines > same_surface * border.pairs;
}

/** Surfaces that cross are on both sides of each other, those at a crease are not. */
bool
crosses(const Border& border, float tolerance)
{
  const auto is_on_both_sides = [&](std::size_t which) {
    const auto [less, more] = std::minmax(border.before[which], border.behind[which]);
    return less > both_sides * more;
  };
  return border.squared_gaps > tolerance * tolerance * border.pairs &&
         is_on_both_sides(0) && is_on_both_sides(1);
}

/** The nodes themselves run on, whatever the primitives beside them are. */
bool
isSmooth(const Border& border, float noise)
{
  return border.steps < noise * noise * border.pairs &&
         border.cosines > same_surface * border.pairs;
}

bool
areOne(const SurfacePiece& piece,
       const SurfacePart& a,
       const SurfacePart& b,
       const Border& border)
{
  const bool is_smooth = isSmooth(border, piece.nodeNoise());
  if (!isCurved(a) && !isCurved(b)) {
    const float limit = is_smooth ? std::max(piece.gapLimit(), 2.0f * piece.tolerance())
                                  : piece.gapLimit();
    return goesOn(border, limit) && !crosses(border, piece.tolerance());
  }
  if (is_smooth)
    return true;
  NodeIndices both;
  std::set_union(a.nodes.begin(),
                 a.nodes.end(),
                 b.nodes.begin(),
                 b.nodes.end(),
                 std::back_inserter(both));
  const float apart = std::max(piece.residualOf(a.surface, a.nodes),
                               piece.residualOf(b.surface, b.nodes));
  const float as_one = piece.residualAsOne(both);
  if (apart < piece.nodeNoise())
    return as_one < clearly_worse * apart;
  return as_one < piece.gapLimit() || goesOn(border, curved_gap * piece.gapLimit());
}

/** The group that a group has most of its borders with, itself if it has none. */
std::uint32_t
neighborOf(std::uint32_t group, const Borders& borders, DisjointSets& sets)
{
  std::map<std::uint32_t, double> around;
  for (const auto& [pair, border] : borders) {
    const std::uint32_t a = sets.find(pair.first), b = sets.find(pair.second);
    if (a != b && (a == group || b == group))
      around[a == group ? b : a] += border.pairs;
  }
  const auto most =
      std::max_element(around.begin(), around.end(), [](const auto& x, const auto& y) {
        return x.second < y.second;
      });
  return most == around.end() ? group : most->first;
}

void
absorbSmall(const SurfacePiece& piece,
            const std::vector<SurfacePart>& parts,
            const Borders& borders,
            DisjointSets& sets)
{
  for (std::uint32_t p = 0; p < parts.size(); ++p) {
    const std::uint32_t group = sets.find(p);
    std::size_t size = 0;
    for (std::uint32_t q = 0; q < parts.size(); ++q)
      size += sets.find(q) == group ? parts[q].nodes.size() : 0;
    if (size < piece.leastSize())
      sets.unite(group, neighborOf(group, borders, sets));
  }
}

} // namespace

std::vector<NodeIndices>
joinParts(const SurfacePiece& piece, const std::vector<SurfacePart>& parts)
{
  DisjointSets sets(parts.size());
  const Borders borders = bordersOf(piece, parts);
  for (const auto& [pair, border] : borders) {
    const SurfacePart& a = parts[pair.first];
    const SurfacePart& b = parts[pair.second];
    const bool are_large =
        std::min(a.nodes.size(), b.nodes.size()) >= piece.leastSize();
    if (are_large ? areOne(piece, a, b, border) : isSmooth(border, piece.nodeNoise()))
      sets.unite(pair.first, pair.second);
  }
  absorbSmall(piece, parts, borders, sets);
  std::map<std::uint32_t, NodeIndices> groups;
  for (std::uint32_t p = 0; p < parts.size(); ++p) {
    NodeIndices& group = groups[sets.find(p)];
    group.insert(group.end(), parts[p].nodes.begin(), parts[p].nodes.end());
  }
  std::vector<NodeIndices> joined;
  for (auto& [root, nodes] : groups)
    if (nodes.size() >= piece.leastSize())
      joined.push_back(std::move(nodes));
  return joined;
}

} // namespace pcl::segmentation
