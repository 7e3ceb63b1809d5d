// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "instances/label_growth.h"

#include "common/finite.h"
#include "common/parallel.h"
#include "instances/smooth_pieces.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace pcl::segmentation {
namespace {

using detail::InstanceInput;
using Eigen::Vector3f;

// In spacings; doc/instances.md has the reason of each number.
constexpr float reach = 1.0f;
constexpr float band_spacings = 1.02f, band_per_noise = 4.0f; // as edges are wide
constexpr float least_curvature_radius = 5.0f;

class Front {
public:
  Front(const InstanceInput& input,
        const PointGrid& grid,
        const Growth& growth,
        Labels& labels)
  : input_(input)
  , grid_(grid)
  , growth_(growth)
  , labels_(labels)
  , anchors_(labels.size(), -1)
  , limit_(offsetLimit(input))
  {
    for (std::size_t i = 0; i < labels.size(); ++i)
      if (labels[i] >= 0)
        anchors_[i] = static_cast<std::int64_t>(i);
      else if (growth.open[i] && kernels::isFinite(input.points[i]))
        waiting_.push_back(i);
  }

  /** \return whether a point took a label */
  bool
  advance()
  {
    std::vector<std::int64_t> found(waiting_.size(), -1);
    kernels::parallelForRanges(
        waiting_.size(), input_.threads, [&](std::size_t begin, std::size_t end) {
          for (std::size_t k = begin; k < end; ++k)
            found[k] = bestAnchor(waiting_[k]);
        });
    std::vector<std::size_t> still_waiting;
    for (std::size_t k = 0; k < waiting_.size(); ++k) {
      const std::size_t i = waiting_[k];
      if (found[k] < 0) {
        still_waiting.push_back(i);
        continue;
      }
      anchors_[i] = found[k];
      labels_[i] = labels_[static_cast<std::size_t>(found[k])];
    }
    const bool changed = still_waiting.size() < waiting_.size();
    waiting_ = std::move(still_waiting);
    return changed;
  }

private:
  /** The labelled point whose surface, continued, is nearest to a point; -1 if none is
   * near enough. */
  std::int64_t
  bestAnchor(std::size_t i) const
  {
    const Vector3f position = positionOf(input_.points, i);
    std::tuple<float, float, std::int32_t> best;
    std::int64_t result = -1;
    grid_.forEachWithin(
        position, reach * input_.spacings[i], [&](std::uint32_t j, float) {
          if (anchors_[j] < 0)
            return;
          const auto anchor = static_cast<std::size_t>(anchors_[j]);
          const Vector3f between = position - positionOf(input_.points, anchor);
          const float d = input_.spacings[i];
          const float squared = between.squaredNorm() / (d * d);
          const float offset = std::abs(normalOf(input_, anchor).dot(between)) / d;
          const float most = limit_ + squared / (2.0f * least_curvature_radius);
          if (growth_.fitting && !(offset < most))
            return;
          const std::tuple<float, float, std::int32_t> cost(
              offset, squared, labels_[anchor]);
          if (result < 0 || cost < best) {
            best = cost;
            result = static_cast<std::int64_t>(anchor);
          }
        });
    return result;
  }

  const InstanceInput& input_;
  const PointGrid& grid_;
  const Growth& growth_;
  Labels& labels_;
  std::vector<std::int64_t> anchors_; ///< the point that gave the label
  std::vector<std::size_t> waiting_;
  float limit_;
};

} // namespace

void
growLabels(const InstanceInput& input,
           const PointGrid& grid,
           const Growth& growth,
           Labels& labels)
{
  const float band =
      2.0f * (band_spacings + band_per_noise * static_cast<float>(input.noise));
  const int rounds = static_cast<int>(std::ceil(band / (0.5f * reach)));
  Front front(input, grid, growth, labels);
  for (int round = 0; round < rounds && front.advance(); ++round)
    ;
}

using detail::InstanceInput;

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
