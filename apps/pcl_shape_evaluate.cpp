// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// pcl_shape_evaluate: compares a predicted cloud with the truth.

#include "cli/command_line.h"
#include "cli/filter_app.h"
#include "cli/report.h"
#include "evaluation/evaluation_tasks.h"
#include "evaluation/grasps.h"
#include "evaluation/objects.h"
#include "io/any_cloud.h"
#include "io/errors.h"
#include "io/files.h"
#include "io/text.h"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <limits>
#include <optional>

namespace {

using namespace pcl::app;

void
printHeading(const TaskPoints& selected, std::size_t points)
{
  std::printf("%zu points, %zu evaluated, %llu of them with an unknown prediction\n",
              points,
              selected.points.size(),
              static_cast<unsigned long long>(selected.unknown));
  std::printf("%-14s %9s %9s %9s %9s %9s %9s %9s\n",
              "",
              "precision",
              "recall",
              "F1",
              "IoU",
              "TP",
              "FP",
              "FN");
}

void
printScore(const std::string& name, const Score& score)
{
  std::printf("%-14s %9.3f %9.3f %9.3f %9.3f %9llu %9llu %9llu\n",
              name.c_str(),
              score.precision(),
              score.recall(),
              score.f1(),
              score.iou(),
              static_cast<unsigned long long>(score.true_positives),
              static_cast<unsigned long long>(score.false_positives),
              static_cast<unsigned long long>(score.false_negatives));
}

void
reportScore(const std::string& section, const Score& score, Report& report)
{
  report.setNumber(section, "precision", score.precision());
  report.setNumber(section, "recall", score.recall());
  report.setNumber(section, "f1", score.f1());
  report.setNumber(section, "iou", score.iou());
  report.setCount(section, "true_positives", score.true_positives);
  report.setCount(section, "false_positives", score.false_positives);
  report.setCount(section, "false_negatives", score.false_negatives);
}

void
evaluateClasses(const TaskPoints& selected, Report& report)
{
  const Evaluation evaluation = evaluateLabels(selected.points, selected.classes);
  for (const ClassScore& of : evaluation.classes) {
    printScore(of.name, of.score);
    reportScore("classes/" + of.name, of.score, report);
  }
  if (evaluation.classes.size() > 1)
    std::printf("class-mean IoU %.3f\n", evaluation.mean_iou);
  std::printf("accuracy %.3f\n", evaluation.accuracy);
  report.setNumber("", "mean_iou", evaluation.mean_iou);
  report.setNumber("", "accuracy", evaluation.accuracy);
}

/** A void label is not wrong; it only leaves fewer points. */
void
evaluateKept(const TaskPoints& selected, Report& report)
{
  std::uint64_t kept = 0, right = 0;
  for (const LabelPair& point : selected.points) {
    kept += point.predicted != 0;
    right += point.predicted != 0 && point.predicted == point.truth;
  }
  const auto share = [](std::uint64_t part, std::uint64_t whole) {
    return static_cast<double>(part) / static_cast<double>(whole);
  };
  const double kept_share = share(kept, selected.points.size());
  const double kept_precision = share(right, kept);
  std::printf("kept %.4f, of these right %.4f\n", kept_share, kept_precision);
  report.setCount("", "kept_points", kept);
  report.setNumber("", "kept_share", kept_share);
  report.setNumber("", "kept_precision", kept_precision);
}

void
evaluateInstancePoints(const TaskPoints& selected, Report& report)
{
  const InstanceEvaluation evaluation = evaluateInstances(selected.points);
  printScore("points", evaluation.points);
  printScore("instances", evaluation.instances);
  std::printf("mean IoU of the matched instances %.3f\n", evaluation.mean_matched_iou);
  reportScore("points_in_instances", evaluation.points, report);
  reportScore("instances", evaluation.instances, report);
  report.setNumber("", "mean_matched_iou", evaluation.mean_matched_iou);
}

constexpr std::uint64_t max_count = std::numeric_limits<std::uint32_t>::max();

/** \throws UsageError for an option of another task */
ObjectRules
objectRules(const Arguments& arguments, const std::string& task)
{
  for (const char* option : {"parts", "min_points"})
    if (arguments.has(option) && task != "objects" && task != "grasps")
      throw UsageError("-" + std::string(option) + " with -task '" + task +
                       "'; expected -task objects or grasps");
  ObjectRules rules;
  rules.parts = static_cast<std::uint32_t>(
      arguments.integer("parts", 1, max_count).value_or(rules.parts));
  rules.min_points =
      arguments.integer("min_points", 1, max_count).value_or(rules.min_points);
  return rules;
}

void
evaluateObjectPoints(const TaskPoints& selected,
                     const ObjectRules& rules,
                     Report& report)
{
  const ObjectEvaluation evaluation = evaluateObjects(selected.points, rules);
  printScore("overlap", evaluation.overlap);
  std::printf("objects %llu, instances %llu, found with an IoU of %.1f: %llu (%.3f)\n",
              static_cast<unsigned long long>(evaluation.objects),
              static_cast<unsigned long long>(evaluation.instances),
              min_found_iou,
              static_cast<unsigned long long>(evaluation.found),
              evaluation.foundShare());
  report.setCount("parameters", "parts", rules.parts);
  report.setCount("parameters", "min_points", rules.min_points);
  reportScore("overlap", evaluation.overlap, report);
  report.setCount("", "objects", evaluation.objects);
  report.setCount("", "predicted_instances", evaluation.instances);
  report.setCount("", "found", evaluation.found);
  report.setNumber("", "found_share", evaluation.foundShare());
}

std::string
inWords(const ObjectGrasp& of)
{
  if (!of.first)
    return "no grasp";
  if (of.first->seals)
    return "seals";
  std::string words = "leaks:";
  for (const std::string& problem : of.first->problems)
    words += ' ' + problem;
  return words;
}

void
printGrasps(const std::vector<ObjectGrasp>& objects)
{
  std::printf("%8s %9s %5s %7s %7s %9s  %s\n",
              "object",
              "points",
              "face",
              "on it",
              "whole",
              "off (deg)",
              "first grasp");
  const auto word = [](bool is) { return is ? "yes" : "no"; };
  for (const ObjectGrasp& of : objects)
    std::printf("%8u %9llu %5s %7s %7s %9.1f  %s\n",
                of.object,
                static_cast<unsigned long long>(of.points),
                word(of.has_face),
                word(of.is_on_object),
                word(of.is_whole),
                of.angle,
                inWords(of).c_str());
}

void
reportGrasps(const std::vector<ObjectGrasp>& objects, Report& report)
{
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const ObjectGrasp& of : objects)
    list.push_back({{"object", of.object},
                    {"points", of.points},
                    {"has_face", of.has_face},
                    {"first_grasp", inWords(of)},
                    {"is_on_object", of.is_on_object},
                    {"is_whole", of.is_whole},
                    {"angle_degrees", of.angle},
                    {"is_right", of.isRight()}});
  report.setJson("", "objects", list);
}

