// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// pcl_shape_edge_detection: adds edges and their types, and writes crease lines.

#include "cli/app.h"
#include "cli/filter_app.h"
#include "detection/detection.h"
#include "results/result_files.h"

#include <pcl/segmentation/shape_edge_detection.h>

#include <optional>

namespace {

using namespace pcl::app;
using Detector = pcl::ShapeEdgeDetection<pcl::PointXYZ, pcl::Normal>;

struct Edges {
  std::vector<float> likelihood;
  std::vector<pcl::PointIndices> members; ///< edge, planar
  std::vector<pcl::EdgeType> types;       ///< only if asked for
  std::vector<pcl::CreaseLine> lines;     ///< only if asked for
};

/** What is known in the default mode only. */
bool
wantsMore(const Arguments& arguments)
{
  return arguments.has("types") || arguments.has("lines");
}

Edges
detect(Detector& detector, const CloudFile& file, const Arguments& arguments)
{
  Edges edges;
  std::vector<std::vector<float>> likelihoods;
  if (wantsMore(arguments)) {
    pcl::Edges found;
    detector.detect(found);
    if (arguments.has("lines"))
      edges.lines = detector.linesOf(found);
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

/** \return the creases, if they were asked for */
std::vector<pcl::CreaseLine>
addEdges(CloudFile& file,
         const Arguments& arguments,
         const DetectionSettings& settings,
         Report& report)
{
  Detector detector;
  prepare(detector, file, settings, arguments, report);
  Edges edges =
      report.time("edge_detection", [&] { return detect(detector, file, arguments); });

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
  if (arguments.has("types"))
    addTypes(file, edges, report);
  return std::move(edges.lines);
}

void
requireClasses(const DetectionSettings& settings, const Arguments& arguments)
{
  const std::size_t classes = settings.model.classes().size();
  if (classes != 1 && !(settings.adaptive && (classes == 2 || !arguments.has("model"))))
    throw InputError(arguments.text("model") + ": " + std::to_string(classes) +
                     " classes; expected one, the plane, or two made with -scale "
                     "density, an edge and the rest");
  if (arguments.has("model") && classes == 2 &&
      settings.model.classes().front().name != "edge")
    throw InputError(arguments.text("model") + ": its first class is '" +
                     settings.model.classes().front().name +
                     "'; expected edge, and then the rest");
  if (wantsMore(arguments) && !settings.adaptive)
    throw UsageError(
        std::string(arguments.has("types") ? "-types" : "-lines") +
        " with radii, -k, -outlier_rate, -bins, -use_normals, -scale or -mode paper; "
        "use the default mode without them");
}

/** The -lines file, which is complete when the cloud is written. */
std::optional<AtomicFile>
linesFile(const Arguments& arguments)
{
  if (!arguments.has("lines"))
    return std::nullopt;
  arguments.exclude("lines", "input_dir");
  arguments.exclude("lines", "output_dir");
  std::vector<std::string> others = arguments.operands(2);
  if (arguments.has("json"))
    others.push_back(arguments.text("json"));
  checkOutputPath(arguments, "lines", others);
  return std::optional<AtomicFile>(std::in_place, arguments.text("lines"));
}

void
reportLines(const std::vector<pcl::CreaseLine>& lines, Report& report)
{
  double length = 0.0;
  for (const pcl::CreaseLine& line : lines)
    length += line.length;
  report.setCount("lines", "count", lines.size());
  report.setNumber("lines", "length", length);
}

int
run(const Arguments& arguments)
{
  const DetectionSettings settings =
      detectionSettings(arguments, pcl::INADParameters::edges());
  requireClasses(settings, arguments);
  std::optional<AtomicFile> lines_file = linesFile(arguments);
  const int status = runFilter(arguments, [&](CloudFile& file, Report& report) {
    const auto lines = addEdges(file, arguments, settings, report);
    if (lines_file) {
      reportLines(lines, report);
      lines_file->write(linesToJson(file.path, lines));
    }
  });
  if (lines_file && status == 0)
    lines_file->commit();
  return status;
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
  command_line
      .flag("types", "add edge_type: 1 crease, 2 corner, 3 open boundary, 0 none")
      .option("lines", "F", "write the creases as lines to the JSON file F");
  addFilterOptions(command_line);
  return runApp(command_line, argc, argv, run);
}
