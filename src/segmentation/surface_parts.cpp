/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "disjoint_sets.h"
#include "surface_piece.h"

#include <algorithm>
#include <iterator>
#include <limits>

// The parts of a piece, one primitive after the other (sequential RANSAC).
namespace pcl::segmentation {
namespace {

// doc/instances.md has the reason of each number.
constexpr std::size_t most_parts = 16;
constexpr double simpler = 1.5;

} // namespace

std::vector<SurfacePart>
SurfacePiece::parts() const
{
  NodeIndices left = nodes();
  std::vector<SurfacePart> parts;
  while (left.size() >= leastSize()) {
    SurfacePart part = largestPart(left);
    if (part.nodes.size() < least_nodes)
      break;
    if (parts.size() == most_parts)
      return {};
    NodeIndices others;
    std::set_difference(left.begin(),
                        left.end(),
                        part.nodes.begin(),
                        part.nodes.end(),
                        std::back_inserter(others));
    left = std::move(others);
    parts.push_back(std::move(part));
  }
  return parts;
}

/** The connected nodes of a primitive that are most; of the simplest if others have
 * not many more. */
SurfacePart
SurfacePiece::largestPart(const NodeIndices& nodes) const
{
  const PrimitiveSample sample = sampleOf(nodes);
  SurfacePart best;
  for (const PrimitiveType type :
       {PrimitiveType::Plane, PrimitiveType::Cylinder, PrimitiveType::Sphere}) {
    SurfacePart part;
    part.surface = fitTo(sample, type);
    if (part.surface.type == PrimitiveType::None)
      continue;
    part.nodes = mostConnected(inliersOf(part.surface, nodes));
    const double factor = best.nodes.empty() ? 0.0 : simpler;
    if (static_cast<double>(part.nodes.size()) >
        factor * static_cast<double>(best.nodes.size()))
      best = std::move(part);
    if (static_cast<double>(best.nodes.size()) >=
        all_but_noise * static_cast<double>(nodes.size()))
      break;
  }
  return best;
}

NodeIndices
SurfacePiece::mostConnected(const NodeIndices& nodes) const
{
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> place(nodes_.size(), none);
  for (std::uint32_t k = 0; k < nodes.size(); ++k)
    place[nodes[k]] = k;
  DisjointSets sets(nodes.size());
  for (std::uint32_t k = 0; k < nodes.size(); ++k)
    forEachAround(nodes[k], [&](std::uint32_t other) {
      if (place[other] != none)
        sets.unite(k, place[other]);
    });
  std::vector<std::size_t> sizes(nodes.size(), 0);
  for (std::uint32_t k = 0; k < nodes.size(); ++k)
    ++sizes[sets.find(k)];
  const auto largest = static_cast<std::uint32_t>(
      std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
  NodeIndices connected;
  for (std::uint32_t k = 0; k < nodes.size(); ++k)
    if (sets.find(k) == largest)
      connected.push_back(nodes[k]);
  return connected;
}

} // namespace pcl::segmentation
