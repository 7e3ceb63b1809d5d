// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// pcl_shape_grasp: finds places for a suction cup.

#include "cli/command_line.h"
#include "cli/errors.h"
#include "cli/files.h"
#include "cli/filter_app.h"
#include "cli/pcl_errors.h"
#include "detection/detection.h"
#include "results/result_files.h"

#include <pcl/common/point_tests.h>
#include <pcl/pcl_base.h>
#include <pcl/segmentation/suction_grasp_estimation.h>

#include <array>
#include <cstdio>
#include <optional>
#include <sstream>

namespace {

using namespace pcl::app;
using Estimation = pcl::SuctionGraspEstimation<pcl::PointXYZ>;
using Grasps = std::vector<pcl::SuctionGrasp>;

constexpr std::uint64_t default_grasps = 10;
constexpr std::uint64_t grasp_limit = 1000000; // more than any list is read for
const char* const three_numbers = "three numbers of meters, X,Y,Z";

constexpr std::uint64_t max_label = 0xffffffff;

struct Box {
  std::array<double, 3> low{}, high{};

  bool
  contains(const pcl::PointXYZ& point) const
  {
    for (std::size_t c = 0; c < 3; ++c)
      if (!(point.data[c] >= low[c] && point.data[c] <= high[c]))
        return false;
    return true;
  }
};

std::optional<Box>
boxOf(const Arguments& arguments)
{
  const std::string expected =
      "six numbers of meters, X1,Y1,Z1,X2,Y2,Z2, the first three below the others";
  const auto numbers = arguments.numbers("box", 6, expected);
  if (!numbers)
    return std::nullopt;
  Box box;
  for (std::size_t c = 0; c < 3; ++c) {
    box.low[c] = (*numbers)[c];
    box.high[c] = (*numbers)[c + 3];
    if (!(box.low[c] < box.high[c]))
      arguments.fail("box", expected);
  }
  return box;
}

/** -field, -value and -box, which select some points of a cloud. */
void
addSelectionOptions(CommandLine& command_line)
{
  command_line.option("field", "F", "only the points where the field F ...")
      .option("value", "V", "... has the value V")
      .option("box", "X1,Y1,Z1,X2,Y2,Z2", "only the points in this box, meters");
}

void
checkSelection(const Arguments& arguments)
{
  arguments.hasBoth("field", "value");
  arguments.integer("value", 0, max_label);
  boxOf(arguments);
}

void
reportSelection(const Arguments& arguments, Report& report)
{
  if (arguments.has("field")) {
    report.setText("parameters", "field", arguments.text("field"));
    report.setCount("parameters", "value", *arguments.integer("value", 0, max_label));
  }
  if (arguments.has("box"))
    report.setText("parameters", "box", arguments.text("box"));
}

/** The finite points that are selected: all of them without these options. */
pcl::IndicesPtr
selectedPoints(const CloudFile& file,
               const pcl::PointCloud<pcl::PointXYZ>& points,
               const Arguments& arguments)
{
  std::vector<std::uint32_t> labels;
  std::uint64_t label = 0;
  if (arguments.has("field")) {
    labels = labelsOf(file, arguments.text("field"));
    label = *arguments.integer("value", 0, max_label);
  }
  std::optional<Box> box = boxOf(arguments);
  for (std::size_t c = 0; box && c < 3; ++c) { // of the file's coordinates
    box->low[c] -= file.offset[c];
    box->high[c] -= file.offset[c];
  }
  auto selected = pcl::make_shared<pcl::Indices>();
  for (std::size_t i = 0; i < points.size(); ++i)
    if (pcl::isFinite(points[i]) && (labels.empty() || labels[i] == label) &&
        (!box || box->contains(points[i])))
      selected->push_back(static_cast<pcl::index_t>(i));
  if (selected->empty())
    throw InputError(file.path + ": no finite point is selected by -field '" +
                     arguments.text("field") + "' -value '" + arguments.text("value") +
                     "' -box '" + arguments.text("box") + "'; expected at least one");
  return selected;
}

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

Grasps
findGrasps(Estimation& estimation,
           const CloudFile& file,
           const Arguments& arguments,
           Report& report)
{
  const auto points = pointsOf(file);
  estimation.setInputCloud(points);
  estimation.setShapeField(surfaceFieldOf(file,
                                          points,
                                          std::nullopt,
                                          resolutionOf(arguments),
                                          arguments.threads(),
                                          report));
  estimation.setIndices(selectedPoints(file, *points, arguments));
  setViewPoint(estimation, file, arguments);
  Grasps grasps;
  withPclErrors(file.path, [&] { return estimation.compute(grasps); });
  return grasps;
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
  const Grasps grasps = report.time(
      "grasps", [&] { return findGrasps(estimation, file, arguments, report); });
  std::uint64_t sealing = 0;
  for (const pcl::SuctionGrasp& grasp : grasps)
    sealing += grasp.seals() ? 1 : 0;
  report.setCount("counts", "target_points", estimation.getIndices()->size());
  report.setCount("counts", "grasps", grasps.size());
  report.setCount("counts", "sealing", sealing);
  writeJson(arguments, graspsToJson(arguments.app(), report, grasps));
  printSummary(path, report);
  print(grasps);
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
      "are in the way.");
  command_line.option("surface", "S", "to look for: any (default), planar, curved")
      .option("cup_radius", "R", "of the cup's lip, meters (0.01)")
      .option("compliance", "C", "by how many radii the lip may bend, 0 to 1 (0.2)")
      .option("max_grasps", "N", "at most (10)")
      .option(
          "viewpoint", "X,Y,Z", "from where the cloud was seen, instead of the file's");
  addResolutionOption(command_line);
  addSelectionOptions(command_line);
  addInputOptions(command_line);
  addCommonOptions(command_line);
  return runApp(command_line, argc, argv, run);
}
