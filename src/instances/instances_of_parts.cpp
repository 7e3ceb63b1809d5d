// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Instances of a class over the parts of a cloud: the steps of findComponents(), each
// for one part.

#include "common/disjoint_sets.h"
#include "features/adaptive_inad.h"
#include "features/spacing/local_spacing.h"
#include "geometry/point_choice.h"
#include "geometry/vectors.h"
#include "instances/label_growth.h"
#include "instances/pieces/piece_splitting.h"

#include <pcl/segmentation/instances_of_parts.h>

#include <algorithm>
#include <map>
#include <numeric>

namespace pcl {
namespace {

using namespace detail;
using namespace segmentation;

InstanceInput
inputOf(const std::vector<InstancePoint>& points,
        const CloudNumbers& numbers,
        unsigned threads)
{
  InstanceInput input;
  input.points = positionsOf(points);
  for (const InstancePoint& point : points) {
    input.normals.insert(input.normals.end(), point.normal.begin(), point.normal.end());
    input.spacings.push_back(point.spacing);
    input.edge.push_back(point.edge);
    input.likelihood.push_back(point.likelihood);
  }
  input.noise = numbers.noise;
  input.threads = threads;
  input.median_spacing = numbers.spacing;
  return input;
}

SurfaceNode
toSurfaceNode(const InstanceNode& node)
{
  return {toVector(node.position), toVector(node.normal), node.spacing, node.noise, 0};
}

std::vector<SurfaceNode>
toSurfaceNodes(const std::vector<InstanceNode>& nodes)
{
  std::vector<SurfaceNode> result;
  result.reserve(nodes.size());
  for (const InstanceNode& node : nodes)
    result.push_back(toSurfaceNode(node));
  return result;
}

/** In the order that the whole cloud has nodes in: that of their cells. */
std::vector<std::uint32_t>
orderOf(const std::vector<InstanceNode>& nodes, float cell)
{
  std::vector<std::array<float, 3>> cells;
  cells.reserve(nodes.size());
  for (const InstanceNode& node : nodes)
    cells.push_back(cellAt(node.place.data(), cell));
  std::vector<std::uint32_t> order(nodes.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return cells[a] < cells[b];
  });
  return order;
}

std::vector<LabelSize>
sizesOf(const std::vector<LabelCount>& counts)
{
  std::vector<LabelSize> sizes;
  for (const LabelCount& count : counts)
    sizes.push_back({count.points, count.first});
  return sizes;
}

void
add(const LabelCount& some, LabelCount& all)
{
  all.first = all.points == 0 ? some.first : std::min(all.first, some.first);
  all.points += some.points;
  all.high_points += some.high_points;
  all.label = some.label;
}

} // namespace

InstancesOfParts::InstancesOfParts(const CloudNumbers& numbers,
                                   const InstanceLimits& limits,
                                   unsigned threads)
: numbers_(numbers)
, limits_(limits)
, threads_(threads)
{}

InstancesOfParts::Reach
InstancesOfParts::reach() const
{
  // Sums of floats are rounded; a neighbor at the very border must not be missed.
  constexpr double rounding = 1.001;
  const double most = rounding * mostSpacing(numbers_.distance);
  const double node = nodeReach() * most; // as far it is from a place to its node
  return {node,
          linkReach() * most + 2.0 * node,
          pieceReach() * most + node,
          growthReach(numbers_.noise) * most};
}

void
InstancesOfParts::turn(const std::array<float, 3>& view_point, InstancePoint& point)
{
  point.normal = toArray(turnedNormal(
      toVector(point.normal), toVector(point.position), toVector(view_point)));
}

std::vector<bool>
InstancesOfParts::mayHold(const std::vector<InstancePoint>& points) const
{
  const std::vector<char> members =
      membersOf(inputOf(points, numbers_, threads_), limits_.low, true);
  return {members.begin(), members.end()};
}

std::vector<InstanceNode>
InstancesOfParts::nodes(const std::vector<InstancePoint>& points, std::size_t own) const
{
  const InstanceInput input = inputOf(points, numbers_, threads_);
  const PointGrid grid(input.points, gridCell(medianSpacing(input)));
  std::vector<InstanceNode> nodes;
  for (const SurfaceNode& node :
       surfaceNodes(input, grid, membersOf(input, limits_.low, false)))
    if (node.point < own)
      nodes.push_back({points[node.point].position,
                       toArray(node.position),
                       toArray(node.normal),
                       node.spacing,
                       node.noise});
  return nodes;
}

