/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "evidence_averaging.h"

#include "../kernels/finite.h"
#include "../kernels/parallel.h"
#include "median.h"
#include "point_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace pcl::segmentation {
namespace {

using detail::AdaptiveEdges;
using detail::AdaptiveInput;
using Eigen::Vector3f;

// doc/method.md has the reason of each number.
constexpr float node_spacings = 1.5f;
constexpr float reach_spacings = 5.0f;
constexpr float across_weight = 0.05f;    // of an edge point, and of another direction
constexpr float same_direction = 0.7071f; // cosine of 45 degrees
constexpr int rounds = 4;

class Averaging {
public:
  Averaging(const AdaptiveInput& input,
            const AdaptiveEdges& edges,
            const std::vector<float>& evidence,
            std::size_t classes)
  : input_(input)
  , edges_(edges)
  , classes_(classes)
  , spacing_(median(edges.spacings))
  , nodes_(chooseNodes(evidence))
  , grid_(positionsOf(nodes_), 0.5f * reach_spacings * spacing_)
  {}

  std::vector<float>
  run(std::vector<float> evidence) const
  {
    std::vector<float> at_nodes(nodes_.size() * classes_);
    for (std::size_t k = 0; k < nodes_.size(); ++k)
      std::copy_n(&evidence[nodes_[k] * classes_], classes_, &at_nodes[k * classes_]);
    const Neighbors neighbors = neighborsOf(nodes_);
    for (int round = 1; round < rounds; ++round)
      at_nodes = averaged(at_nodes, neighbors);
    averageAtPoints(at_nodes, evidence);
    return evidence;
  }

private:
  struct Neighbor {
    std::uint32_t node;
    float weight;
  };
  using Neighbors = std::vector<std::vector<Neighbor>>;

  bool
  isKnown(const std::vector<float>& evidence, std::size_t i) const
  {
    return !std::isnan(evidence[i * classes_]) && normalAt(i).allFinite();
  }

  Vector3f
  normalAt(std::size_t i) const
  {
    return Eigen::Map<const Vector3f>(&edges_.normals[3 * i]);
  }

  std::vector<std::size_t>
  chooseNodes(const std::vector<float>& evidence)
  {
    const float cell = node_spacings * spacing_;
    const auto keyOf = [&](const Vector3f& p) {
      const Eigen::Array3f c = (p.array() / cell).floor();
      return std::array<float, 3>{c.x(), c.y(), c.z()};
    };
    const auto offCenter = [&](std::size_t i) {
      const Eigen::Array3f p = positionOf(input_.points, i).array() / cell;
      return (p - p.floor() - 0.5f).matrix().squaredNorm();
    };
    std::map<std::array<float, 3>, std::size_t> nodes;
    for (std::size_t i = 0; i < input_.points.size; ++i) {
      if (!kernels::isFinite(input_.points[i]) || !isKnown(evidence, i))
        continue;
      const auto [node, is_new] =
          nodes.try_emplace(keyOf(positionOf(input_.points, i)), i);
      if (!is_new && offCenter(i) < offCenter(node->second))
        node->second = i;
    }
    std::vector<std::size_t> chosen;
    chosen.reserve(nodes.size());
    for (const auto& [key, i] : nodes)
      chosen.push_back(i);
    return chosen;
  }

  XYZView
  positionsOf(const std::vector<std::size_t>& nodes)
  {
    for (const std::size_t i : nodes)
      positions_.push_back(positionOf(input_.points, i));
    return {positions_.empty() ? nullptr : positions_[0].data(), 3, positions_.size()};
  }

  float
  weightOf(const Vector3f& normal, std::size_t node) const
  {
    const std::size_t j = nodes_[node];
    const float edge = edges_.likelihood[j] > 0.5f ? across_weight : 1.0f;
    const float turn =
        std::abs(normal.dot(normalAt(j))) > same_direction ? 1.0f : across_weight;
    return edge * turn;
  }

  template <typename Visit>
  void
  forEachNeighbor(std::size_t i, const Visit& visit) const
  {
    const Vector3f normal = normalAt(i);
    grid_.forEachWithin(positionOf(input_.points, i),
                        reach_spacings * edges_.spacings[i],
                        [&](std::uint32_t k, float) { visit(k, weightOf(normal, k)); });
  }

  Neighbors
  neighborsOf(const std::vector<std::size_t>& points) const
  {
    Neighbors neighbors(points.size());
    kernels::parallelForRanges(
        points.size(), input_.threads, [&](std::size_t begin, std::size_t end) {
          for (std::size_t k = begin; k < end; ++k)
            forEachNeighbor(points[k], [&](std::uint32_t j, float weight) {
              neighbors[k].push_back({j, weight});
            });
        });
    return neighbors;
  }

  std::vector<float>
  averaged(const std::vector<float>& values, const Neighbors& neighbors) const
  {
    std::vector<float> result(values.size());
    kernels::parallelForRanges(
        neighbors.size(), input_.threads, [&](std::size_t begin, std::size_t end) {
          for (std::size_t k = begin; k < end; ++k) {
            float weights = 0.0f;
            float* sums = &result[k * classes_];
            for (const Neighbor& n : neighbors[k]) {
              for (std::size_t c = 0; c < classes_; ++c)
                sums[c] += n.weight * values[n.node * classes_ + c];
              weights += n.weight;
            }
            for (std::size_t c = 0; c < classes_; ++c)
              sums[c] /= weights;
          }
        });
    return result;
  }

  /** Where no node is near, the evidence stays what it is. */
  void
  averageAtPoints(const std::vector<float>& at_nodes,
                  std::vector<float>& evidence) const
  {
    kernels::parallelForRanges(
        input_.points.size, input_.threads, [&](std::size_t begin, std::size_t end) {
          std::vector<float> sums(classes_);
          for (std::size_t i = begin; i < end; ++i) {
            if (!kernels::isFinite(input_.points[i]) || !isKnown(evidence, i))
              continue;
            std::fill(sums.begin(), sums.end(), 0.0f);
            float weights = 0.0f;
            forEachNeighbor(i, [&](std::uint32_t k, float weight) {
              for (std::size_t c = 0; c < classes_; ++c)
                sums[c] += weight * at_nodes[k * classes_ + c];
              weights += weight;
            });
            for (std::size_t c = 0; weights > 0.0f && c < classes_; ++c)
              evidence[i * classes_ + c] = sums[c] / weights;
          }
        });
  }

  const AdaptiveInput& input_;
  const AdaptiveEdges& edges_;
  std::size_t classes_;
  float spacing_;
  std::vector<std::size_t> nodes_;
  std::vector<Vector3f> positions_;
  PointGrid grid_;
};

} // namespace

std::vector<float>
averageEvidence(const AdaptiveInput& input,
                const AdaptiveEdges& edges,
                std::vector<float> evidence,
                std::size_t classes)
{
  const Averaging averaging(input, edges, evidence, classes);
  return averaging.run(std::move(evidence));
}

} // namespace pcl::segmentation
