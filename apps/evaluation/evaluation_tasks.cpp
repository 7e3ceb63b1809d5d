// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The tasks: which points of the truth count, and how predictions are read.

#include "evaluation/evaluation_tasks.h"

#include "io/errors.h"

#include <pcl/common/point_tests.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

namespace pcl::app {
namespace {

using Labels = std::vector<std::uint32_t>;

constexpr std::uint32_t unknown_label = 0;
constexpr std::uint32_t planar = 1;
constexpr std::uint32_t curved = 2;
constexpr std::uint32_t crease = 3;

using Label = std::optional<std::uint32_t>;

/** The label of a true value, or nothing if it is left out. */
using TruthRule = Label (*)(std::uint32_t);

constexpr TruthRule zero_or_one = [](std::uint32_t value) {
  return value <= 1 ? Label(value) : std::nullopt;
};
constexpr TruthRule crease_of_surface = [](std::uint32_t surface) {
  return surface > 0 ? Label(surface == crease) : std::nullopt;
};
constexpr TruthRule strict_surface = [](std::uint32_t surface) {
  return surface == planar || surface == curved ? Label(surface) : std::nullopt;
};
constexpr TruthRule paper_surface = [](std::uint32_t surface) {
  return surface > 0 ? Label(std::min(surface, curved)) : std::nullopt;
};
constexpr TruthRule known_label = [](std::uint32_t label) {
  return label != unknown_label ? Label(label) : std::nullopt;
};
constexpr TruthRule every_label = [](std::uint32_t label) { return Label(label); };

/** How a prediction says that it does not know. */
enum class Unknown {
  never,
  label_zero,
  likelihood_nan ///< in the field <predicted field>_likelihood, if there is one
};

struct Task {
  std::string truth_field;
  std::string predicted_field;
  Unknown unknown;
  TruthRule rule;
  std::vector<ClassScore> classes;
};

Task
taskOf(const std::string& name, Convention convention, const CloudFile& truth)
{
  const bool paper = convention == Convention::paper;
  const ClassScore planar_class{"planar", planar, {}};
  const ClassScore curved_class{"curved", curved, {}};
  if (name == "edge")
    return {paper ? "surface" : "edge",
            "edge",
            Unknown::likelihood_nan,
            paper ? crease_of_surface : zero_or_one,
            {{"edge", 1, {}}}};
  if (name == "planar" || name == "curved") {
    Task task{"surface",
              "surface",
              Unknown::label_zero,
              paper ? paper_surface : strict_surface,
              {planar_class, curved_class}};
    if (name == "curved")
      std::swap(task.classes[0], task.classes[1]);
    return task;
  }
  if (paper)
    throw UsageError("-convention 'paper' with -task '" + name +
                     "'; expected strict, or -task edge, planar or curved");
  if (name == "ground")
    return {
        "ground", "ground", Unknown::likelihood_nan, zero_or_one, {{"ground", 1, {}}}};
  if (name == "label")
    return {"label", "label", Unknown::label_zero, known_label, {}};
  const std::string field = name == "objects" ? fieldOfObjects(truth) : "instance";
  return {field, "instance", Unknown::never, every_label, {}};
}

[[noreturn]] void
failForOtherPoints(const std::string& what)
{
  throw InputError(what + "; expected the same points in the same order: predict on "
                          "the cloud of the truth file");
}

/** The points of the truth. If both clouds have coordinates, they must agree, up to
 * what formats round. */
pcl::PointCloud<pcl::PointXYZ>::Ptr
samePoints(const CloudFile& predicted, const CloudFile& truth)
{
  if (predicted.size() != truth.size())
    failForOtherPoints(predicted.path + ": " + std::to_string(predicted.size()) +
                       " points, but " + truth.path + " has " +
                       std::to_string(truth.size()) + " (" +
                       std::to_string(countFinite(*pointsOf(truth))) + " finite)");
  const auto a = pointsOf(predicted), b = pointsOf(truth);
  Eigen::AlignedBox3f box;
  for (const pcl::PointXYZ& point : *b)
    if (pcl::isXYZFinite(point))
      box.extend(point.getVector3fMap());
  const float tolerance = 1e-3f * box.diagonal().norm(); // text may round to mm
  for (std::size_t i = 0; i < a->size(); ++i) {
    const Eigen::Vector3f p = (*a)[i].getVector3fMap(), q = (*b)[i].getVector3fMap();
    if (p.allFinite() && q.allFinite() && (p - q).norm() > tolerance)
      failForOtherPoints(predicted.path + ": point " + std::to_string(i) + " is " +
                         std::to_string((p - q).norm()) + " m away from that of " +
                         truth.path);
  }
  return b;
}

std::vector<bool>
unknownPredictions(const Task& task, const CloudFile& cloud, const Labels& labels)
{
  std::vector<bool> unknown(labels.size(), false);
  const std::string likelihood_field = task.predicted_field + "_likelihood";
  if (task.unknown == Unknown::label_zero) {
    for (std::size_t i = 0; i < labels.size(); ++i)
      unknown[i] = labels[i] == unknown_label;
  }
  else if (task.unknown == Unknown::likelihood_nan &&
           findField(cloud, likelihood_field)) {
    const std::vector<float> likelihoods = floatsOf(cloud, likelihood_field);
    for (std::size_t i = 0; i < labels.size(); ++i)
      unknown[i] = std::isnan(likelihoods[i]);
  }
  return unknown;
}

/** Planar 1, curved 2, edge 3 of a truth that has surface and edge instead of label;
 * what is hard to tell by hand is left out: near a crease but no edge, silhouettes. */
Labels
labelsOfScene(const CloudFile& truth)
{
  constexpr std::uint32_t is_edge = 1;
  const Labels surfaces = labelsOf(truth, "surface");
  Labels labels = labelsOf(truth, "edge");
  for (std::size_t i = 0; i < labels.size(); ++i)
    labels[i] = labels[i] == is_edge ? crease
                : labels[i] == 0 ? strict_surface(surfaces[i]).value_or(unknown_label)
                                 : unknown_label;
  return labels;
}

bool
isScene(const CloudFile& truth)
{
  return !findField(truth, "label") && findField(truth, "surface") &&
         findField(truth, "edge");
}

/** Every label that the truth has. */
std::vector<ClassScore>
classesOf(const std::vector<LabelPair>& points)
{
  std::set<std::uint32_t> labels;
  for (const LabelPair& point : points)
    labels.insert(point.truth);
  std::vector<ClassScore> classes;
  classes.reserve(labels.size());
  for (const std::uint32_t label : labels)
    classes.push_back({std::to_string(label), label, {}});
  return classes;
}

} // namespace

std::string
fieldOfObjects(const CloudFile& truth)
{
  if (findField(truth, "instance"))
    return "instance";
  if (findField(truth, "label"))
    return "label";
  throw InputError(truth.path + ": no field of objects; expected instance or label");
}

const std::vector<std::string>&
taskNames()
{
  static const std::vector<std::string> names{
      "edge", "planar", "curved", "instance", "objects", "label", "ground", "grasps"};
  return names;
}

TaskPoints
selectPoints(const std::string& task_name,
             Convention convention,
             const CloudFile& predicted,
             const CloudFile& truth)
{
  const Task task = taskOf(task_name, convention, truth);
  const auto coordinates = samePoints(predicted, truth);
  const bool of_scene = task_name == "label" && isScene(truth);
  const Labels truths =
      of_scene ? labelsOfScene(truth) : labelsOf(truth, task.truth_field);
  const Labels predictions = labelsOf(predicted, task.predicted_field);
  const std::vector<bool> unknown = unknownPredictions(task, predicted, predictions);

  TaskPoints selected;
  for (std::size_t i = 0; i < truths.size(); ++i) {
    const auto label = task.rule(truths[i]);
    if (!label || !pcl::isXYZFinite((*coordinates)[i]))
      continue;
    selected.points.push_back({*label, unknown[i] ? unknown_label : predictions[i]});
    selected.indices.push_back(i);
    selected.unknown += unknown[i];
  }
  if (!of_scene && predictions == truths)
    selected.copied_field = task.predicted_field;
  if (selected.points.empty())
    throw InputError(truth.path + ": field '" + task.truth_field +
                     "' has no point to evaluate; expected a cloud with at least one");
  selected.classes = task.classes;
  if (of_scene)
    selected.classes = {
        {"planar", planar, {}}, {"curved", curved, {}}, {"edge", crease, {}}};
  else if (task_name == "label")
    selected.classes = classesOf(selected.points);
  return selected;
}

std::vector<std::uint32_t>
outcomesOf(const TaskPoints& selected, std::size_t points)
{
  std::vector<std::uint32_t> outcomes(points,
                                      static_cast<std::uint32_t>(Outcome::left_out));
  const std::uint32_t label = selected.classes.front().label;
  for (std::size_t p = 0; p < selected.points.size(); ++p) {
    const bool is_true = selected.points[p].truth == label;
    const bool is_predicted = selected.points[p].predicted == label;
    const Outcome outcome = is_true ? (is_predicted ? Outcome::hit : Outcome::miss)
                            : is_predicted ? Outcome::false_alarm
                                           : Outcome::rightly_not;
    outcomes[selected.indices[p]] = static_cast<std::uint32_t>(outcome);
  }
  return outcomes;
}

} // namespace pcl::app
