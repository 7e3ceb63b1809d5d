// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Matches found instances with true ones.

#include "instance_scores.h"

#include "evaluation/evaluation.h"

#include <algorithm>
#include <map>
#include <utility>

namespace instances {
namespace {

constexpr std::size_t least_points = 300;
constexpr double found_iou = 0.7, near_iou = 0.1;
constexpr double most = 0.5, part = 0.2;

struct Overlaps {
  std::map<std::uint32_t, std::size_t> truths, predictions;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> common;

  double
  iou(std::uint32_t truth, std::uint32_t predicted) const
  {
    const auto both = common.find({truth, predicted});
    if (both == common.end())
      return 0.0;
    const std::size_t all = truths.at(truth) + predictions.at(predicted) - both->second;
    return static_cast<double>(both->second) / static_cast<double>(all);
  }

  /** The share of a true instance that a predicted one has. */
  double
  share(std::uint32_t truth, std::uint32_t predicted) const
  {
    const auto both = common.find({truth, predicted});
    return both == common.end() ? 0.0
                                : static_cast<double>(both->second) /
                                      static_cast<double>(truths.at(truth));
  }
};

void
judge(const Overlaps& overlaps, std::uint32_t truth, Scores& scores)
{
  std::size_t parts = 0;
  bool is_found = false, is_merged = false;
  for (const auto& prediction : overlaps.predictions) {
    const std::uint32_t p = prediction.first;
    is_found = is_found || overlaps.iou(truth, p) >= found_iou;
    parts += overlaps.share(truth, p) >= part ? 1 : 0;
    if (overlaps.share(truth, p) < most)
      continue;
    for (const auto& other : overlaps.truths)
      is_merged = is_merged || (other.first != truth && other.second >= least_points &&
                                overlaps.share(other.first, p) >= most);
  }
  ++scores.instances;
  if (is_found)
    ++scores.found;
  else if (is_merged)
    ++scores.merged;
  else if (parts > 1)
    ++scores.split;
  else
    ++scores.missed;
}

} // namespace

Scores&
Scores::operator+=(const Scores& other)
{
  clouds += other.clouds;
  point_f1 += other.point_f1;
  instances += other.instances;
  found += other.found;
  merged += other.merged;
  split += other.split;
  missed += other.missed;
  extra += other.extra;
  milliseconds += other.milliseconds;
  return *this;
}

Scores
scoresOf(const InstanceCloud& cloud, const Labels& predicted)
{
  Overlaps overlaps;
  std::vector<pcl::app::LabelPair> pairs;
  for (std::size_t i = 0; i < cloud.truth.size(); ++i) {
    if (!cloud.evaluated[i])
      continue;
    const std::uint32_t truth = cloud.truth[i], found = predicted[i];
    pairs.push_back({truth, found});
    if (truth != 0)
      ++overlaps.truths[truth];
    if (found != 0)
      ++overlaps.predictions[found];
    if (truth != 0 && found != 0)
      ++overlaps.common[{truth, found}];
  }
  Scores scores;
  scores.clouds = 1;
  scores.point_f1 = pcl::app::evaluateInstances(pairs).points.f1();
  for (const auto& truth : overlaps.truths)
    if (truth.second >= least_points)
      judge(overlaps, truth.first, scores);
  for (const auto& prediction : overlaps.predictions)
    scores.extra += std::none_of(
        overlaps.truths.begin(), overlaps.truths.end(), [&](const auto& t) {
          return overlaps.iou(t.first, prediction.first) >= near_iou;
        });
  return scores;
}

} // namespace instances
