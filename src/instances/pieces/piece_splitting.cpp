// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Pieces cut into planes, cylinders and spheres where these do not meet.

#include "instances/pieces/piece_splitting.h"

#include "common/disjoint_sets.h"
#include "common/parallel.h"
#include "common/quiet.h"

#include <Eigen/Geometry>

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

constexpr int rounds = 5;           // of assigning nodes: few change after that
constexpr float smoothing = 4.0f;   // others around count as much as two tolerances
constexpr double covered = 0.8;     // of a part's nodes: the others may be at its rim
constexpr int refinements = 2;      // of surfaces: nodes hardly change their part then
constexpr double described = 0.8;   // of a piece: less is nothing like primitives
constexpr float curved_gap = 1.25f; // primitives only resemble other curved surfaces
constexpr float clearly_worse = 2.0f; // one primitive than two, both up to noise
constexpr double both_sides = 0.25;   // of the larger side: noise makes less
// Around the middle of a border of length L, a strip that goes on has 1.44 L^2
// within 1.5 L on either side, a surface that only touches there half a disc, 3.5 L^2.
constexpr float neck_reach = 1.5f;
constexpr double min_neck_area = 2.25;
constexpr double node_area = double{node_spacings} * node_spacings; // squared spacings

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
using PartOfNode = std::vector<std::uint32_t>;

PartOfNode
partOfNodes(const SurfacePiece& piece, const std::vector<SurfacePart>& parts)
{
  PartOfNode part_of(piece.nodes.size(), none);
  for (std::uint32_t p = 0; p < parts.size(); ++p)
    for (const std::uint32_t node : parts[p].nodes)
      part_of[node] = p;
  return part_of;
}

/** The part for a node: its surface is near, and nodes around it belong to it. None if
 * no surface is near. */
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
  float min_cost = std::numeric_limits<float>::infinity();
  std::uint32_t best = none;
  for (std::uint32_t part = 0; part < parts.size(); ++part) {
    if (votes[part] == 0.0f)
      continue;
    const float distance = piece.distanceTo(parts[part].surface, node);
    if (!(distance < piece.gap_limit))
      continue;
    const float ratio = distance / piece.tolerance;
    const float cost = ratio * ratio + smoothing * (1.0f - votes[part] / all);
    if (cost < min_cost) {
      min_cost = cost;
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
      const float limit = isCurved(parts[q]) ? piece.gap_limit : piece.tolerance;
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
  PartOfNode part_of = partOfNodes(piece, parts);
  for (SurfacePart& part : parts)
    part.nodes.clear();
  for (int round = 0; round < rounds; ++round)
    for (std::uint32_t node = 0; node < piece.nodes.size(); ++node)
      part_of[node] = bestPart(piece, node, parts, part_of);
  for (std::uint32_t node = 0; node < piece.nodes.size(); ++node)
    if (part_of[node] != none)
      parts[part_of[node]].nodes.push_back(node);
  std::stable_sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) {
    return a.nodes.size() > b.nodes.size();
  });
}

/** Drop parts with few nodes, or with nodes on the surfaces of others.
 * \return whether there were any */
bool
dropNeedless(const SurfacePiece& piece, std::vector<SurfacePart>& parts)
{
  const std::size_t before = parts.size();
  for (std::size_t p = parts.size(); p-- > 0;)
    if (parts[p].nodes.size() < min_part_nodes || isCovered(piece, p, parts))
      parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(p));
  return parts.size() < before;
}

/** How two parts meet. */
struct Border {
  double pairs = 0.0;        ///< of nodes
  double squared_gaps = 0.0; ///< between the two surfaces, in spacings
  double cosines = 0.0;      ///< of their normals
  double steps = 0.0;        ///< squared, between nodes, in spacings
  /** How far the nodes of either are before and behind the other's surface. */
  std::array<double, 2> before{}, behind{};
  Eigen::AlignedBox3f places; ///< of the middles of the pairs
};

using Pair = std::pair<std::uint32_t, std::uint32_t>;
using Borders = std::map<Pair, Border>;

void
addSide(const SurfaceNode& node,
        const ShapePrimitive& other,
        std::size_t which,
        Border& border)
{
  const Vector3f away = node.position - footOn(other, node.position);
  const double side = away.dot(normalOf(other, node.position)) / node.spacing;
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
  const Vector3f middle = 0.5f * (node.position + other.position);
  const float area = node.spacing * other.spacing;
  const float sign = node.normal.dot(other.normal) < 0.0f ? -1.0f : 1.0f;
  const Vector3f normal = 0.5f * (node.normal + sign * other.normal);
  const float step = normal.dot(other.position - node.position);
  ++border.pairs;
  border.places.extend(middle);
  border.squared_gaps += (footOn(a, middle) - footOn(b, middle)).squaredNorm() / area;
  border.cosines += std::abs(normalOf(a, middle).dot(normalOf(b, middle)));
  border.steps += step * step / area;
  addSide(node, b, 0, border);
  addSide(other, a, 1, border);
}