/** The lists, and how many objects have a face for the cup and a right grasp. */
void
showGrasps(const std::vector<ObjectGrasp>& objects, Report& report)
{
  std::uint64_t with_face = 0, right = 0;
  for (const ObjectGrasp& of : objects) {
    with_face += of.has_face;
    right += of.has_face && of.isRight();
  }
  printGrasps(objects);
  std::printf("objects %zu, with a face for the cup %llu, of these with a right first "
              "grasp %llu\n",
              objects.size(),
              static_cast<unsigned long long>(with_face),
              static_cast<unsigned long long>(right));
  report.setCount("counts", "objects", objects.size());
  report.setCount("counts", "with_face", with_face);
  report.setCount("counts", "right", right);
  reportGrasps(objects, report);
}

/** The objects have the parts that the grasps were found with.
 * \throws InputError if -parts says otherwise */
GraspsOfObjects
readJudged(const Arguments& arguments, const std::string& path)
{
  GraspsOfObjects grasps = readGraspsOfObjects(path);
  const auto parts = arguments.integer("parts", 1, max_count);
  if (parts && *parts != grasps.parts)
    throw InputError(path + ": 'parameters.parts' is '" + std::to_string(grasps.parts) +
                     "', but -parts is '" + std::to_string(*parts) +
                     "'; expected the same, or no -parts");
  return grasps;
}

