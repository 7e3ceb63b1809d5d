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
#include "disjoint_sets.h"
#include "median.h"
#include "surface_nodes.h"
#include "surface_split.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::segmentation {
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
