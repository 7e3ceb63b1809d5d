// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "instances/smooth_pieces.h"

#include "common/disjoint_sets.h"
#include "common/finite.h"
#include "common/parallel.h"
#include "common/statistics.h"
#include "instances/piece_splitting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

namespace pcl::segmentation {
namespace {

using detail::InstanceInput;
using Eigen::Vector3f;

constexpr float fit_spacings = 1.5f;
constexpr int least_points = 5;

/** The member that is nearest to the middle of each cell of space, cells in the order
 * of their coordinates. */
std::vector<std::size_t>
representatives(const InstanceInput& input,
                const std::vector<char>& members,
                float cell)
{
  struct Entry {
    std::array<float, 3> cell;
    float off_center;
    std::array<float, 3> position;
    std::size_t point;
  };
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (!members[i])
      continue;
    const Eigen::Array3f p = positionOf(input.points, i).array() / cell;
    const Eigen::Array3f c = p.floor();
    const float* xyz = input.points[i];
    entries.push_back({{c.x(), c.y(), c.z()},
                       (p - c - 0.5f).matrix().squaredNorm(),
                       {xyz[0], xyz[1], xyz[2]},
                       i});
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.cell, a.off_center, a.position, a.point) <
           std::tie(b.cell, b.off_center, b.position, b.point);
  });
  std::vector<std::size_t> chosen;
  for (std::size_t k = 0; k < entries.size(); ++k)
    if (k == 0 || entries[k].cell != entries[k - 1].cell)
      chosen.push_back(entries[k].point);
  return chosen;
}

/** Without a spacing if there are too few members. */
SurfaceNode
fitAt(const InstanceInput& input,
      std::size_t i,
      const PointGrid& points,
      const std::vector<char>& members)
{
  const Vector3f position = positionOf(input.points, i);
  const Vector3f own = normalOf(input, i);
  Vector3f sum = Vector3f::Zero(), normals = sum;
  Eigen::Matrix3f squares = Eigen::Matrix3f::Zero();
  int count = 0;
  points.forEachWithin(
      position, fit_spacings * input.spacings[i], [&](std::uint32_t j, float) {
        if (!members[j])
          return;
        const Vector3f between = positionOf(input.points, j) - position;
        sum += between;
        squares += between * between.transpose();
        const Vector3f normal = normalOf(input, j);
        normals += normal.dot(own) < 0.0f ? Vector3f(-normal) : normal;
        ++count;
      });
  if (count < least_points)
    return {};
  const Vector3f mean = sum / static_cast<float>(count);
  const Vector3f normal = normals.normalized();
  const float variance = normal.dot(squares * normal) / static_cast<float>(count) -
                         normal.dot(mean) * normal.dot(mean);
  const float spacing = input.spacings[i];
  return {
      position + mean, normal, spacing, std::sqrt(std::max(0.0f, variance)) / spacing};
}

} // namespace

std::vector<SurfaceNode>
surfaceNodes(const InstanceInput& input,
             const PointGrid& points,
             const std::vector<char>& members)
{
  const auto chosen =
      representatives(input, members, node_spacings * medianSpacing(input));
  std::vector<SurfaceNode> nodes(chosen.size());
  kernels::parallelForRanges(
      chosen.size(), input.threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
          nodes[k] = fitAt(input, chosen[k], points, members);
      });
  nodes.erase(
      std::remove_if(nodes.begin(),
                     nodes.end(),
                     [](const SurfaceNode& node) { return node.spacing == 0.0f; }),
      nodes.end());
  return nodes;
}

namespace {

using detail::InstanceInput;
using Eigen::Vector3f;

// In spacings d; doc/instances.md has the reason of each number.
constexpr float least_chord = 2.0f, most_chord = 4.5f;
constexpr float middle_spacings = 1.2f;
constexpr float same_direction = 0.94f; // cosine of 20 degrees
constexpr float core_share = 0.4f;

/** Nodes on a surface, and which of them it runs between without a step or a crease. */
class SurfaceNodes {
public:
  SurfaceNodes(const InstanceInput& input,
               const PointGrid& points,
               const std::vector<char>& members)
  : input_(input)
  , step_limit_(stepLimit(input))
  , offset_limit_(offsetLimit(input))
  , nodes_(surfaceNodes(input, points, members))
  , grid_(centersOf(nodes_), most_chord * medianSpacing(input))
  {}

  const std::vector<SurfaceNode>&
  nodes() const
  {
    return nodes_;
  }