/** The objects of the truth. \throws InputError unless the grasps are of these */
std::vector<std::uint32_t>
objectLabels(const CloudFile& truth,
             const GraspsOfObjects& grasps,
             const std::string& path)
{
  const std::string field = fieldOfObjects(truth);
  if (field != grasps.field)
    throw InputError(path + ": 'parameters.each' is " + inQuotes(grasps.field) +
                     ", but the objects of " + truth.path +
                     " are those of its field '" + field +
                     "'; expected grasps of -each " + field);
  return labelsOf(truth, field);
}

/** The grasps of a report on the objects of the truth. */
int
evaluateGraspFile(const Arguments& arguments, const ObjectRules& rules)
{
  const auto& operands = arguments.operands(2);
  checkJsonPath(arguments, operands);
  checkInputOptions(arguments);
  Report report;
  report.setText("", "predicted", operands[0]);
  report.setText("", "truth", operands[1]);
  const GraspsOfObjects grasps =
      report.time("read", [&] { return readJudged(arguments, operands[0]); });
  const CloudFile truth = report.time(
      "read_truth", [&] { return readInput(arguments, operands[1], report); });
  report.setText("parameters", "task", "grasps");
  report.setCount("parameters", "parts", grasps.parts);
  report.setCount("parameters", "min_points", rules.min_points);
  report.setNumber("parameters", "cup_radius", static_cast<double>(grasps.cup_radius));
  report.setNumber("parameters", "compliance", grasps.compliance);
  const std::vector<ObjectGrasp> objects = report.time("evaluate", [&] {
    return evaluateGrasps(*pointsOf(truth),
                          objectLabels(truth, grasps, operands[0]),
                          grasps,
                          rules.min_points);
  });
  if (objects.empty())
    throw InputError(truth.path + ": no object has " +
                     std::to_string(rules.min_points) +
                     " points; expected at least one");
  showGrasps(objects, report);
  writeJson(arguments, toJson(arguments.app(), report));
  return 0;
}

/** -out is for tasks of one class against the rest. */
void
checkOut(const Arguments& arguments, const std::string& task)
{
  if (arguments.has("out") &&
      (task == "instance" || task == "objects" || task == "label" || task == "grasps"))
    throw UsageError("-out with -task '" + task +
                     "'; expected -task edge, planar, curved or ground");
  checkOutputPath(arguments, "out", arguments.operands(2));
  if (arguments.has("out"))
    checkCloudOutput(arguments, arguments.text("out"));
}

/** The predicted cloud with the field outcome, complete in its temporary file. */
void
writeOutcomes(const Arguments& arguments,
              CloudFile predicted,
              const TaskPoints& selected,
              AtomicFile& file)
{
  setField(predicted, "outcome", outcomesOf(selected, predicted.size()));
  file.write(encodeOutput(
      arguments, arguments.text("out"), predicted, outputFormat(arguments)));
}

/** What two clouds are compared by. */
struct Comparison {
  std::string task;
  std::string convention;
  ObjectRules rules;
};

/** Both clouds, and the points of them that the task evaluates. */
struct ComparedClouds {
  CloudFile predicted, truth;
  TaskPoints selected;
};

ComparedClouds
readClouds(const Arguments& arguments, const Comparison& comparison, Report& report)
{
  const auto& operands = arguments.operands(2);
  ComparedClouds clouds;
  clouds.predicted =
      report.time("read", [&] { return readInput(arguments, operands[0], report); });
  clouds.truth = report.time(
      "read_truth", [&] { return readAnyCloud(operands[1], floatsOfBin(arguments)); });
  clouds.truth.offset = clouds.predicted.offset; // to compare the same points
  clouds.selected = selectPoints(comparison.task,
                                 comparison.convention == "paper" ? Convention::paper
                                                                  : Convention::strict,
                                 clouds.predicted,
                                 clouds.truth);
  if (!clouds.selected.copied_field.empty())
    logLine(arguments.app() + ": " + operands[0] + ": warning: field '" +
            clouds.selected.copied_field + "' is the same as in " + operands[1] +
            " at all points; was it copied with the cloud instead of predicted?");
  return clouds;
}

