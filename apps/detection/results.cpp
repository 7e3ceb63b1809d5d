// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What detectors found, as fields and counts.

#include "detection/results.h"

#include "cli/filter_app.h"
#include "cli/pcl_errors.h"
#include "io/files.h"
#include "results/result_files.h"

#include <optional>

namespace pcl::app {
namespace {

void
addTypes(CloudFile& file, const std::vector<pcl::EdgeType>& found, Report& report)
{
  const char* const names[] = {"none", "crease", "corner", "open_boundary"};
  std::vector<std::uint32_t> types;
  std::uint64_t counts[4] = {};
  for (const pcl::EdgeType type : found) {
    types.push_back(static_cast<std::uint32_t>(type));
    ++counts[types.back()];
  }
  for (std::size_t t = 1; t < 4; ++t)
    report.setCount("types", names[t], counts[t]);
  setField(file, "edge_type", types);
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

} // namespace

std::vector<pcl::CreaseLine>
addEdges(CloudFile& file,
         EdgeDetector& detector,
         const EdgeResults& results,
         Report& report)
{
  pcl::Edges edges;
  std::vector<std::vector<float>> likelihoods;
  withPclErrors(file.path, [&] {
    if (results.types || results.lines)
      detector.detect(edges);
    detector.compute(likelihoods);
    return !likelihoods.empty() && likelihoods[0].size() == file.size();
  });
  if (results.edges) {
    const auto members = detector.classesOf(likelihoods);
    std::vector<std::uint32_t> edge(file.size(), 0);
    for (const pcl::index_t index : members.front().indices)
      edge[static_cast<std::size_t>(index)] = 1;
    reportClasses(detector.getClasses(), members, report);
    setColumns(file, {{"edge_likelihood", likelihoods[0]}, {"edge", edge}});
  }
  if (results.types)
    addTypes(file, edges.types, report);
  if (!results.lines)
    return {};
  std::vector<pcl::CreaseLine> lines = detector.linesOf(edges);
  reportLines(lines, report);
  return lines;
}

void
addSurfaces(CloudFile& file,
            SurfaceDetector& detector,
            const DetectionSettings& settings,
            Report& report)
{
  std::vector<std::vector<float>> likelihoods;
  withPclErrors(file.path, [&] {
    detector.compute(likelihoods);
    return !likelihoods.empty();
  });
  if (!settings.paper && !settings.has_model)
    report.setNumber(
        "", largest_radius, pcl::largestCurvedRadius(*detector.getShapeField()));
  const auto members = detector.classesOf(likelihoods);
  const std::vector<std::string> names = detector.getClasses();
  std::vector<std::uint32_t> surface(file.size(), 0);
  for (std::size_t c = 0; c < names.size(); ++c)
    for (const pcl::index_t index : members[c].indices)
      surface[static_cast<std::size_t>(index)] = static_cast<std::uint32_t>(c + 1);
  reportClasses(names, members, report);
  std::vector<Column> columns{{"likelihood", likelihoods.front()}};
  if (settings.has_model && settings.model.classes().size() > 1)
    for (std::size_t c = 0; c < names.size(); ++c)
      columns.push_back({"likelihood_" + names[c], likelihoods[c]});
  columns.push_back({"surface", surface});
  setColumns(file, columns);
}

void
addInstances(CloudFile& file, InstanceSegmentation& segmentation, Report& report)
{
  std::vector<pcl::ShapeInstance> instances;
  withPclErrors(file.path, [&] {
    return report.time("instances", [&] { return segmentation.segment(instances); });
  });
  std::vector<std::uint32_t> labels(file.size(), 0);
  std::uint64_t labeled = 0;
  for (std::size_t k = 0; k < instances.size(); ++k) {
    for (const pcl::index_t index : instances[k].indices)
      labels[static_cast<std::size_t>(index)] = static_cast<std::uint32_t>(k + 1);
    labeled += instances[k].indices.size();
  }
  report.setCount("counts", "instances", instances.size());
  report.setCount("counts", "points in them", labeled);
  reportInstances(
      instances, segmentation.getClass(), segmentation.getClasses(), report);
  setField(file, "instance", labels);
}

int
runFilterWithLines(const Arguments& arguments, const LineFilter& filter)
{
  std::optional<AtomicFile> lines_file;
  if (arguments.has("lines")) {
    arguments.exclude("lines", "input_dir");
    arguments.exclude("lines", "output_dir");
    std::vector<std::string> others = arguments.operands(2);
    if (arguments.has("json"))
      others.push_back(arguments.text("json"));
    checkOutputPath(arguments, "lines", others);
    lines_file.emplace(arguments.text("lines"));
  }
  const int status = runFilter(arguments, [&](CloudFile& file, Report& report) {
    const std::vector<pcl::CreaseLine> lines = filter(file, report);
    if (lines_file)
      lines_file->write(linesToJson(file, lines));
  });
  if (lines_file && status == 0)
    lines_file->commit();
  return status;
}

} // namespace pcl::app
