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

#include <algorithm>
#include <array>
#include <cmath>
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

} // namespace pcl::segmentation