void
evaluateTask(const Comparison& comparison, const TaskPoints& selected, Report& report)
{
  if (comparison.task == "instance")
    evaluateInstancePoints(selected, report);
  else if (comparison.task == "objects")
    evaluateObjectPoints(selected, comparison.rules, report);
  else
    evaluateClasses(selected, report);
  if (comparison.task == "label")
    evaluateKept(selected, report);
}

int
compareClouds(const Arguments& arguments, const Comparison& comparison)
{
  const auto& operands = arguments.operands(2);
  checkJsonPath(arguments, {operands[0], operands[1], arguments.text("out")});
  outputFormat(arguments);
  checkInputOptions(arguments);

  Report report;
  report.setText("", "predicted", operands[0]);
  report.setText("", "truth", operands[1]);
  report.setText("parameters", "task", comparison.task);
  report.setText("parameters", "convention", comparison.convention);
  const ComparedClouds clouds = readClouds(arguments, comparison, report);
  std::optional<AtomicFile> outcomes;
  if (arguments.has("out"))
    writeOutcomes(arguments,
                  clouds.predicted,
                  clouds.selected,
                  outcomes.emplace(arguments.text("out")));
  report.setCount("", "points", clouds.truth.size());
  report.setCount("", "evaluated_points", clouds.selected.points.size());
  report.setCount("", "unknown_points", clouds.selected.unknown);

  std::printf("task %s, convention %s: ",
              comparison.task.c_str(),
              comparison.convention.c_str());
  printHeading(clouds.selected, clouds.truth.size());
  evaluateTask(comparison, clouds.selected, report);
  writeJson(arguments, toJson(arguments.app(), report));
  if (outcomes)
    outcomes->commit();
  return 0;
}

int
run(const Arguments& arguments)
{
  arguments.operands(2);
  const std::string task = arguments.choice("task", taskNames());
  checkOut(arguments, task);
  const ObjectRules rules = objectRules(arguments, task);
  const std::string convention = arguments.choice("convention", {"strict", "paper"});
  arguments.threads();
  if (task != "grasps")
    return compareClouds(arguments, {task, convention, rules});
  if (convention == "paper")
    throw UsageError("-convention 'paper' with -task 'grasps'; expected strict");
  return evaluateGraspFile(arguments, rules);
}

} // namespace

int
main(int argc, char** argv)
{
  CommandLine command_line("pcl_shape_evaluate",
                           "predicted.pcd truth.pcd",
                           "Compare predicted labels with the truth: precision, "
                           "recall, F1 and IoU per class, "
                           "class-mean IoU, accuracy.\nAn unknown prediction counts as "
                           "negative for every class.\nOf -task grasps the first file "
                           "is what pcl_shape_grasp -each wrote with -json.");
  command_line
      .option("task",
              "T",
              "edge (default), planar, curved, instance, objects, label, ground or "
              "grasps")
      .option("parts",
              "N",
              "of -task objects: the truth's labels are N * object + part, e.g. 10 "
              "(default 1); of -task grasps as in their file")
      .option("min_points",
              "N",
              "of -task objects and grasps: objects of fewer points need not be found "
              "(default 300)")
      .option("convention",
              "C",
              "strict (default): creases' surroundings left out; paper: creases are "
              "curved, "
              "and edges")
      .option(
          "out",
          "F",
          "write the predicted cloud with the field outcome: 2 hit, 3 miss, 4 false "
          "alarm");
  addFormatOption(command_line);
  addInputOptions(command_line);
  addCommonOptions(command_line, false);
  return runApp(command_line, argc, argv, run);
}
