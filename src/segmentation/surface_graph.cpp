/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "surface_graph.h"

#include "../kernels/finite.h"
#include "../kernels/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace pcl::segmentation {
namespace {

using detail::InstanceInput;
using Eigen::Vector3f;

// In spacings d; doc/instances.md has the reason of each number.
constexpr float cell_spacings = 1.5f;
constexpr float fit_spacings = 1.5f;
constexpr int least_points = 5;
constexpr float least_chord = 2.0f, most_chord = 4.5f;
constexpr float middle_spacings = 1.2f;
constexpr float same_surface = 0.878f;  // cosine of 0.5 rad, the least turn of a crease
constexpr float same_direction = 0.94f; // cosine of 20 degrees
constexpr float core_share = 0.4f;

/** A forest whose trees are sets of points; the root is the smallest index. */
class DisjointSets {
public:
  explicit DisjointSets(std::size_t size) : parent_(size)
  {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }

  std::uint32_t
  find(std::uint32_t i)
  {
    while (parent_[i] != i)
      i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  void
  unite(std::uint32_t i, std::uint32_t j)
  {
    i = find(i);
    j = find(j);
    parent_[std::max(i, j)] = std::min(i, j);
  }

private:
  std::vector<std::uint32_t> parent_;
};

/** A member that stands for those around it. */
struct Node {
  Vector3f center;
  Vector3f normal;
  float spacing = 0.0f;
};

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

/** Nodes on a surface, and which of them it runs between without a step or a crease. */
class SurfaceNodes {
public:
  SurfaceNodes(const InstanceInput& input,
               const PointGrid& points,
               const std::vector<char>& members)
  : input_(input)
  , step_limit_(stepLimit(input))
  , offset_limit_(offsetLimit(input))
  , nodes_(fit(points, members))
  , grid_(positions(), most_chord * medianSpacing(input))
  {}

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
          squared > 4.0f * cell_spacings * cell_spacings * d * d)
        return;
      const Node& node = nodes_[k];
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
  std::vector<Node>
  fit(const PointGrid& points, const std::vector<char>& members) const
  {
    const auto chosen =
        representatives(input_, members, cell_spacings * medianSpacing(input_));
    std::vector<Node> nodes(chosen.size());
    kernels::parallelForRanges(
        chosen.size(), input_.threads, [&](std::size_t begin, std::size_t end) {
          for (std::size_t k = begin; k < end; ++k)
            nodes[k] = fitAt(chosen[k], points, members);
        });
    nodes.erase(std::remove_if(nodes.begin(),
                               nodes.end(),
                               [](const Node& node) { return node.spacing == 0.0f; }),
                nodes.end());
    return nodes;
  }

  /** Without a spacing if there are too few members. */
  Node
  fitAt(std::size_t i, const PointGrid& points, const std::vector<char>& members) const
  {
    const Vector3f position = positionOf(input_.points, i);
    const Vector3f own = normalOf(input_, i);
    Vector3f sum = Vector3f::Zero(), normals = sum;
    int count = 0;
    points.forEachWithin(
        position, fit_spacings * input_.spacings[i], [&](std::uint32_t j, float) {
          if (!members[j])
            return;
          sum += positionOf(input_.points, j) - position;
          const Vector3f normal = normalOf(input_, j);
          normals += normal.dot(own) < 0.0f ? Vector3f(-normal) : normal;
          ++count;
        });
    if (count < least_points)
      return {};
    return {position + sum / static_cast<float>(count),
            normals.normalized(),
            input_.spacings[i]};
  }

  XYZView
  positions() const
  {
    constexpr std::size_t stride = sizeof(Node) / sizeof(float);
    return {nodes_.empty() ? nullptr : nodes_[0].center.data(), stride, nodes_.size()};
  }

  /** \return whether the surface runs to enough of the nodes around */
  bool
  findLinks(std::size_t k, std::vector<std::uint32_t>& links) const
  {
    const Node& node = nodes_[k];
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
  isSmooth(const Node& a, const Node& b) const
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
  hasMiddle(const Node& a, const Node& b) const
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
  std::vector<Node> nodes_;
  PointGrid grid_;
};

} // namespace

float
medianSpacing(const InstanceInput& input)
{
  std::vector<float> sorted;
  for (const float spacing : input.spacings)
    if (std::isfinite(spacing))
      sorted.push_back(spacing);
  if (sorted.empty())
    return 1.0f;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  return *middle;
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
  const Labels labels = nodes.components();
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

void
sortLabels(const InstanceInput& input, std::size_t min_points, Labels& labels)
{
  struct Entry {
    std::size_t points = 0;
    std::tuple<float, float, float> first;
    std::size_t label = 0;
  };
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] < 0)
      continue;
    const auto label = static_cast<std::size_t>(labels[i]);
    if (entries.size() <= label)
      entries.resize(label + 1);
    const float* p = input.points[i];
    const std::tuple<float, float, float> position(p[0], p[1], p[2]);
    Entry& entry = entries[label];
    entry.first = entry.points++ == 0 ? position : std::min(entry.first, position);
    entry.label = label;
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return a.points != b.points ? a.points > b.points : a.first < b.first;
  });
  std::vector<std::int32_t> renamed(entries.size(), -1);
  std::int32_t next = 0;
  for (const Entry& entry : entries)
    if (entry.points >= std::max<std::size_t>(1, min_points))
      renamed[entry.label] = next++;
  for (std::int32_t& label : labels)
    if (label >= 0)
      label = renamed[static_cast<std::size_t>(label)];
}

} // namespace pcl::segmentation
