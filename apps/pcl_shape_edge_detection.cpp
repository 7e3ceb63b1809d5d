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
  std::vector<float> likelihood;
  std::vector<pcl::PointIndices> members; ///< edge, planar
  std::vector<pcl::EdgeType> types;       ///< only if asked for
};

Edges
detect(Detector& detector, const CloudFile& file, bool with_types)
{
  Edges edges;
  std::vector<std::vector<float>> likelihoods;
  if (with_types) {
    pcl::Edges found;
    detector.detect(found);
    edges.types = std::move(found.types);
    likelihoods = {found.likelihood, found.likelihood};
    for (float& planar : likelihoods[1])
      planar = 1.0f - planar;
  }
  else
    detector.compute(likelihoods);
  if (likelihoods.empty() || likelihoods[0].size() != file.size())
    throw InputError(file.path + ": refused for the reason given above");
  edges.members = detector.classesOf(likelihoods);
  edges.likelihood = std::move(likelihoods[0]);
  return edges;
}

void
addTypes(CloudFile& file, const Edges& edges, Report& report)
{
  const char* const names[] = {"none", "crease", "corner", "open_boundary"};
  std::vector<std::uint32_t> types;
  std::uint64_t counts[4] = {};
  for (const pcl::EdgeType type : edges.types) {
    types.push_back(static_cast<std::uint32_t>(type));
    ++counts[types.back()];
  }
  for (std::size_t t = 1; t < 4; ++t)
    report.setCount("types", names[t], counts[t]);
  setField(file, "edge_type", types);
}

void
addEdges(CloudFile& file,
         const Arguments& arguments,
         const DetectionSettings& settings,
         Report& report)
{
  Detector detector;
  prepare(detector, file, settings, arguments, report);
  const bool with_types = arguments.has("types");
  const Edges edges =
      report.time("edge_detection", [&] { return detect(detector, file, with_types); });

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
  setField(file, "edge_likelihood", edges.likelihood);
  setField(file, "edge", edge);
  if (with_types)
    addTypes(file, edges, report);
}

void
requireClasses(const DetectionSettings& settings, const Arguments& arguments)
{
  const std::size_t classes = settings.model.classes().size();
  if (classes != 1 && !(settings.adaptive && (classes == 2 || !arguments.has("model"))))
    throw InputError(arguments.text("model") + ": " + std::to_string(classes) +
                     " classes: allowed is one, the plane, or two made with -scale "
                     "density, an edge and the rest");
  if (arguments.has("types") && !settings.adaptive)
    throw UsageError(
        "-types with radii, -k, -outlier_rate, -bins, -use_normals, -scale "
        "or -mode paper: allowed is the default mode without them");
}

int
run(const Arguments& arguments)
{
  const DetectionSettings settings =
      detectionSettings(arguments, pcl::INADParameters::edges());
  requireClasses(settings, arguments);
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
  command_line.flag("types",
                    "add edge_type: 1 crease, 2 corner, 3 open boundary, 0 none");
  addFilterOptions(command_line);
  return runApp(command_line, argc, argv, run);
}
