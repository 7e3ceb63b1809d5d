// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Labels of points: how they spread over edges, and in what order they are.

#include "instances/label_growth.h"

#include "common/finite.h"
#include "common/parallel.h"
#include "edges/edge_detection.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace pcl::segmentation {
namespace {

using detail::InstanceInput;
using Eigen::Vector3f;

constexpr float reach = 1.0f; // in spacings: the 12 nearest points
// In spacings: a continued surface may curve this much. Smaller bodies have no nodes.
constexpr float min_curvature_radius = 5.0f;

/** The labeled point whose surface, continued, is nearest to a point; -1 if none is
 * near enough. \param[in] anchors the point that each point has its label from, or -1
 */
std::int64_t
bestAnchor(const InstanceInput& input,
           const PointGrid& grid,
           bool fitting,
           const Labels& labels,
           const std::vector<std::int64_t>& anchors,
           std::size_t i)
{
  const Vector3f position = positionOf(input.points, i);
  const float d = input.spacings[i];
  const float limit = offsetLimit(input);
  std::tuple<float, float, std::int32_t> best;
  std::int64_t result = -1;
  grid.forEachWithin(position, reach * d, [&](std::uint32_t j, float) {
    if (anchors[j] < 0)
      return;
    const auto anchor = static_cast<std::size_t>(anchors[j]);
    const Vector3f between = position - positionOf(input.points, anchor);
    const float squared = between.squaredNorm() / (d * d);
    const float offset = std::abs(normalOf(input, anchor).dot(between)) / d;
    if (fitting && !(offset < limit + squared / (2.0f * min_curvature_radius)))
      return;
    const std::tuple<float, float, std::int32_t> cost(offset, squared, labels[anchor]);
    if (result < 0 || cost < best) {
      best = cost;
      result = anchors[j];
    }
  });
  return result;
}

int
roundsOf(double noise)
{
  const float both_sides = 2.0f * edgeBand(noise);
  return static_cast<int>(std::ceil(both_sides / (0.5f * reach)));
}

} // namespace

float
growthReach(double noise)
{
  return static_cast<float>(roundsOf(noise)) * reach;
}

void
growLabels(const InstanceInput& input,
           const PointGrid& grid,
           const Growth& growth,
           Labels& labels)
{
  std::vector<std::int64_t> anchors(labels.size(), -1);
  std::vector<std::size_t> waiting;
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] >= 0)
      anchors[i] = static_cast<std::int64_t>(i);
    else if (growth.open[i] && kernels::isFinite(input.points[i]))
      waiting.push_back(i);
  const int rounds = roundsOf(input.noise);
  bool changed = true;
  for (int round = 0; round < rounds && changed; ++round) {
    std::vector<std::int64_t> found(waiting.size());
    kernels::parallelForEach(waiting.size(), input.threads, [&](std::size_t k) {
      found[k] = bestAnchor(input, grid, growth.fitting, labels, anchors, waiting[k]);
    });
    std::vector<std::size_t> still_waiting;
    for (std::size_t k = 0; k < waiting.size(); ++k) {
      const std::size_t i = waiting[k];
      anchors[i] = found[k];
      if (found[k] < 0)
        still_waiting.push_back(i);
      else
        labels[i] = labels[static_cast<std::size_t>(found[k])];
    }
    changed = still_waiting.size() < waiting.size();
    waiting = std::move(still_waiting);
  }
}

std::vector<std::int32_t>
ranksOf(const std::vector<LabelSize>& labels, std::size_t min_points)
{
  std::vector<std::size_t> order(labels.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return labels[a].points != labels[b].points ? labels[a].points > labels[b].points
                                                : labels[a].first < labels[b].first;
  });
  std::vector<std::int32_t> ranks(labels.size(), -1);
  std::int32_t next = 0;
  for (const std::size_t label : order)
    if (labels[label].points >= std::max<std::size_t>(1, min_points))
      ranks[label] = next++;
  return ranks;
}

void
sortLabels(const InstanceInput& input, std::size_t min_points, Labels& labels)
{
  std::vector<LabelSize> sizes;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] < 0)
      continue;
    const auto label = static_cast<std::size_t>(labels[i]);
    if (sizes.size() <= label)
      sizes.resize(label + 1);
    const float* p = input.points[i];
    const std::array<float, 3> position{p[0], p[1], p[2]};
    LabelSize& size = sizes[label];
    size.first = size.points++ == 0 ? position : std::min(size.first, position);
  }
  const std::vector<std::int32_t> ranks = ranksOf(sizes, min_points);
  for (std::int32_t& label : labels)
    if (label >= 0)
      label = ranks[static_cast<std::size_t>(label)];
}

} // namespace pcl::segmentation
