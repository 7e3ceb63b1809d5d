// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// pcl_shape_edge_detection: creases, their kinds and lines.

#include "cli/command_line.h"
#include "cli/filter_app.h"
#include "detection/results.h"
#include "io/errors.h"

namespace {

using namespace pcl::app;

std::vector<pcl::CreaseLine>
detect(CloudFile& file,
       const Arguments& arguments,
       const DetectionSettings& settings,
       Report& report)
{
  EdgeDetector detector;
  const PointsPtr points = prepare(detector, file, settings, arguments, report);
  const EdgeResults results{true, arguments.has("types"), arguments.has("lines")};
  return report.time("edge_detection", [&] {
    if (!settings.paper)
      detector.setShapeField(fieldOf(file, points, settings, true, arguments, report));
    return addEdges(file, detector, results, report);
  });
}

void
requireClasses(const DetectionSettings& settings, const Arguments& arguments)
{
  const std::size_t classes = settings.model.classes().size();
  const std::size_t needed = settings.paper ? 1 : 2;
  if ((settings.paper || settings.has_model) && classes != needed)
    throw InputError(arguments.text("model") + ": " + std::to_string(classes) +
                     " classes; expected " +
                     (settings.paper ? "one, the plane" : "two, an edge and the rest"));
  if (!settings.paper && settings.has_model &&
      settings.model.classes().front().name != "edge")
    throw InputError(arguments.text("model") + ": its first class is '" +
                     settings.model.classes().front().name +
                     "'; expected edge, and then the rest");
  for (const std::string option : {"types", "lines"})
    if (settings.paper && arguments.has(option))
      throw UsageError(
          "-" + option +
          " belongs to the default method; it cannot be used with -mode paper");
}

int
run(const Arguments& arguments)
{
  const DetectionSettings settings =
      detectionSettings(arguments, pcl::INADParameters::edges());
  requireClasses(settings, arguments);
  return runFilterWithLines(arguments, [&](CloudFile& file, Report& report) {
    return detect(file, arguments, settings, report);
  });
}

} // namespace

int
main(int argc, char** argv)
{
  CommandLine command_line("pcl_shape_edge_detection",
                           "in.pcd out.pcd",
                           "Add the fields edge_likelihood (NaN unknown) and edge: 1 "
                           "on creases, lines of high curvature,\n0 elsewhere.");
  addDetectionOptions(command_line);
  command_line
      .flag("types", "add edge_type: 1 crease, 2 corner, 3 open boundary, 0 none")
      .option("lines", "F", "write the creases as lines to the JSON file F");
  addFilterOptions(command_line);
  return runApp(command_line, argc, argv, run);
}
