// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// pcl_shape_instances: adds the field instance, and primitives to the JSON.

#include "cli/command_line.h"
#include "cli/filter_app.h"
#include "detection/detection.h"
#include "detection/instances.h"
#include "detection/model_file.h"
#include "io/errors.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace {

using namespace pcl::app;

struct Settings {
  std::string of_class;
  std::optional<pcl::ShapeModel> model;
  double high = 0.0, low = 0.0;
  std::uint64_t min_points = 0;
  pcl::PrimitiveType primitive = pcl::PrimitiveType::None;
  double resolution = 0.0;
};

pcl::PrimitiveType
primitiveType(const Arguments& arguments)
{
  const std::vector<std::string> names{"none", "auto", "plane", "cylinder", "sphere"};
  const std::string name = arguments.choice("primitive", names);
  return static_cast<pcl::PrimitiveType>(std::find(names.begin(), names.end(), name) -
                                         names.begin());
}

pcl::ShapeModel
densityModel(const std::string& path)
{
  pcl::ShapeModel model = loadModel(path);
  const bool is_density =
      model.parameters().radius_mode == pcl::AdaptiveRadius::DENSITY;
  if (!is_density || model.classes().size() < 2)
    throw InputError(path + ": expected a model of two classes or more, made with "
                            "-scale density");
  return model;
}

void
checkClass(const Settings& settings)
{
  std::vector<std::string> names{"planar", "curved"};
  if (settings.model) {
    names.clear();
    for (const auto& of : settings.model->classes())
      names.push_back(of.name);
  }
  if (std::find(names.begin(), names.end(), "planar") != names.end())
    names.emplace_back("object");
  std::string expected;
  for (const std::string& name : names)
    expected += (expected.empty() ? "" : ", ") + name;
  if (std::find(names.begin(), names.end(), settings.of_class) == names.end())
    throw UsageError("-class '" + settings.of_class + "': expected one of " + expected);
}

Settings
settingsOf(const Arguments& arguments)
{
  constexpr double default_high = 0.6, default_low = 0.5;
  constexpr std::uint64_t default_points = 100;
  Settings settings;
  settings.of_class = arguments.text("class", "curved");
  settings.high = arguments.number("high", probability).value_or(default_high);
  settings.low = arguments.number("low", probability)
                     .value_or(std::min(default_low, settings.high));
  if (settings.low > settings.high)
    throw UsageError("-low '" + arguments.text("low") + "' is above -high, " +
                     std::to_string(settings.high) + "; expected up to that");
  settings.min_points =
      arguments.integer("min_points", 1, std::numeric_limits<std::uint32_t>::max())
          .value_or(default_points);
  settings.primitive = primitiveType(arguments);
  settings.resolution = resolutionOf(arguments);
  if (arguments.has("model"))
    settings.model = densityModel(arguments.text("model"));
  checkClass(settings);
  return settings;
}

void
reportSettings(const Settings& settings, const Arguments& arguments, Report& report)
{
  report.setText("parameters", "class", settings.of_class);
  report.setText("parameters", "model", arguments.text("model", "default"));
  report.setNumber("parameters", "high", settings.high);
  report.setNumber("parameters", "low", settings.low);
  report.setCount("parameters", "min_points", settings.min_points);
  report.setText("parameters", "primitive", arguments.text("primitive", "none"));
  report.setCount("parameters", "threads", arguments.threads());
}

void
segment(CloudFile& file,
        const Settings& settings,
        const Arguments& arguments,
        Report& report)
{
  const auto points = pointsOf(file);
  reportPoints(*points, report);
  reportSettings(settings, arguments, report);
  InstanceSegmentation segmentation;
  segmentation.setInputCloud(points);
  segmentation.setShapeField(report.time("field", [&] {
    return surfaceFieldOf(
        file, points, settings.model, settings.resolution, arguments.threads(), report);
  }));
  segmentation.setClass(settings.of_class);
  segmentation.setThresholds(settings.high, settings.low);
  segmentation.setMinPoints(settings.min_points);
  segmentation.setPrimitive(settings.primitive);
  segmentation.setNumberOfThreads(arguments.threads());
  addInstances(file, segmentation, report);
}

int
run(const Arguments& arguments)
{
  const Settings settings = settingsOf(arguments);
  return runFilter(arguments, [&](CloudFile& file, Report& report) {
    segment(file, settings, arguments, report);
  });
}

} // namespace

int
main(int argc, char** argv)
{
  CommandLine command_line(
      "pcl_shape_instances",
      "in.pcd out.pcd",
      "Add the field instance: 1 and up, the largest first, 0 none; the number of "
      "instances is found.");
  command_line
      .option(
          "class",
          "C",
          "curved (default), planar, a class of -model, or object: whole objects on "
          "a support")
      .option("model", "F", "a model file instead of the default model")
      .option("high",
              "T",
              "likelihood that a quarter of an instance's points must have (0.6)")
      .option("low", "T", "likelihood of each of its points (0.5)")
      .option("min_points", "N", "leave smaller instances out (100)")
      .option("primitive",
              "P",
              "to fit to each: none (default), auto, plane, cylinder, sphere; see "
              "-json");
  addResolutionOption(command_line);
  addFilterOptions(command_line);
  return runApp(command_line, argc, argv, run);
}
