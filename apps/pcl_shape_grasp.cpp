// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// pcl_shape_grasp: finds places for a suction cup.

#include "cli/command_line.h"
#include "cli/filter_app.h"
#include "cli/pcl_errors.h"
#include "detection/detection.h"
#include "io/files.h"
#include "results/selection.h"

#include <pcl/segmentation/suction_grasp_estimation.h>

#include <nlohmann/json.hpp>

#include <array>
#include <cstdio>
#include <optional>
#include <sstream>
#include <vector>

namespace {

using namespace pcl::app;
using Estimation = pcl::SuctionGraspEstimation<pcl::PointXYZ>;
using Grasps = std::vector<pcl::SuctionGrasp>;
using Json = nlohmann::ordered_json;

/** What is to be grasped, and how. */
struct Target {
  std::optional<std::uint32_t> object; ///< its number, if there are several targets
  pcl::IndicesPtr points;
  Grasps grasps; ///< the best first
};

constexpr std::uint64_t default_grasps = 10;
constexpr std::uint64_t grasp_limit = 1000000; // more than any list is read for
const char* const three_numbers = "three numbers of meters, X,Y,Z";

Estimation
makeEstimation(const Arguments& arguments, Report& report)
{
  Estimation estimation;
  const std::string surface = arguments.choice("surface", {"any", "planar", "curved"});
  estimation.setSurface(surface == "planar"   ? Estimation::PLANAR
                        : surface == "curved" ? Estimation::CURVED
                                              : Estimation::ANY);
  estimation.setCupRadius(arguments.number("cup_radius", positive_length)
                              .value_or(estimation.getCupRadius()));
  estimation.setCompliance(
      arguments.number("compliance", probability).value_or(estimation.getCompliance()));
  const std::uint64_t max_grasps =
      arguments.integer("max_grasps", 1, grasp_limit).value_or(default_grasps);
  estimation.setMaximumGrasps(max_grasps);
  estimation.setNumberOfThreads(arguments.threads());
  report.setText("parameters", "surface", surface);
  report.setNumber("parameters", "cup_radius", estimation.getCupRadius());
  report.setNumber("parameters", "compliance", estimation.getCompliance());
  report.setCount("parameters", "max_grasps", max_grasps);
  report.setCount("parameters", "threads", arguments.threads());
  return estimation;
}

void
reportViewPoint(const CloudFile& file, const Arguments& arguments, Report& report)
{
  if (arguments.has("viewpoint")) {
    report.setText("parameters", "viewpoint", arguments.text("viewpoint"));
    return;
  }
  std::ostringstream text;
  text << file.viewpoint[0] << ',' << file.viewpoint[1] << ',' << file.viewpoint[2];
  report.setText("parameters", "viewpoint", text.str());
}

void
setViewPoint(Estimation& estimation, const CloudFile& file, const Arguments& arguments)
{
  const auto numbers = arguments.numbers("viewpoint", 3, three_numbers);
  std::array<float, 3> origin = viewOriginOf(file);
  for (std::size_t c = 0; numbers && c < origin.size(); ++c)
    origin[c] = static_cast<float>((*numbers)[c] - file.offset[c]);
  estimation.setViewPoint(origin[0], origin[1], origin[2]);
}

/** The points to grasp, or those of each object. */
std::vector<Target>
targetsOf(const CloudFile& file,
          const pcl::PointCloud<pcl::PointXYZ>& points,
          const Arguments& arguments)
{
  if (!arguments.has("each"))
    return {{std::nullopt, selectedPoints(file, points, arguments), {}}};
  std::vector<Target> targets;
  for (const auto& [object, indices] : selectedObjects(file, points, arguments))
    targets.push_back({object, indices, {}});
  return targets;
}

std::vector<Target>
findGrasps(Estimation& estimation,
           const CloudFile& file,
           const Arguments& arguments,
           Report& report)
{
  const auto points = pointsOf(file);
  std::vector<Target> targets = targetsOf(file, *points, arguments);
  estimation.setInputCloud(points);
  estimation.setShapeField(surfaceFieldOf(file,
                                          points,
                                          std::nullopt,
                                          resolutionOf(arguments),
                                          arguments.threads(),
                                          report));
  setViewPoint(estimation, file, arguments);
  for (Target& target : targets) {
    estimation.setIndices(target.points);
    withPclErrors(file.path, [&] { return estimation.compute(target.grasps); });
  }
  return targets;
}

void
print(const Grasps& grasps)
{
  for (const pcl::SuctionGrasp& grasp : grasps) {
    const auto &p = grasp.position, &a = grasp.approach;
    std::printf("score %.3f at %.4f %.4f %.4f, approach %.3f %.3f %.3f: ",
                static_cast<double>(grasp.score),
                static_cast<double>(p.x()),
                static_cast<double>(p.y()),
                static_cast<double>(p.z()),
                static_cast<double>(a.x()),
                static_cast<double>(a.y()),
                static_cast<double>(a.z()));
    std::printf(grasp.seals() ? "seals" : "leaks:");
    for (const pcl::SealProblem problem : grasp.problems)
      std::printf(" %s", pcl::nameOf(problem));
    std::printf("\n");
  }
}

void
print(const std::vector<Target>& targets)
{
  for (const Target& target : targets) {
    if (target.object)
      std::printf("object %u, %zu points:\n", *target.object, target.points->size());
    print(target.grasps);
  }
}

Json
graspToJson(const pcl::SuctionGrasp& grasp, const std::optional<std::uint32_t>& object)
{
  Json problems = Json::array();
  for (const pcl::SealProblem problem : grasp.problems)
    problems.push_back(pcl::nameOf(problem));
  Json json = object ? Json{{"object", *object}} : Json::object();
  json.update({{"position", vectorToJson(grasp.position.data())},
               {"approach", vectorToJson(grasp.approach.data())},
               {"score", grasp.score},
               {"seals", grasp.seals()},
               {"problems", problems},
               {"surface", grasp.surface == 1 ? "planar" : "curved"},
               {"likelihood", grasp.likelihood},
               {"covered", grasp.covered},
               {"border_distance", grasp.border_distance},
               {"edge_distance", grasp.edge_distance},
               {"obstacle_distance", grasp.obstacle_distance},
               {"margin", grasp.margin},
               {"sag", grasp.sag},
               {"sag_allowed", grasp.sag_allowed},
               {"residual", grasp.residual},
               {"residual_allowed", grasp.residual_allowed},
               {"convergence",
                {{"converged", grasp.converged},
                 {"iterations", grasp.iterations},
                 {"starts", grasp.starts},
                 {"bandwidth", grasp.bandwidth},
                 {"moved", grasp.moved}}}});
  return json;
}

/** The contents of the -json file, as doc/files.md describes it. */
std::string
graspsToJson(const std::string& app,
             const Report& report,
             const std::vector<Target>& targets)
{
  Json json = Json::parse(toJson(app, report));
  json["grasps"] = Json::array();
  for (const Target& target : targets)
    for (const pcl::SuctionGrasp& grasp : target.grasps)
      json["grasps"].push_back(graspToJson(grasp, target.object));
  return dumpJson(json);
}

void
reportCounts(const std::vector<Target>& targets, Report& report)
{
  std::uint64_t points = 0, grasps = 0, sealing = 0;
  for (const Target& target : targets) {
    points += target.points->size();
    grasps += target.grasps.size();
    for (const pcl::SuctionGrasp& grasp : target.grasps)
      sealing += grasp.seals() ? 1 : 0;
  }
  if (targets.front().object)
    report.setCount("counts", "objects", targets.size());
  report.setCount("counts", "target_points", points);
  report.setCount("counts", "grasps", grasps);
  report.setCount("counts", "sealing", sealing);
}

int
run(const Arguments& arguments)
{
  const std::string path = arguments.operands(1).front();
  Report report;
  report.setText("", "input", path);
  Estimation estimation = makeEstimation(arguments, report);
  checkSelection(arguments);
  arguments.numbers("viewpoint", 3, three_numbers);
  checkInputOptions(arguments);
  checkJsonPath(arguments, {path});

  const CloudFile file =
      report.time("read", [&] { return readInput(arguments, path, report); });
  reportViewPoint(file, arguments, report);
  reportSelection(arguments, report);
  reportPoints(*pointsOf(file), report);
  const std::vector<Target> targets = report.time(
      "grasps", [&] { return findGrasps(estimation, file, arguments, report); });
  reportCounts(targets, report);
  writeJson(arguments, graspsToJson(arguments.app(), report, targets));
  printSummary(path, report);
  print(targets);
  return 0;
}

} // namespace

int
main(int argc, char** argv)
{
  CommandLine command_line(
      "pcl_shape_grasp",
      "in.pcd",
      "Find places for a suction cup on an object, the best first.\nThe object is the "
      "whole cloud, or the points that -field and -value or -box select; the others "
      "are in the way. With -each all objects are grasped, one at a time.");
  command_line.option("surface", "S", "to look for: any (default), planar, curved")
      .option("cup_radius", "R", "of the cup's lip, meters (0.01)")
      .option("compliance", "C", "by how many radii the lip may bend, 0 to 1 (0.2)")
      .option("max_grasps", "N", "at most (10)")
      .option(
          "viewpoint", "X,Y,Z", "from where the cloud was seen, instead of the file's");
  addResolutionOption(command_line);
  addSelectionOptions(command_line);
  addEachOptions(command_line);
  addInputOptions(command_line);
  addCommonOptions(command_line);
  return runApp(command_line, argc, argv, run);
}
