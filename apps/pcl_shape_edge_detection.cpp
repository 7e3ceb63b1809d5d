/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "common/app.h"
#include "common/detection.h"
#include "common/filter_app.h"

#include <pcl/segmentation/shape_edge_detection.h>

namespace {

using namespace pcl::app;
using Detector = pcl::ShapeEdgeDetection<pcl::PointXYZ, pcl::Normal>;

struct Edges {
  pcl::PointCloud<pcl::Intensity> likelihood;
  std::vector<pcl::PointIndices> members; ///< edge, planar
};

Edges
detect(Detector& detector, const CloudFile& file)
{
  Edges edges;
  detector.compute(edges.likelihood);
  detector.segment(edges.members);
  if (edges.likelihood.size() != file.size() || edges.members.empty())
    throw InputError(file.path + ": refused for the reason given above");
  return edges;
}

void
addEdges(CloudFile& file,
         const Arguments& arguments,
         const DetectionSettings& settings,
         Report& report)
{
  Detector detector;
  prepare(detector, file, settings, arguments, report);
  const Edges edges =
      report.time("edge_detection", [&] { return detect(detector, file); });

  std::vector<float> likelihood;
  for (const pcl::Intensity& point : edges.likelihood)
    likelihood.push_back(point.intensity);
  std::vector<std::uint32_t> edge(file.size(), 0);
  for (const pcl::index_t index : edges.members.front().indices)
    edge[static_cast<std::size_t>(index)] = 1;
  std::uint64_t unknown = report.count("", "finite_points");
  const std::vector<std::string> names = detector.getClasses();
  for (std::size_t c = 0; c < names.size(); ++c) {
    report.setCount("counts", names[c], edges.members[c].indices.size());
    unknown -= edges.members[c].indices.size();
  }
  report.setCount("counts", "unknown", unknown);
  setField(file, "edge_likelihood", likelihood);
  setField(file, "edge", edge);
}

void
requireOneClass(const DetectionSettings& settings, const Arguments& arguments)
{
  if (settings.model.classes().size() != 1)
    throw InputError(arguments.text("model") + ": " +
                     std::to_string(settings.model.classes().size()) +
                     " classes: allowed is one, the plane");
}

int
run(const Arguments& arguments)
{
  const DetectionSettings settings =
      detectionSettings(arguments, Detector().getParameters());
  requireOneClass(settings, arguments);
  return runFilter(arguments, [&](CloudFile& file, Report& report) {
    addEdges(file, arguments, settings, report);
  });
}

} // namespace

int
main(int argc, char** argv)
{
  CommandLine command_line("pcl_shape_edge_detection",
                           "in.pcd out.pcd",
                           "Add the fields edge_likelihood (NaN unknown) and edge: 1 "
                           "on creases, lines of high "
                           "curvature,\n0 elsewhere.");
  addDetectionOptions(command_line);
  addFilterOptions(command_line);
  return runApp(command_line, argc, argv, run);
}