  /** A label for each node, -1 where the surface runs to too few around it. */
  Labels
  components() const
  {
    std::vector<std::vector<std::uint32_t>> links(nodes_.size());
    std::vector<char> is_core(nodes_.size(), 0);
    kernels::parallelForRanges(
        nodes_.size(), input_.threads, [&](std::size_t begin, std::size_t end) {
          for (std::size_t k = begin; k < end; ++k)
            is_core[k] = findLinks(k, links[k]) ? 1 : 0;
        });
    DisjointSets sets(nodes_.size());
    for (std::size_t k = 0; k < nodes_.size(); ++k)
      for (const std::uint32_t other : links[k])
        if (is_core[k] && is_core[other])
          sets.unite(static_cast<std::uint32_t>(k), other);
    Labels labels(nodes_.size(), -1);
    for (std::size_t k = 0; k < nodes_.size(); ++k)
      if (is_core[k])
        labels[k] = static_cast<std::int32_t>(sets.find(static_cast<std::uint32_t>(k)));
    return labels;
  }

  /** The label of the nearest node with one whose surface a point is on; -1 if there is
   * none. */
  std::int32_t
  labelAt(std::size_t point, const Labels& labels) const
  {
    const Vector3f position = positionOf(input_.points, point);
    const Vector3f normal = normalOf(input_, point);
    const float d = input_.spacings[point];
    float nearest = std::numeric_limits<float>::infinity();
    std::int32_t label = -1;
    grid_.forEachWithin(position, most_chord * d, [&](std::uint32_t k, float squared) {
      if (labels[k] < 0 || !(squared < nearest) ||
          squared > 4.0f * node_spacings * node_spacings * d * d)
        return;
      const SurfaceNode& node = nodes_[k];
      const float offset = std::abs(node.normal.dot(position - node.center));
      if (std::abs(normal.dot(node.normal)) > same_direction &&
          offset < offset_limit_ * d) {
        nearest = squared;
        label = labels[k];
      }
    });
    return label;
  }

private:
  /** \return whether the surface runs to enough of the nodes around */
  bool
  findLinks(std::size_t k, std::vector<std::uint32_t>& links) const
  {
    const SurfaceNode& node = nodes_[k];
    const float least = least_chord * least_chord * node.spacing * node.spacing;
    int candidates = 0;
    grid_.forEachWithin(
        node.center, most_chord * node.spacing, [&](std::uint32_t j, float squared) {
          if (squared < least)
            return;
          ++candidates;
          if (isSmooth(node, nodes_[j]) && hasMiddle(node, nodes_[j]))
            links.push_back(j);
        });
    return !links.empty() && static_cast<float>(links.size()) >=
                                 core_share * static_cast<float>(candidates);
  }

  /** Two points of a circle, or of a line: the chord is square to the mean normal. */
  bool
  isSmooth(const SurfaceNode& a, const SurfaceNode& b) const
  {
    const float cosine = a.normal.dot(b.normal);
    if (!(std::abs(cosine) > same_surface))
      return false;
    const float sign = cosine < 0.0f ? -1.0f : 1.0f;
    const float step =
        0.5f * std::abs((a.normal + sign * b.normal).dot(b.center - a.center));
    return step < step_limit_ * std::min(a.spacing, b.spacing);
  }

  /** There is surface between two nodes. */
  bool
  hasMiddle(const SurfaceNode& a, const SurfaceNode& b) const
  {
    const Vector3f middle = 0.5f * (a.center + b.center);
    bool found = false;
    grid_.forEachWithin(middle, middle_spacings * a.spacing, [&](std::uint32_t, float) {
      found = true;
    });
    return found;
  }

  const InstanceInput& input_;
  float step_limit_;
  float offset_limit_;
  std::vector<SurfaceNode> nodes_;
  PointGrid grid_;
};

} // namespace

float
medianSpacing(const InstanceInput& input)
{
  return medianSpacing(input.spacings);
}

float
offsetLimit(const InstanceInput& input)
{
  return 0.3f + 2.5f * static_cast<float>(input.noise);
}

float
stepLimit(const InstanceInput& input)
{
  return 0.15f + 1.25f * static_cast<float>(input.noise);
}

Labels
smoothPieces(const InstanceInput& input,
             const PointGrid& grid,
             const std::vector<char>& members)
{
  const SurfaceNodes nodes(input, grid, members);
  const Labels labels = splitSurfaces(input, nodes.nodes(), nodes.components());
  Labels pieces(members.size(), -1);
  kernels::parallelForRanges(
      members.size(), input.threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
          if (members[i])
            pieces[i] = nodes.labelAt(i, labels);
      });
  sortLabels(input, 1, pieces);
  return pieces;
}

} // namespace pcl::segmentation
