// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "surfaces/evidence_averaging.h"

#include "common/finite.h"
#include "common/parallel.h"
#include "common/statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace pcl::segmentation {
namespace {

using detail::FieldInput;
using Eigen::Vector3f;

// doc/method.md has the reason of each number.
constexpr float node_spacings = 1.5f;
constexpr float reach_spacings = 5.0f;
constexpr float across_weight = 0.05f;    // of an edge point, and of another direction
constexpr float same_direction = 0.7071f; // cosine of 45 degrees

std::vector<std::size_t>
chooseNodes(const XYZView& points, float cell, const std::vector<bool>& is_known)
{
  const auto offCenter = [&](std::size_t i) {
    const Eigen::Array3f p = positionOf(points, i).array() / cell;
    return (p - p.floor() - 0.5f).matrix().squaredNorm();
  };
  std::map<std::array<float, 3>, std::size_t> nodes;
  for (std::size_t i = 0; i < points.size; ++i) {
    if (!is_known[i])
      continue;
    const Eigen::Array3f c = (positionOf(points, i).array() / cell).floor();
    const auto [node, is_new] =
        nodes.try_emplace(std::array<float, 3>{c.x(), c.y(), c.z()}, i);
    if (!is_new && offCenter(i) < offCenter(node->second))
      node->second = i;
  }
  std::vector<std::size_t> chosen;
  chosen.reserve(nodes.size());
  for (const auto& [key, i] : nodes)
    chosen.push_back(i);
  return chosen;
}

PointGrid
gridOf(const XYZView& points, const std::vector<std::size_t>& nodes, float cell)
{
  std::vector<Vector3f> positions;
  positions.reserve(nodes.size());
  for (const std::size_t i : nodes)
    positions.push_back(positionOf(points, i));
  const float* first = positions.empty() ? nullptr : positions[0].data();
  return {{first, 3, positions.size()}, cell};
}

} // namespace

EvidenceNodes::EvidenceNodes(const FieldInput& input,
                             const ShapeField& edges,
                             const std::vector<bool>& is_known)
: input_(input)
, edges_(edges)
, points_(chooseNodes(input.points, node_spacings * median(edges.spacings), is_known))
, grid_(gridOf(input.points, points_, reach_spacings * median(edges.spacings)))
{
  std::vector<std::size_t> in_order;
  in_order.reserve(points_.size());
  for (const std::uint32_t k : grid_.order()) {
    const std::size_t i = points_[k];
    in_order.push_back(i);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      positions_[axis].push_back(input.points[i][axis]);
      normals_[axis].push_back(edges.normals[i][static_cast<Eigen::Index>(axis)]);
    }
    weights_.push_back(edges.edge_likelihood[i] > 0.5f ? across_weight : 1.0f);
  }
  points_ = std::move(in_order);
}

float
EvidenceNodes::reachOf(std::size_t point) const
{
  return reach_spacings * edges_.spacings[point];
}

void
EvidenceNodes::weigh(std::size_t first,
                     std::size_t point,
                     float squared_radius,
                     std::vector<float>& weights) const
{
  const float* p = input_.points[point];
  const float* n = edges_.normals[point].data();
  const float *x = &positions_[0][first], *y = &positions_[1][first],
              *z = &positions_[2][first];
  const float *nx = &normals_[0][first], *ny = &normals_[1][first],
              *nz = &normals_[2][first];
  const float* weight = &weights_[first];
  float* result = weights.data();
  const float px = p[0], py = p[1], pz = p[2], qx = n[0], qy = n[1], qz = n[2];
  const std::size_t count = weights.size();
#pragma omp simd
  for (std::size_t k = 0; k < count; ++k) {
    const float dx = x[k] - px, dy = y[k] - py, dz = z[k] - pz;
    const float squared = dx * dx + (dy * dy + dz * dz);
    const float cosine = nx[k] * qx + (ny[k] * qy + nz[k] * qz);
    const float turn = std::abs(cosine) > same_direction ? 1.0f : across_weight;
    const float near = squared < squared_radius ? 1.0f : 0.0f;
    result[k] = weight[k] * turn * near;
  }
}