Borders
bordersOf(const SurfacePiece& piece, const std::vector<SurfacePart>& parts)
{
  const PartOfNode part_of = partOfNodes(piece, parts);
  Borders borders;
  for (std::uint32_t node = 0; node < piece.nodes.size(); ++node) {
    const std::uint32_t p = part_of[node];
    if (p == none)
      continue;
    piece.forEachAround(node, [&](std::uint32_t other) {
      const std::uint32_t q = part_of[other];
      if (q != none && q > p)
        addPair(piece.nodes[node],
                piece.nodes[other],
                parts[p].surface,
                parts[q].surface,
                borders[{p, q}]);
    });
  }
  return borders;
}

/** Whether there is no crease, and gaps (or steps) are within a limit.
 * \param[in] squares sum of the squared gaps or steps */
bool
goesOn(const Border& border, double squares, float limit)
{
  return squares < limit * limit * border.pairs &&
         border.cosines > same_surface * border.pairs;
}

/** Whether the nodes continue across, whatever the primitives beside them say. */
bool
isSmooth(const Border& border, const SurfacePiece& piece)
{
  return goesOn(border, border.steps, piece.node_noise);
}

/** Surfaces that cross are on both sides of each other, those at a crease are not. */
bool
crosses(const Border& border, float tolerance)
{
  const auto is_on_both_sides = [&](std::size_t which) {
    const auto [smaller, larger] =
        std::minmax(border.before[which], border.behind[which]);
    return smaller > both_sides * larger;
  };
  return border.squared_gaps > tolerance * tolerance * border.pairs &&
         is_on_both_sides(0) && is_on_both_sides(1);
}

/** Whether both parts are wider than their border, a bridge of few nodes. */
bool
isNeck(const SurfacePiece& piece,
       const SurfacePart& a,
       const SurfacePart& b,
       const Border& border)
{
  // As long as two nodes are apart at least: one pair of nodes is one place.
  const float length = std::max(border.places.diagonal().norm(), node_spacings);
  const auto isWide = [&](const SurfacePart& part) {
    const auto near = std::count_if(part.nodes.begin(), part.nodes.end(), [&](auto k) {
      return (piece.nodes[k].position - border.places.center()).norm() <
             neck_reach * length;
    });
    return node_area * static_cast<double>(near) > min_neck_area * length * length;
  };
  return isWide(a) && isWide(b);
}

bool
areOne(const SurfacePiece& piece,
       const SurfacePart& a,
       const SurfacePart& b,
       const Border& border)
{
  if (isNeck(piece, a, b, border))
    return false;
  const bool is_smooth = isSmooth(border, piece);
  if (!isCurved(a) && !isCurved(b)) {
    const float limit =
        is_smooth ? std::max(piece.gap_limit, 2.0f * piece.tolerance) : piece.gap_limit;
    return goesOn(border, border.squared_gaps, limit) &&
           !crosses(border, piece.tolerance);
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
  if (apart < piece.node_noise)
    return as_one < clearly_worse * apart;
  return as_one < piece.gap_limit ||
         goesOn(border, border.squared_gaps, curved_gap * piece.gap_limit);
}

/** The group that shares the longest border with a group; itself if it has no border.
 */
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
    if (size < piece.min_size)
      sets.unite(group, neighborOf(group, borders, sets));
  }
}

/** The groups of nodes that a piece falls into; none if it stays whole. */
std::vector<NodeIndices>
cut(const SurfacePiece& piece)
{
  if (piece.isOne(piece.allNodes()))
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
  if (static_cast<double>(on_parts) <
      described * static_cast<double>(piece.nodes.size()))
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

void
assignNodes(const SurfacePiece& piece, std::vector<SurfacePart>& parts)
{
  do
    assign(piece, parts);
  while (dropNeedless(piece, parts));
}

std::vector<NodeIndices>
joinParts(const SurfacePiece& piece, const std::vector<SurfacePart>& parts)
{
  DisjointSets sets(parts.size());
  const Borders borders = bordersOf(piece, parts);
  for (const auto& [pair, border] : borders) {
    const SurfacePart& a = parts[pair.first];
    const SurfacePart& b = parts[pair.second];
    const bool are_large = std::min(a.nodes.size(), b.nodes.size()) >= piece.min_size;
    if (are_large ? areOne(piece, a, b, border) : isSmooth(border, piece))
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
    if (nodes.size() >= piece.min_size)
      joined.push_back(std::move(nodes));
  return joined;
}

std::vector<std::vector<NodeIndices>>
cutPieces(std::size_t pieces,
          const std::function<std::vector<SurfaceNode>(std::size_t)>& nodesOf,
          double noise,
          unsigned threads)
{
  std::vector<std::vector<NodeIndices>> groups(pieces);
  const detail::Quiet quiet;
  kernels::parallelFor(pieces, threads, [&](std::size_t i) {
    groups[i] = cut({nodesOf(i), static_cast<float>(noise)});
  });
  return groups;
}

Labels
splitSurfaces(const detail::InstanceInput& input,
              const std::vector<SurfaceNode>& nodes,
              Labels labels)
{
  const std::vector<NodeIndices> pieces = piecesOf(labels);
  const auto nodesOf = [&](std::size_t i) {
    std::vector<SurfaceNode> of_piece;
    for (const std::uint32_t node : pieces[i])
      of_piece.push_back(nodes[node]);
    return of_piece;
  };
  const std::vector<std::vector<NodeIndices>> groups =
      cutPieces(pieces.size(), nodesOf, input.noise, input.threads);
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
