/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "part_assignment.h"

#include <algorithm>
#include <limits>
#include <map>

namespace pcl::segmentation {
namespace {

// doc/instances.md has the reason of each number.
constexpr int rounds = 5;
constexpr float smoothing = 4.0f;
constexpr std::size_t least_nodes = 12;
constexpr double covered = 0.8;

using PartOfNode = std::map<std::uint32_t, std::uint32_t>;

/** The number of parts if none is near. */
std::uint32_t
bestPart(const SurfacePiece& piece,
         std::uint32_t node,
         const std::vector<SurfacePart>& parts,
         const PartOfNode& part_of)
{
  std::map<std::uint32_t, float> votes;
  float all = 0.0f;
  piece.forEachAround(node, [&](std::uint32_t other) {
    const auto found = part_of.find(other);
    if (found != part_of.end() && other != node) {
      ++votes[found->second];
      ++all;
    }
  });
  float least = std::numeric_limits<float>::infinity();
  auto best = static_cast<std::uint32_t>(parts.size());
  for (const auto& [part, count] : votes) {
    const float distance = piece.distanceTo(parts[part].surface, node);
    if (!(distance < piece.gapLimit()))
      continue;
    const float ratio = distance / piece.tolerance();
    const float cost = ratio * ratio + smoothing * (1.0f - count / all);
    if (cost < least) {
      least = cost;
      best = part;
    }
  }
  return best;
}

bool
isCovered(const SurfacePiece& piece,
          std::size_t p,
          const std::vector<SurfacePart>& parts)
{
  const auto is_on_another = [&](std::uint32_t node) {
    for (std::size_t q = 0; q < parts.size(); ++q) {
      const float limit = isCurved(parts[q]) ? piece.gapLimit() : piece.tolerance();
      if (q != p && piece.distanceTo(parts[q].surface, node) < limit)
        return true;
    }
    return false;
  };
  const NodeIndices& nodes = parts[p].nodes;
  const auto count = std::count_if(nodes.begin(), nodes.end(), is_on_another);
  return static_cast<double>(count) >= covered * static_cast<double>(nodes.size());
}

void
assign(const SurfacePiece& piece, std::vector<SurfacePart>& parts)
{
  PartOfNode part_of;
  for (std::uint32_t p = 0; p < parts.size(); ++p) {
    for (const std::uint32_t node : parts[p].nodes)
      part_of[node] = p;
    parts[p].nodes.clear();
  }
  for (int round = 0; round < rounds; ++round)
    for (const std::uint32_t node : piece.nodes()) {
      const std::uint32_t part = bestPart(piece, node, parts, part_of);
      if (part < parts.size())
        part_of[node] = part;
      else
        part_of.erase(node);
    }
  for (const auto& [node, part] : part_of)
    parts[part].nodes.push_back(node);
  std::stable_sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) {
    return a.nodes.size() > b.nodes.size();
  });
}

/** \return whether there were any */
bool
dropNeedless(const SurfacePiece& piece, std::vector<SurfacePart>& parts)
{
  const std::size_t before = parts.size();
  for (std::size_t p = parts.size(); p-- > 0;)
    if (parts[p].nodes.size() < least_nodes || isCovered(piece, p, parts))
      parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(p));
  return parts.size() < before;
}

} // namespace

void
assignNodes(const SurfacePiece& piece, std::vector<SurfacePart>& parts)
{
  do
    assign(piece, parts);
  while (dropNeedless(piece, parts));
}

} // namespace pcl::segmentation
