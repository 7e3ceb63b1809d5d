/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "surface_nodes.h"

#include "../kernels/parallel.h"
#include "disjoint_sets.h"
#include "surface_steps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

namespace pcl::segmentation {

using detail::InstanceInput;
using Eigen::Vector3f;

namespace {

// In spacings d; doc/instances.md has the reason of each number.
constexpr float cell_spacings = 1.5f;
constexpr float fit_spacings = 1.5f;
constexpr int least_points = 5;
constexpr float least_chord = 2.0f, most_chord = 4.5f;
constexpr float middle_spacings = 1.2f;
constexpr float label_spacings = 3.0f;
constexpr float same_surface = 0.878f;  // cosine of 0.5 rad, the least turn of a crease
constexpr float same_direction = 0.94f; // cosine of 20 degrees
constexpr float inner_share = 0.4f;
constexpr float step_spacings = 3.5f; // the radius of a paraboloid
constexpr float step_gain = 0.4f;
constexpr float least_noise = 0.03f;
constexpr float least_step = 0.1f, step_per_noise = 1.0f;
constexpr float beside_step = 0.8f;

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
} // namespace

SurfaceNodes::SurfaceNodes(const InstanceInput& input,
                           const PointGrid& points,
                           const std::vector<char>& members)
: input_(input)
, step_limit_(stepLimit(input))
, offset_limit_(offsetLimit(input))
, nodes_(fit(points, members))
, grid_(positions(), most_chord * medianSpacing(input))
{}

Links
SurfaceNodes::links() const
{
  Links links(nodes_.size());
  kernels::parallelForRanges(
      nodes_.size(), input_.threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
          links[k] = linksOf(k);
      });
  for (auto& of_node : links)
    of_node.erase(
        std::remove_if(of_node.begin(),
                       of_node.end(),
                       [&](std::uint32_t other) { return links[other].empty(); }),
        of_node.end());
  return links;
}

std::int32_t
SurfaceNodes::labelAt(std::size_t point, const Labels& labels) const
{
  const Vector3f position = positionOf(input_.points, point);
  const Vector3f normal = normalOf(input_, point);
  const float d = input_.spacings[point];
  float nearest = std::numeric_limits<float>::infinity();
  std::int32_t label = -1;
  grid_.forEachWithin(
      position, label_spacings * d, [&](std::uint32_t k, float squared) {
        if (labels[k] < 0 || !(squared < nearest))
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

std::vector<SurfaceNode>
SurfaceNodes::fit(const PointGrid& points, const std::vector<char>& members) const
{
  const auto chosen =
      representatives(input_, members, cell_spacings * medianSpacing(input_));
  std::vector<SurfaceNode> nodes(chosen.size());
  kernels::parallelForRanges(
      chosen.size(), input_.threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
          nodes[k] = fitAt(chosen[k], points, members);
      });
  nodes.erase(
      std::remove_if(nodes.begin(),
                     nodes.end(),
                     [](const SurfaceNode& node) { return node.spacing == 0.0f; }),
      nodes.end());
  return nodes;
}

SurfaceNode
SurfaceNodes::fitAt(std::size_t i,
                    const PointGrid& points,
                    const std::vector<char>& members) const
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
          input_.spacings[i],
          isOnStep(i, points, members) ? 1.0f : 0.0f};
}

bool
SurfaceNodes::isOnStep(std::size_t i,
                       const PointGrid& points,
                       const std::vector<char>& members) const
{
  const Vector3f position = positionOf(input_.points, i);
  const Vector3f normal = normalOf(input_, i);
  const float d = input_.spacings[i];
  std::vector<Vector3f> around;
  points.forEachWithin(position, step_spacings * d, [&](std::uint32_t j, float) {
    if (members[j] && std::abs(normal.dot(normalOf(input_, j))) > same_surface)
      around.emplace_back((positionOf(input_.points, j) - position) / d);
  });
  const SurfaceStep step = largestStep(around, normal, least_noise);
  return step.gain > step_gain &&
         step.height > least_step + step_per_noise * static_cast<float>(input_.noise);
}

XYZView
SurfaceNodes::positions() const
{
  constexpr std::size_t stride = sizeof(SurfaceNode) / sizeof(float);
  return {nodes_.empty() ? nullptr : nodes_[0].center.data(), stride, nodes_.size()};
}

std::vector<std::uint32_t>
SurfaceNodes::linksOf(std::size_t k) const
{
  const SurfaceNode& node = nodes_[k];
  if (node.on_step > 0.0f)
    return {};
  const float least = least_chord * least_chord * node.spacing * node.spacing;
  std::size_t candidates = 0;
  std::vector<std::uint32_t> links;
  grid_.forEachWithin(
      node.center, most_chord * node.spacing, [&](std::uint32_t j, float squared) {
        if (squared < least)
          return;
        ++candidates;
        if (nodes_[j].on_step == 0.0f && isSmooth(node, nodes_[j]) &&
            hasMiddle(node, nodes_[j]))
          links.push_back(j);
      });
  if (static_cast<float>(links.size()) < inner_share * static_cast<float>(candidates))
    links.clear();
  return links;
}

/** Two points of a circle, or of a line: the chord is square to the mean normal. */
bool
SurfaceNodes::isSmooth(const SurfaceNode& a, const SurfaceNode& b) const
{
  const float cosine = a.normal.dot(b.normal);
  if (!(std::abs(cosine) > same_surface))
    return false;
  const float sign = cosine < 0.0f ? -1.0f : 1.0f;
  const float step =
      0.5f * std::abs((a.normal + sign * b.normal).dot(b.center - a.center));
  return step < step_limit_ * std::min(a.spacing, b.spacing);
}

/** There is surface between two nodes, and no step. */
bool
SurfaceNodes::hasMiddle(const SurfaceNode& a, const SurfaceNode& b) const
{
  const Vector3f between = b.center - a.center;
  bool has_step = false, has_surface = false;
  for (const float share : {0.25f, 0.5f, 0.75f}) {
    const Vector3f position = a.center + share * between;
    const float beside = beside_step * a.spacing;
    grid_.forEachWithin(
        position, middle_spacings * a.spacing, [&](std::uint32_t k, float squared) {
          has_surface = has_surface || share == 0.5f;
          has_step =
              has_step || (nodes_[k].on_step > 0.0f && squared < beside * beside);
        });
  }
  return has_surface && !has_step;
}

Labels
componentsOf(const Links& links)
{
  DisjointSets sets(links.size());
  for (std::size_t k = 0; k < links.size(); ++k)
    for (const std::uint32_t other : links[k])
      sets.unite(static_cast<std::uint32_t>(k), other);
  Labels labels(links.size(), -1);
  for (std::size_t k = 0; k < links.size(); ++k)
    if (!links[k].empty())
      labels[k] = static_cast<std::int32_t>(sets.find(static_cast<std::uint32_t>(k)));
  return labels;
}

} // namespace pcl::segmentation
