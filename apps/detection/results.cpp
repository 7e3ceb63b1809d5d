// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What detectors found, as fields and counts.

#include "detection/results.h"

#include "cli/filter_app.h"
#include "cli/pcl_errors.h"
#include "io/files.h"

#include <nlohmann/json.hpp>

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

/** The contents of the -lines file, as doc/files.md describes it. */
std::string
linesToJson(const CloudFile& input, const std::vector<CreaseLine>& lines)
{
  constexpr double degrees_per_radian = 180.0 / 3.14159265358979323846;
  using Json = nlohmann::ordered_json;
  Json json = {{"format", "pcl_shape lines"}, {"version", 1}, {"input", input.path}};
  if (input.offset != std::array<double, 3>{})
    json["offset"] = input.offset;
  json["lines"] = Json::array();
  for (const CreaseLine& line : lines)
    json["lines"].push_back({{"length", line.length},
                             {"angle_degrees", line.angle * degrees_per_radian},
                             {"spacing", line.spacing},
                             {"closed", line.closed},
                             {"points", line.points}});
  return dumpJson(json, -1);
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
