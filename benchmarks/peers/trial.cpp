// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Runs a setting, and finds the threshold that suits it best.

#include "trial.h"

#include "../common/measure.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace peers {
namespace {

constexpr std::size_t candidates = 200;

std::uint32_t
lookedFor(const Truth& truth)
{
  return truth.classes.front().label;
}

/** The class looked for, the other one, or none (0) where the score is unknown. */
std::uint32_t
labelOf(float score, float threshold, const Truth& truth)
{
  if (std::isnan(score))
    return 0;
  return score >= threshold ? lookedFor(truth)
                            : (truth.classes.size() > 1 ? truth.classes[1].label : 0);
}

pcl::app::Score
count(const Trial& trial, float threshold)
{
  pcl::app::Score score;
  for (std::size_t i = 0; i < trial.scores.size(); ++i) {
    const bool is_true = trial.truth->points[i].label == lookedFor(*trial.truth);
    const bool is_found = trial.scores[i] >= threshold; // false for NaN
    score.true_positives += is_true && is_found;
    score.false_positives += !is_true && is_found;
    score.false_negatives += is_true && !is_found;
  }
  return score;
}

std::vector<float>
thresholdsOf(const std::vector<const Trial*>& trials)
{
  std::vector<float> scores;
  for (const Trial* trial : trials) {
    for (std::size_t i = 0; i < trial->scores.size(); ++i)
      if (trial->truth->points[i].label == lookedFor(*trial->truth) &&
          !std::isnan(trial->scores[i]))
        scores.push_back(trial->scores[i]);
  }
  std::sort(scores.begin(), scores.end());
  std::vector<float> thresholds;
  for (std::size_t c = 0; c < candidates && !scores.empty(); ++c)
    thresholds.push_back(scores[c * (scores.size() - 1) / candidates]);
  thresholds.erase(std::unique(thresholds.begin(), thresholds.end()), thresholds.end());
  return thresholds;
}

} // namespace

Trial
run(const Setting& setting, const LabeledCloud& cloud, Task task)
{
  const Truth& truth = task == Task::edges ? cloud.edges : cloud.surfaces;
  Trial trial{&cloud, &truth, {}, 0.0};
  Scores scores;
  trial.seconds =
      1e-3 * processorMillisecondsOf([&] { scores = setting.score(cloud); });
  if (scores.size() != cloud.points->size()) {
    throw std::runtime_error(cloud.name + ", " + setting.text + ": " +
                             std::to_string(scores.size()) +
                             " scores: expected one for each of the " +
                             std::to_string(cloud.points->size()) + " points");
  }
  for (const Truth::Point& point : truth.points)
    trial.scores.push_back(scores[point.index]);
  return trial;
}

pcl::app::Evaluation
evaluate(const Trial& trial, float threshold)
{
  const Truth& truth = *trial.truth;
  std::vector<pcl::app::LabelPair> pairs;
  for (std::size_t i = 0; i < truth.points.size(); ++i) {
    pairs.push_back(
        {truth.points[i].label, labelOf(trial.scores[i], threshold, truth)});
  }
  return pcl::app::evaluateLabels(pairs, truth.classes);
}

double
meanF1(const std::vector<const Trial*>& trials, float threshold)
{
  double sum = 0.0;
  std::size_t clouds = 0;
  for (const Trial* trial : trials) {
    if (trial->truth->hasAny()) {
      sum += count(*trial, threshold).f1();
      ++clouds;
    }
  }
  return clouds > 0 ? sum / static_cast<double>(clouds) : 0.0;
}

float
bestThreshold(const std::vector<const Trial*>& trials)
{
  float best = 0.0f;
  double best_f1 = -1.0;
  for (const float threshold : thresholdsOf(trials)) {
    const double f1 = meanF1(trials, threshold);
    if (f1 > best_f1) {
      best_f1 = f1;
      best = threshold;
    }
  }
  return best;
}

} // namespace peers
