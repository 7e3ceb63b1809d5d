// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Writes the results of a comparison as JSON.

#include "report.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace peers {
namespace {

using Json = nlohmann::ordered_json;

/** Precision, recall and so on of every class, whose names come before; where the truth
 * has none of the class looked for, only what does not need it. */
Json
numbersOf(const Trial& trial, float threshold)
{
  const pcl::app::Evaluation evaluation = evaluate(trial, threshold);
  const std::string& looked_for = trial.truth->classes.front().name;
  Json numbers{{"seconds", trial.seconds}};
  for (const pcl::app::ClassScore& of : evaluation.classes) {
    if (of.name == looked_for && !trial.truth->hasAny())
      continue;
    const std::map<std::string, double> values{{"f1", of.score.f1()},
                                               {"precision", of.score.precision()},
                                               {"recall", of.score.recall()},
                                               {"iou", of.score.iou()}};
    for (const auto& [name, value] : values)
      numbers[of.name + "_" + name] = std::isnan(value) ? 0.0 : value;
  }
  if (evaluation.classes.size() > 1 && trial.truth->hasAny())
    numbers["mean_iou"] = evaluation.mean_iou;
  numbers["accuracy"] = evaluation.accuracy;
  return numbers;
}

Json
meansOf(const Json& clouds)
{
  std::map<std::string, std::pair<double, double>> sums;
  for (const Json& cloud : clouds) {
    for (const auto& [name, value] : cloud.items()) {
      if (value.is_number()) {
        sums[name].first += value.get<double>();
        sums[name].second += 1.0;
      }
    }
  }
  Json means;
  for (const auto& [name, sum] : sums)
    means[name] = sum.first / sum.second;
  return means;
}

/** Each setting once, in the order of the clouds. */
std::string
joined(const std::vector<std::string>& settings)
{
  std::string text;
  for (auto setting = settings.begin(); setting != settings.end(); ++setting)
    if (std::find(settings.begin(), setting, *setting) == setting)
      text += (text.empty() ? "" : " or ") + *setting;
  return text;
}

} // namespace

Json
describe(const std::vector<LabeledCloud>& clouds)
{
  Json described;
  for (const LabeledCloud& cloud : clouds) {
    described["clouds"].push_back(
        {{"name", cloud.name}, {"points", cloud.points->size()}});
  }
  return described;
}

Json
toJson(const Result& result)
{
  Json clouds = Json::array();
  for (std::size_t i = 0; i < result.trials.size(); ++i) {
    Json numbers = numbersOf(result.trials[i], result.thresholds[i]);
    numbers["cloud"] = result.trials[i].cloud->name;
    clouds.push_back(numbers);
  }
  const auto [least, most] =
      std::minmax_element(result.thresholds.begin(), result.thresholds.end());
  return {{"peer", result.peer},
          {"setting", joined(result.settings)},
          {"threshold", *least},
          {"max_threshold", *most},
          {"tuned", result.is_tuned},
          {"mean", meansOf(clouds)},
          {"clouds", clouds}};
}

} // namespace peers
