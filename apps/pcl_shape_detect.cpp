// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// pcl_shape_detect: edges, their kinds, surfaces and instances from one field.

#include "cli/command_line.h"
#include "cli/filter_app.h"
#include "detection/detection.h"
#include "detection/instances.h"
#include "detection/results.h"

namespace {

using namespace pcl::app;

struct Wanted {
  EdgeResults edges;
  bool surfaces = false;
  std::string instances; ///< of what; empty for none
};

Wanted
wanted(const Arguments& arguments)
{
  Wanted wanted;
  wanted.edges = {
      arguments.has("edges"), arguments.has("types"), arguments.has("lines")};
  wanted.surfaces = arguments.has("surfaces");
  if (arguments.has("instances"))
    wanted.instances = arguments.choice("instances", {"object", "curved", "planar"});
  if (!wanted.edges.edges && !wanted.edges.types && !wanted.surfaces &&
      wanted.instances.empty())
    wanted.edges.edges = wanted.edges.types = wanted.surfaces = true;
  return wanted;
}

std::vector<pcl::CreaseLine>
addWantedEdges(CloudFile& file,
               const PointsPtr& points,
               const pcl::ShapeField::ConstPtr& field,
               const Wanted& wanted,
               const Arguments& arguments,
               Report& report)
{
  if (!wanted.edges.edges && !wanted.edges.types && !wanted.edges.lines)
    return {};
  EdgeDetector detector;
  detector.setInputCloud(points);
  detector.setShapeField(field);
  detector.setNumberOfThreads(arguments.threads());
  return report.time("edges",
                     [&] { return addEdges(file, detector, wanted.edges, report); });
}

std::vector<pcl::CreaseLine>
detect(CloudFile& file,
       const DetectionSettings& settings,
       const Wanted& wanted,
       const Arguments& arguments,
       Report& report)
{
  const bool edges_only = !wanted.surfaces && wanted.instances.empty();
  const PointsPtr points = pointsOf(file);
  const pcl::ShapeField::ConstPtr field = report.time("field", [&] {
    return fieldOf(file, points, settings, edges_only, arguments, report);
  });
  std::vector<pcl::CreaseLine> lines =
      addWantedEdges(file, points, field, wanted, arguments, report);
  if (wanted.surfaces) {
    SurfaceDetector detector;
    detector.setInputCloud(points);
    detector.setShapeField(field);
    report.time("surfaces", [&] { addSurfaces(file, detector, settings, report); });
  }
  if (!wanted.instances.empty()) {
    InstanceSegmentation segmentation;
    segmentation.setInputCloud(points);
    segmentation.setShapeField(field);
    segmentation.setClass(wanted.instances);
    segmentation.setNumberOfThreads(arguments.threads());
    addInstances(file, segmentation, report);
  }
  return lines;
}

int
run(const Arguments& arguments)
{
  const Wanted results = wanted(arguments);
  DetectionSettings settings;
  settings.resolution = resolutionOf(arguments);
  settings.one_resolution = arguments.has("one_resolution");
  return runFilterWithLines(arguments, [&](CloudFile& file, Report& report) {
    return detect(file, settings, results, arguments, report);
  });
}

} // namespace

int
main(int argc, char** argv)
{
  CommandLine command_line(
      "pcl_shape_detect",
      "in.pcd out.pcd",
      "Compute what is known of a cloud once, and add the fields that are asked for; "
      "without\n-edges, -types, -surfaces and -instances those of the first three.");
  command_line.flag("edges", "add edge_likelihood (NaN unknown) and edge: 1 on creases")
      .flag("types", "add edge_type: 1 crease, 2 corner, 3 open boundary, 0 none")
      .flag("surfaces", "add likelihood and surface: 1 planar, 2 curved, 0 unknown")
      .option("instances", "C", "add instance: 1 and up; of object, curved or planar")
      .option("lines", "F", "write the creases as lines to the JSON file F")
      .flag("normals", "write normal_x normal_y normal_z curvature too");
  addResolutionOption(command_line);
  command_line.flag("one_resolution", "the same for all of the cloud, as in tiles");
  addFilterOptions(command_line);
  return runApp(command_line, argc, argv, run);
}
