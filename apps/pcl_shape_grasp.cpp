// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// pcl_shape_grasp: finds places for a suction cup.

#include "cli/command_line.h"
#include "cli/filter_app.h"
#include "cli/pcl_errors.h"
#include "detection/detection.h"
#include "io/files.h"
#include "results/result_files.h"
#include "results/selection.h"

#include <pcl/segmentation/suction_grasp_estimation.h>

#include <array>
#include <cstdio>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

namespace {

using namespace pcl::app;
using Estimation = pcl::SuctionGraspEstimation<pcl::PointXYZ>;
using Grasps = std::vector<pcl::SuctionGrasp>;

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
std::vector<std::pair<TargetGrasps, pcl::IndicesPtr>>
targetsOf(const CloudFile& file,
          const pcl::PointCloud<pcl::PointXYZ>& points,
          const Arguments& arguments)
{
  std::vector<std::pair<TargetGrasps, pcl::IndicesPtr>> targets;
  if (!arguments.has("each")) {
    targets.emplace_back(TargetGrasps(), selectedPoints(file, points, arguments));
    return targets;
  }
  for (const auto& [object, indices] : selectedObjects(file, points, arguments)) {
    TargetGrasps target;
    target.object = object;
    targets.emplace_back(target, indices);
  }
  return targets;
}

std::vector<TargetGrasps>
findGrasps(Estimation& estimation,
           const CloudFile& file,
           const Arguments& arguments,
           Report& report)
{
  const auto points = pointsOf(file);
  auto targets = targetsOf(file, *points, arguments);
  estimation.setInputCloud(points);
  estimation.setShapeField(surfaceFieldOf(file,
                                          points,
                                          std::nullopt,
                                          resolutionOf(arguments),
                                          arguments.threads(),
                                          report));
  setViewPoint(estimation, file, arguments);
  std::vector<TargetGrasps> found;
  for (auto& [target, indices] : targets) {
    target.points = indices->size();
    estimation.setIndices(indices);
    withPclErrors(file.path,
                  [&, &grasps = target.grasps] { return estimation.compute(grasps); });
    found.push_back(std::move(target));
  }
  return found;
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
print(const std::vector<TargetGrasps>& targets)
{
  for (const TargetGrasps& target : targets) {
    if (target.object)
      std::printf("object %u, %zu points:\n", *target.object, target.points);
    print(target.grasps);
  }
}

void
reportCounts(const std::vector<TargetGrasps>& targets, Report& report)
{
  std::uint64_t points = 0, grasps = 0, sealing = 0;
  for (const TargetGrasps& target : targets) {
    points += target.points;
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
  const std::vector<TargetGrasps> targets = report.time(
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
