// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Counts hits and misses and matches instances.

#include "evaluation/evaluation.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <tuple>

namespace pcl::app {
namespace {

constexpr double min_matching_iou = 0.5; // two cannot both overlap one by more

double
ratio(double part, double whole)
{
  return whole > 0.0 ? part / whole : std::numeric_limits<double>::quiet_NaN();
}

double
ratio(std::uint64_t part, std::uint64_t whole)
{
  return ratio(static_cast<double>(part), static_cast<double>(whole));
}

void
countPoint(const LabelPair& point, ClassScore& of)
{
  const bool is_true = point.truth == of.label;
  const bool is_predicted = point.predicted == of.label;
  of.score.true_positives += is_true && is_predicted;
  of.score.false_positives += !is_true && is_predicted;
  of.score.false_negatives += is_true && !is_predicted;
}

struct Overlap {
  double iou;
  std::uint32_t truth;
  std::uint32_t predicted;
  std::uint64_t points;
};

/** All that could match, best first. */
std::vector<Overlap>
matchingOverlaps(
    const std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint64_t>& common,
    const std::map<std::uint32_t, std::uint64_t>& truth_sizes,
    const std::map<std::uint32_t, std::uint64_t>& predicted_sizes)
{
  std::vector<Overlap> overlaps;
  for (const auto& [labels, points] : common) {
    const auto [truth, predicted] = labels;
    const auto united = truth_sizes.at(truth) + predicted_sizes.at(predicted) - points;
    const double iou = ratio(points, united);
    if (iou >= min_matching_iou)
      overlaps.push_back({iou, truth, predicted, points});
  }
  std::sort(overlaps.begin(), overlaps.end(), [](const Overlap& a, const Overlap& b) {
    return std::make_tuple(-a.iou, a.truth, a.predicted) <
           std::make_tuple(-b.iou, b.truth, b.predicted);
  });
  return overlaps;
}

} // namespace

double
Score::precision() const
{
  return ratio(true_positives, true_positives + false_positives);
}

double
Score::recall() const
{
  return ratio(true_positives, true_positives + false_negatives);
}

double
Score::f1() const
{
  return ratio(2 * true_positives,
               2 * true_positives + false_positives + false_negatives);
}

double
Score::iou() const
{
  return ratio(true_positives, true_positives + false_positives + false_negatives);
}

Evaluation
evaluateLabels(const std::vector<LabelPair>& points, std::vector<ClassScore> classes)
{
  std::set<std::uint32_t> labels;
  for (const ClassScore& of : classes)
    labels.insert(of.label);
  const auto classOf = [&](std::uint32_t label) {
    return labels.count(label) != 0 ? std::int64_t{label} : std::int64_t{-1};
  };
  std::uint64_t right = 0;
  for (const LabelPair& point : points) {
    right += classOf(point.truth) == classOf(point.predicted);
    for (ClassScore& of : classes)
      countPoint(point, of);
  }
  Evaluation evaluation;
  evaluation.accuracy = ratio(right, std::uint64_t{points.size()});
  double sum = 0.0;
  for (const ClassScore& of : classes)
    sum += of.score.iou();
  evaluation.mean_iou = ratio(sum, static_cast<double>(classes.size()));
  evaluation.classes = std::move(classes);
  return evaluation;
}

InstanceEvaluation
evaluateInstances(const std::vector<LabelPair>& points)
{
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint64_t> common;
  std::map<std::uint32_t, std::uint64_t> truth_sizes;
  std::map<std::uint32_t, std::uint64_t> predicted_sizes;
  std::uint64_t truth_points = 0;
  std::uint64_t predicted_points = 0;
  for (const auto& [truth, predicted] : points) {
    if (truth != 0)
      ++truth_sizes[truth], ++truth_points;
    if (predicted != 0)
      ++predicted_sizes[predicted], ++predicted_points;
    if (truth != 0 && predicted != 0)
      ++common[{truth, predicted}];
  }

  InstanceEvaluation evaluation;
  std::set<std::uint32_t> matched_truth;
  std::set<std::uint32_t> matched_predicted;
  double sum = 0.0;
  for (const Overlap& overlap :
       matchingOverlaps(common, truth_sizes, predicted_sizes)) {
    if (matched_truth.count(overlap.truth) != 0 ||
        matched_predicted.count(overlap.predicted) != 0)
      continue;
    matched_truth.insert(overlap.truth);
    matched_predicted.insert(overlap.predicted);
    evaluation.points.true_positives += overlap.points;
    sum += overlap.iou;
  }
  const std::uint64_t matches = matched_truth.size();
  evaluation.points.false_positives =
      predicted_points - evaluation.points.true_positives;
  evaluation.points.false_negatives = truth_points - evaluation.points.true_positives;
  evaluation.instances = {
      matches, predicted_sizes.size() - matches, truth_sizes.size() - matches};
  evaluation.mean_matched_iou = ratio(sum, static_cast<double>(matches));
  return evaluation;
}

} // namespace pcl::app
