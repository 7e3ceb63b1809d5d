// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// pcl_shape_back_projection: planar and curved points, or surfaces of a model.

#include "cli/command_line.h"
#include "cli/filter_app.h"
#include "detection/results.h"
#include "io/errors.h"

namespace {

using namespace pcl::app;

void
classify(CloudFile& file,
         const Arguments& arguments,
         const DetectionSettings& settings,
         Report& report)
{
  SurfaceDetector detector;
  const PointsPtr points = prepare(detector, file, settings, arguments, report);
  report.time("back_projection", [&] {
    if (!settings.paper)
      detector.setShapeField(fieldOf(file, points, settings, false, arguments, report));
    addSurfaces(file, detector, settings, report);
  });
}

/** Names of classes become parts of names of fields. */
void
requireFieldNames(const DetectionSettings& settings, const Arguments& arguments)
{
  for (const auto& of : settings.model.classes())
    for (const char c : of.name)
      if (c <= ' ' || c > '~')
        throw InputError(arguments.text("model") + ": class '" + of.name +
                         "'; expected names in ASCII without blanks");
}

int
run(const Arguments& arguments)
{
  const DetectionSettings settings =
      detectionSettings(arguments, pcl::INADParameters::surfaces());
  requireFieldNames(settings, arguments);
  if (arguments.has("threshold") &&
      (!settings.paper || settings.model.classes().size() > 1))
    throw UsageError("-threshold '" + arguments.text("threshold") +
                     "' needs a model of one class: of several each point gets the "
                     "likeliest; add -mode paper, or leave it out");
  return runFilter(arguments, [&](CloudFile& file, Report& report) {
    classify(file, arguments, settings, report);
  });
}

} // namespace

int
main(int argc, char** argv)
{
  CommandLine command_line(
      "pcl_shape_back_projection",
      "in.pcd out.pcd",
      "Add the fields likelihood (of the first class) and surface: 1 planar, 2 curved, "
      "0 unknown;\nwith a model of several classes the number of the class, and "
      "likelihood_<name> of each.");
  addDetectionOptions(command_line);
  addFilterOptions(command_line);
  return runApp(command_line, argc, argv, run);
}
