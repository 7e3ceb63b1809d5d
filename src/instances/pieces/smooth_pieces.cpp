// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Pieces of surface that are smooth inside, found over nodes that stand for the points.

#include "instances/pieces/smooth_pieces.h"

#include "common/disjoint_sets.h"
#include "common/parallel.h"
#include "geometry/point_choice.h"
#include "geometry/scatter.h"
#include "instances/label_growth.h"
#include "instances/pieces/piece_splitting.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::segmentation {
namespace {

using detail::InstanceInput;
using Eigen::Vector3f;

// In spacings.
// Some 25 points: the noise of a node is a fifth of a point's.
constexpr float fit_spacings = 1.5f;
constexpr int min_node_points = 5; // fewer have no direction
// The first distance beyond the means, to reach over points beside a step or a crease,
// whose means mix both sides.
constexpr float min_chord = 2.0f, max_chord = 4.5f;
constexpr float middle_spacings = 1.2f; // nodes are that near to any place inside
constexpr float near_spacings = 3.0f;   // two cells of nodes
constexpr float same_normal = 0.94f;    // cosine of 20 degrees, of a point and its node
// At a straight border half of the nodes around are on the same surface, beside a
// bridge of few points far less.
constexpr float core_share = 0.4f;

/** The node of a member and those around it; without a spacing if they are too few. */
SurfaceNode
fitAt(const InstanceInput& input,
      std::size_t i,
      const PointGrid& points,
      const std::vector<char>& members)
{
  const Vector3f position = positionOf(input.points, i);
  const Vector3f own = normalOf(input, i);
  Vector3f sum = Vector3f::Zero(), normals = sum;
  Scatter<float> squares;
  int count = 0;
  points.forEachWithin(
      position, fit_spacings * input.spacings[i], [&](std::uint32_t j, float) {
        if (!members[j])
          return;
        const Vector3f between = positionOf(input.points, j) - position;
        sum += between;
        squares.add(between);
        const Vector3f normal = normalOf(input, j);
        normals += normal.dot(own) < 0.0f ? Vector3f(-normal) : normal;
        ++count;
      });
  if (count < min_node_points)
    return {};
  const Vector3f mean = sum / static_cast<float>(count);
  const Vector3f normal = normals.normalized();
  const float variance =
      normal.dot(squares.matrix() * normal) / static_cast<float>(count) -
      normal.dot(mean) * normal.dot(mean);
  const float spacing = input.spacings[i];
  return {position + mean,
          normal,
          spacing,
          std::sqrt(std::max(0.0f, variance)) / spacing,
          static_cast<std::uint32_t>(i)};
}

/** Whether two points are on a circle or a line: the chord is perpendicular to the mean
 * normal. */
bool
isSmooth(const SurfaceNode& a, const SurfaceNode& b, float step_limit)
{
  const float cosine = a.normal.dot(b.normal);
  if (!(std::abs(cosine) > same_surface))
    return false;
  const float sign = cosine < 0.0f ? -1.0f : 1.0f;
  const float step =
      0.5f * std::abs((a.normal + sign * b.normal).dot(b.position - a.position));
  return step < step_limit * std::min(a.spacing, b.spacing);
}

/** Whether there is surface between two nodes. */
bool
hasMiddle(const SurfaceNode& a, const SurfaceNode& b, const PointGrid& nodes)
{
  return nodes.anyWithin(0.5f * (a.position + b.position),
                         middle_spacings * a.spacing,
                         [](std::uint32_t, const Vector3f&) { return true; });
}

/** The nodes that the surface runs to from one.
 * \return none if these are too few of those around */
std::vector<std::uint32_t>
linksFrom(const SurfaceNode& node,
          const std::vector<SurfaceNode>& nodes,
          const PointGrid& grid,
          float step_limit)
{
  const float min_squared = min_chord * min_chord * node.spacing * node.spacing;
  int candidates = 0;
  std::vector<std::uint32_t> links;
  grid.forEachWithin(
      node.position, max_chord * node.spacing, [&](std::uint32_t j, float squared) {
        if (squared < min_squared)
          return;
        ++candidates;
        if (isSmooth(node, nodes[j], step_limit) && hasMiddle(node, nodes[j], grid))
          links.push_back(j);
      });
  if (static_cast<float>(links.size()) < core_share * static_cast<float>(candidates))
    links.clear();
  return links;
}

/** A label for each node; -1 where the surface runs to too few around it. */
Labels
linkedNodes(const InstanceInput& input,
            const std::vector<SurfaceNode>& nodes,
            const PointGrid& grid)
{
  const std::vector<std::vector<std::uint32_t>> links =
      linksOf(input, nodes, grid, nodes.size());
  DisjointSets sets(nodes.size());
  for (std::uint32_t k = 0; k < nodes.size(); ++k)
    for (const std::uint32_t other : links[k])
      if (!links[other].empty())
        sets.unite(k, other);
  Labels labels(nodes.size(), -1);
  for (std::uint32_t k = 0; k < nodes.size(); ++k)
    if (!links[k].empty())
      labels[k] = static_cast<std::int32_t>(sets.find(k));
  return labels;
}

/** The label of the nearest node with one whose surface a point is on; -1 if there is
 * none. */
std::int32_t
labelAt(const InstanceInput& input,
        std::size_t point,
        const std::vector<SurfaceNode>& nodes,
        const PointGrid& grid,
        const Labels& labels)
{
  const Vector3f position = positionOf(input.points, point);
  const Vector3f normal = normalOf(input, point);
  const float d = input.spacings[point];
  const float offset_limit = offsetLimit(input);
  float nearest = std::numeric_limits<float>::infinity();
  std::int32_t label = -1;
  grid.forEachWithin(position, near_spacings * d, [&](std::uint32_t k, float squared) {
    if (labels[k] < 0 || !(squared < nearest))
      return;
    const SurfaceNode& node = nodes[k];
    const float offset = std::abs(node.normal.dot(position - node.position));
    if (std::abs(normal.dot(node.normal)) > same_normal && offset < offset_limit * d) {
      nearest = squared;
      label = labels[k];
    }
  });
  return label;
}

} // namespace

