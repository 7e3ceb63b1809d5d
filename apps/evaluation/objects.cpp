// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Counts what instances and objects share, and matches them.

#include "evaluation/objects.h"

#include "evaluation/assignment.h"

#include <iterator>
#include <limits>
#include <map>
#include <utility>

namespace pcl::app {
namespace {

using Sizes = std::map<std::uint32_t, std::uint64_t>;

struct Counts {
  Sizes objects;   ///< of enough points
  Sizes instances; ///< all
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint64_t> common;
};

Counts
countPoints(const std::vector<LabelPair>& points, const ObjectRules& rules)
{
  Counts counts;
  for (const auto& [truth, predicted] : points) {
    const std::uint32_t object = truth / rules.parts;
    if (object != 0)
      ++counts.objects[object];
    if (predicted != 0)
      ++counts.instances[predicted];
    if (object != 0 && predicted != 0)
      ++counts.common[{object, predicted}];
  }
  for (auto object = counts.objects.begin(); object != counts.objects.end();)
    object = object->second < rules.min_points ? counts.objects.erase(object)
                                               : std::next(object);
  return counts;
}

/** Of an object and an instance as if they were alone. */
Score
scoreOfPair(const Counts& counts, std::uint32_t object, std::uint32_t instance)
{
  const auto shared = counts.common.find({object, instance});
  const std::uint64_t hits = shared == counts.common.end() ? 0 : shared->second;
  return {hits, counts.instances.at(instance) - hits, counts.objects.at(object) - hits};
}

std::uint64_t
sumOf(const Sizes& sizes)
{
  std::uint64_t sum = 0;
  for (const auto& [label, points] : sizes)
    sum += points;
  return sum;
}

} // namespace

double
ObjectEvaluation::foundShare() const
{
  return objects > 0 ? static_cast<double>(found) / static_cast<double>(objects)
                     : std::numeric_limits<double>::quiet_NaN();
}

ObjectEvaluation
evaluateObjects(const std::vector<LabelPair>& points, const ObjectRules& rules)
{
  const Counts counts = countPoints(points, rules);
  std::vector<std::vector<Score>> pairs;
  std::vector<std::vector<double>> gains;
  for (const auto& [object, size] : counts.objects) {
    auto& row = pairs.emplace_back();
    auto& row_gains = gains.emplace_back();
    for (const auto& [instance, instance_size] : counts.instances) {
      row.push_back(scoreOfPair(counts, object, instance));
      row_gains.push_back(row.back().f1());
    }
  }

  ObjectEvaluation evaluation;
  const auto instances = bestAssignment(gains);
  for (std::size_t object = 0; object < instances.size(); ++object)
    if (instances[object]) {
      const Score& pair = pairs[object][*instances[object]];
      evaluation.overlap.true_positives += pair.true_positives;
      evaluation.found += pair.iou() >= min_found_iou;
    }
  evaluation.overlap.false_positives =
      sumOf(counts.instances) - evaluation.overlap.true_positives;
  evaluation.overlap.false_negatives =
      sumOf(counts.objects) - evaluation.overlap.true_positives;
  evaluation.objects = counts.objects.size();
  evaluation.instances = counts.instances.size();
  return evaluation;
}

} // namespace pcl::app