namespace {

using detail::FieldInput;

constexpr int rounds = 4; // doc/method.md has the reason

std::vector<bool>
knownPoints(const FieldInput& input,
            const ShapeField& edges,
            const std::vector<float>& evidence,
            std::size_t classes)
{
  std::vector<bool> is_known(input.points.size);
  for (std::size_t i = 0; i < is_known.size(); ++i)
    is_known[i] = kernels::isFinite(input.points[i]) &&
                  !std::isnan(evidence[i * classes]) &&
                  kernels::isFinite(edges.normals[i].data());
  return is_known;
}

/** A value for each node, class by class. */
using NodeValues = std::vector<std::vector<float>>;

float
sumOf(const std::vector<float>& weights)
{
  const std::size_t count = weights.size();
  const float* weight = weights.data();
  float sum = 0.0f;
#pragma omp simd reduction(+ : sum)
  for (std::size_t k = 0; k < count; ++k)
    sum += weight[k];
  return sum;
}

float
productOf(const std::vector<float>& weights, const float* values)
{
  const std::size_t count = weights.size();
  const float* weight = weights.data();
  float sum = 0.0f;
#pragma omp simd reduction(+ : sum)
  for (std::size_t k = 0; k < count; ++k)
    sum += weight[k] * values[k];
  return sum;
}

/** The mean over the nodes that a point hears of; false if there is none. */
bool
meanAt(std::size_t point,
       const EvidenceNodes& nodes,
       const NodeValues& values,
       std::vector<float>& scratch,
       float* mean)
{
  float total = 0.0f;
  std::fill_n(mean, values.size(), 0.0f);
  const auto add = [&](std::size_t first, const std::vector<float>& weights) {
    total += sumOf(weights);
    for (std::size_t c = 0; c < values.size(); ++c)
      mean[c] += productOf(weights, &values[c][first]);
  };
  nodes.forEachRange(point, scratch, add);
  for (std::size_t c = 0; c < values.size(); ++c)
    mean[c] /= total;
  return total > 0.0f;
}

NodeValues
averaged(const NodeValues& values, const EvidenceNodes& nodes, unsigned threads)
{
  NodeValues result(values.size(), std::vector<float>(nodes.size()));
  kernels::parallelForRanges(
      nodes.size(), threads, [&](std::size_t begin, std::size_t end) {
        std::vector<float> scratch, mean(values.size());
        for (std::size_t k = begin; k < end; ++k) {
          meanAt(nodes.point(k), nodes, values, scratch, mean.data());
          for (std::size_t c = 0; c < values.size(); ++c)
            result[c][k] = mean[c];
        }
      });
  return result;
}

} // namespace

std::vector<float>
averageEvidence(const FieldInput& input,
                const ShapeField& edges,
                std::vector<float> evidence,
                std::size_t classes)
{
  const std::vector<bool> is_known = knownPoints(input, edges, evidence, classes);
  const EvidenceNodes nodes(input, edges, is_known);
  NodeValues values(classes);
  for (std::size_t c = 0; c < classes; ++c)
    for (std::size_t k = 0; k < nodes.size(); ++k)
      values[c].push_back(evidence[nodes.point(k) * classes + c]);
  for (int round = 1; round < rounds; ++round)
    values = averaged(values, nodes, input.threads);
  kernels::parallelForRanges(
      input.points.size, input.threads, [&](std::size_t begin, std::size_t end) {
        std::vector<float> scratch, mean(classes);
        for (std::size_t i = begin; i < end; ++i)
          if (is_known[i] && meanAt(i, nodes, values, scratch, mean.data()))
            std::copy_n(mean.data(), classes, &evidence[i * classes]);
      });
  return evidence;
}

} // namespace pcl::segmentation