float
nodeCell(const InstanceInput& input)
{
  return node_spacings * medianSpacing(input);
}

float
nodeGridCell(const InstanceInput& input)
{
  return max_chord * medianSpacing(input);
}

float
nodeReach()
{
  return std::max(node_spacings, fit_spacings);
}

float
linkReach()
{
  return std::max(max_chord, 0.5f * max_chord + middle_spacings);
}

float
pieceReach()
{
  return near_spacings;
}

std::vector<std::vector<std::uint32_t>>
linksOf(const InstanceInput& input,
        const std::vector<SurfaceNode>& nodes,
        const PointGrid& grid,
        std::size_t count)
{
  const float step_limit = stepLimit(input);
  std::vector<std::vector<std::uint32_t>> links(count);
  kernels::parallelForEach(count, input.threads, [&](std::size_t k) {
    links[k] = linksFrom(nodes[k], nodes, grid, step_limit);
  });
  return links;
}

Labels
labelsAt(const InstanceInput& input,
         const std::vector<char>& members,
         const std::vector<SurfaceNode>& nodes,
         const PointGrid& grid,
         const Labels& labels_of_nodes)
{
  Labels labels(members.size(), -1);
  kernels::parallelForEach(members.size(), input.threads, [&](std::size_t i) {
    if (members[i])
      labels[i] = labelAt(input, i, nodes, grid, labels_of_nodes);
  });
  return labels;
}

std::vector<SurfaceNode>
surfaceNodes(const InstanceInput& input,
             const PointGrid& points,
             const std::vector<char>& members)
{
  const std::vector<std::uint32_t> candidates =
      pointsInOrder(input, [&](std::uint32_t i) { return members[i] != 0; });
  const std::vector<std::uint32_t> chosen =
      centralPoints(input.points, candidates, nodeCell(input));
  std::vector<SurfaceNode> nodes(chosen.size());
  kernels::parallelForEach(chosen.size(), input.threads, [&](std::size_t k) {
    nodes[k] = fitAt(input, chosen[k], points, members);
  });
  const auto is_none = [](const SurfaceNode& node) { return node.spacing == 0.0f; };
  nodes.erase(std::remove_if(nodes.begin(), nodes.end(), is_none), nodes.end());
  return nodes;
}

Labels
smoothPieces(const InstanceInput& input,
             const PointGrid& grid,
             const std::vector<char>& members)
{
  const std::vector<SurfaceNode> nodes = surfaceNodes(input, grid, members);
  const PointGrid node_grid(positionsOf(nodes), nodeGridCell(input));
  const Labels labels =
      splitSurfaces(input, nodes, linkedNodes(input, nodes, node_grid));
  Labels pieces = labelsAt(input, members, nodes, node_grid, labels);
  sortLabels(input, 1, pieces);
  return pieces;
}

} // namespace pcl::segmentation