LinkedNodes
InstancesOfParts::link(const std::vector<InstanceNode>& nodes, std::size_t own) const
{
  const InstanceInput input = inputOf({}, numbers_, threads_);
  const std::vector<SurfaceNode> all = toSurfaceNodes(nodes);
  const PointGrid grid(positionsOf(all), nodeGridCell(input));
  const std::vector<std::vector<std::uint32_t>> links = linksOf(input, all, grid, own);
  DisjointSets sets(own);
  for (std::uint32_t k = 0; k < own; ++k)
    for (const std::uint32_t other : links[k])
      if (other < own && !links[other].empty())
        sets.unite(k, other);
  LinkedNodes linked;
  linked.piece.assign(own, LinkedNodes::none);
  for (std::uint32_t k = 0; k < own; ++k) {
    if (links[k].empty())
      continue;
    const std::uint32_t root = sets.find(k); // the first of its set
    linked.piece[k] = root == k ? linked.pieces++ : linked.piece[root];
    for (const std::uint32_t other : links[k])
      if (other >= own)
        linked.outward.push_back({linked.piece[k], other});
  }
  std::sort(linked.outward.begin(), linked.outward.end());
  linked.outward.erase(std::unique(linked.outward.begin(), linked.outward.end()),
                       linked.outward.end());
  return linked;
}

std::vector<std::vector<std::int32_t>>
InstancesOfParts::cut(
    std::size_t pieces,
    const std::function<std::vector<InstanceNode>(std::size_t)>& nodesOf) const
{
  const float cell = nodeCell(inputOf({}, numbers_, threads_));
  std::vector<std::vector<std::uint32_t>> orders(pieces);
  const auto sortedNodesOf = [&](std::size_t piece) {
    const std::vector<InstanceNode> nodes = nodesOf(piece);
    orders[piece] = orderOf(nodes, cell);
    std::vector<SurfaceNode> sorted;
    sorted.reserve(nodes.size());
    for (const std::uint32_t k : orders[piece])
      sorted.push_back(toSurfaceNode(nodes[k]));
    return sorted;
  };
  const std::vector<std::vector<NodeIndices>> groups =
      cutPieces(pieces, sortedNodesOf, numbers_.noise, threads_);
  std::vector<std::vector<std::int32_t>> result(pieces);
  for (std::size_t piece = 0; piece < pieces; ++piece) {
    const bool is_whole = groups[piece].empty();
    result[piece].assign(orders[piece].size(), is_whole ? 0 : -1);
    for (std::size_t g = 0; g < groups[piece].size(); ++g)
      for (const std::uint32_t k : groups[piece][g])
        result[piece][orders[piece][k]] = static_cast<std::int32_t>(g);
  }
  return result;
}

std::vector<std::int32_t>
InstancesOfParts::labels(const std::vector<InstancePoint>& points,
                         std::vector<InstanceNode> nodes,
                         const std::vector<std::int32_t>& labels) const
{
  const InstanceInput input = inputOf(points, numbers_, threads_);
  // Of two nodes that are as near the first one counts.
  std::vector<SurfaceNode> sorted;
  Labels labels_of_nodes;
  for (const std::uint32_t k : orderOf(nodes, nodeCell(input))) {
    sorted.push_back(toSurfaceNode(nodes[k]));
    labels_of_nodes.push_back(labels[k]);
  }
  const PointGrid grid(positionsOf(sorted), nodeGridCell(input));
  return labelsAt(
      input, membersOf(input, limits_.low, false), sorted, grid, labels_of_nodes);
}

std::vector<std::int32_t>
InstancesOfParts::grow(const std::vector<InstancePoint>& points,
                       std::vector<std::int32_t> labels) const
{
  const InstanceInput input = inputOf(points, numbers_, threads_);
  const PointGrid grid(input.points, gridCell(medianSpacing(input)));
  growLabels(input, grid, {membersOf(input, limits_.low, true), true}, labels);
  return labels;
}

std::vector<LabelCount>
InstancesOfParts::count(const std::vector<InstancePoint>& points,
                        const std::vector<std::int32_t>& labels) const
{
  std::map<std::int32_t, LabelCount> counts;
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] >= 0) {
      const bool is_high = points[i].likelihood >= static_cast<float>(limits_.high);
      pcl::add({1, is_high ? 1U : 0U, points[i].position, labels[i]},
               counts[labels[i]]);
    }
  std::vector<LabelCount> result;
  for (const auto& [label, count] : counts)
    result.push_back(count);
  return result;
}

void
InstancesOfParts::add(const std::vector<LabelCount>& part, std::vector<LabelCount>& all)
{
  for (const LabelCount& count : part) {
    const auto label = static_cast<std::size_t>(count.label);
    if (all.size() <= label)
      all.resize(label + 1);
    pcl::add(count, all[label]);
  }
}

std::vector<std::int32_t>
InstancesOfParts::pieceRanks(const std::vector<LabelCount>& all) const
{
  std::vector<std::int32_t> ranks = ranksOf(sizesOf(all), 1);
  for (std::size_t label = 0; label < all.size(); ++label)
    if (!isLikely(all[label].points, all[label].high_points))
      ranks[label] = -1;
  return ranks;
}

std::vector<std::int32_t>
InstancesOfParts::instanceRanks(const std::vector<LabelCount>& all) const
{
  return ranksOf(sizesOf(all), limits_.min_points);
}

} // namespace pcl
