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

namespace pcl::segmentation {
namespace {

// doc/instances.md has the reason of each number.
constexpr int rounds = 5;
constexpr float smoothing = 4.0f;
constexpr std::size_t least_nodes = 12;
constexpr double covered = 0.8;

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
using PartOfNode = std::vector<std::uint32_t>;

/** None if none is near. */
std::uint32_t
bestPart(const SurfacePiece& piece,
         std::uint32_t node,
         const std::vector<SurfacePart>& parts,
         const PartOfNode& part_of)
{
  std::vector<float> votes(parts.size(), 0.0f);
  float all = 0.0f;
  piece.forEachAround(node, [&](std::uint32_t other) {
    if (part_of[other] != none && other != node) {
      ++votes[part_of[other]];
      ++all;
    }
  });
  float least = std::numeric_limits<float>::infinity();
  std::uint32_t best = none;
  for (std::uint32_t part = 0; part < parts.size(); ++part) {
    if (votes[part] == 0.0f)
      continue;
    const float distance = piece.distanceTo(parts[part].surface, node);
    if (!(distance < piece.gapLimit()))
      continue;
    const float ratio = distance / piece.tolerance();
    const float cost = ratio * ratio + smoothing * (1.0f - votes[part] / all);
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
  PartOfNode part_of(piece.size(), none);
  for (std::uint32_t p = 0; p < parts.size(); ++p) {
    for (const std::uint32_t node : parts[p].nodes)
      part_of[node] = p;
    parts[p].nodes.clear();
  }
  for (int round = 0; round < rounds; ++round)
    for (std::uint32_t node = 0; node < piece.size(); ++node)
      part_of[node] = bestPart(piece, node, parts, part_of);
  for (std::uint32_t node = 0; node < piece.size(); ++node)
    if (part_of[node] != none)
      parts[part_of[node]].nodes.push_back(node);
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
