/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "surface_split.h"

#include "../kernels/parallel.h"
#include "part_assignment.h"
#include "part_borders.h"
#include "quiet.h"

#include <algorithm>
#include <map>

namespace pcl::segmentation {
namespace {

// doc/instances.md has the reason of each number.
constexpr int refinements = 2;
constexpr double described = 0.8; // of the nodes

/** The groups of nodes that a piece falls into; none if it stays whole. */
std::vector<NodeIndices>
cut(const SurfacePiece& piece)
{
  if (piece.isOne(piece.nodes()))
    return {};
  std::vector<SurfacePart> parts = piece.parts();
  assignNodes(piece, parts);
  for (int round = 0; round < refinements && parts.size() > 1; ++round) {
    for (SurfacePart& part : parts)
      piece.refit(part);
    assignNodes(piece, parts);
  }
  std::size_t on_parts = 0;
  for (const SurfacePart& part : parts)
    on_parts += part.nodes.size();
  if (static_cast<double>(on_parts) < described * static_cast<double>(piece.size()))
    return {};
  std::vector<NodeIndices> groups = joinParts(piece, parts);
  return groups.size() < 2 ? std::vector<NodeIndices>() : groups;
}

std::vector<NodeIndices>
piecesOf(const Labels& labels)
{
  std::map<std::int32_t, NodeIndices> nodes_of;
  for (std::uint32_t node = 0; node < labels.size(); ++node)
    if (labels[node] >= 0)
      nodes_of[labels[node]].push_back(node);
  std::vector<NodeIndices> pieces;
  for (auto& [label, nodes] : nodes_of)
    pieces.push_back(std::move(nodes));
  return pieces;
}

} // namespace

Labels
splitSurfaces(const detail::InstanceInput& input,
              const std::vector<SurfaceNode>& nodes,
              Labels labels)
{
  const std::vector<NodeIndices> pieces = piecesOf(labels);
  std::vector<std::vector<NodeIndices>> groups(pieces.size());
  const detail::Quiet quiet;
  kernels::parallelFor(pieces.size(), input.threads, [&](std::size_t i) {
    std::vector<SurfaceNode> of_piece;
    for (const std::uint32_t node : pieces[i])
      of_piece.push_back(nodes[node]);
    groups[i] = cut({std::move(of_piece), static_cast<float>(input.noise)});
  });
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (groups[i].empty())
      continue;
    for (const std::uint32_t node : pieces[i])
      labels[node] = -1;
    for (const NodeIndices& group : groups[i])
      for (const std::uint32_t k : group)
        labels[pieces[i][k]] = static_cast<std::int32_t>(pieces[i][group.front()]);
  }
  return labels;
}

} // namespace pcl::segmentation
