// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// pcl_shape_ground: marks the ground in a vehicle's laser scan.

#include "cli/command_line.h"
#include "cli/filter_app.h"
#include "cli/pcl_errors.h"

#include <pcl/segmentation/shape_ground_segmentation.h>

namespace {

using namespace pcl::app;
using Segmentation = pcl::ShapeGroundSegmentation<pcl::PointXYZ>;

constexpr NumberRange slope_range{
    0.0, 89.0, true, "an angle above 0, up to 89 degrees"};
constexpr double degree = 3.14159265358979323846 / 180.0;

Eigen::Vector3f
upOf(const Arguments& arguments)
{
  const std::string expected =
      "a direction x,y,z, three numbers that are not all 0, such as 0,0,1";
  const auto numbers = arguments.numbers("up", 3, expected);
  if (!numbers)
    return Eigen::Vector3f::UnitZ();
  const Eigen::Vector3f up = Eigen::Vector3d(numbers->data()).cast<float>();
  if (!(up.squaredNorm() > 0.0f) || !up.allFinite())
    arguments.fail("up", expected);
  return up;
}

Segmentation
segmentation(const Arguments& arguments)
{
  Segmentation ground;
  const pcl::GroundParameters defaults;
  ground.setUp(upOf(arguments));
  if (const auto slope = arguments.number("max_slope", slope_range))
    ground.setMaxSlope(static_cast<float>(*slope * degree));
  ground.setMaxStep(static_cast<float>(
      arguments.number("max_step", positive_length).value_or(defaults.max_step)));
  ground.setSensorHeight(static_cast<float>(
      arguments.number("sensor_height", positive_length).value_or(0.0)));
  ground.setNumberOfThreads(arguments.threads());
  return ground;
}

void
addGround(CloudFile& file,
          const Arguments& arguments,
          Segmentation& segmentation,
          float threshold,
          Report& report)
{
  const auto points = pointsOf(file);
  reportPoints(*points, report);
  segmentation.setInputCloud(points);
  std::vector<float> likelihood;
  withPclErrors(file.path, [&] {
    report.time("ground", [&] { segmentation.compute(likelihood); });
    return likelihood.size() == file.size();
  });
  std::vector<std::uint32_t> ground(file.size(), 0);
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < ground.size(); ++i)
    count += ground[i] = likelihood[i] >= threshold;
  constexpr double few = 0.01; // scans of streets have 10 % and more, of halls some
  if (static_cast<double>(count) < few * static_cast<double>(countFinite(*points)))
    logLine(arguments.app() + ": " + file.path +
            ": warning: " + (count == 0 ? "no ground" : "very little ground") +
            " was found; is -up " + arguments.text("up", "0,0,1") + " right?");
  const pcl::GroundParameters& used = segmentation.getParameters();
  report.setText("parameters", "up", arguments.text("up", "0,0,1"));
  report.setNumber("parameters", "max_slope_degrees", used.max_slope / degree);
  report.setNumber("parameters", "max_step", used.max_step);
  report.setNumber("parameters", "threshold", threshold);
  if (used.sensor_height > 0.0f)
    report.setNumber("parameters", "sensor_height", used.sensor_height);
  report.setCount("parameters", "threads", arguments.threads());
  report.setCount("counts", "ground", count);
  setField(file, "ground_likelihood", likelihood);
  setField(file, "ground", ground);
}

int
run(const Arguments& arguments)
{
  Segmentation ground = segmentation(arguments);
  const auto threshold =
      static_cast<float>(arguments.number("threshold", probability).value_or(0.5));
  return runFilter(arguments, [&](CloudFile& file, Report& report) {
    addGround(file, arguments, ground, threshold, report);
  });
}

} // namespace

int
main(int argc, char** argv)
{
  CommandLine command_line(
      "pcl_shape_ground",
      "in.pcd out.pcd",
      "Add the fields ground_likelihood (NaN unknown) and ground: "
      "1 on road, sidewalk and the\nlike in a vehicle's laser scan, "
      "0 elsewhere. The scanner is at the VIEWPOINT.");
  command_line.option("up", "X,Y,Z", "a direction, roughly up (0,0,1)")
      .option("max_slope", "A", "of the ground, degrees (20)")
      .option("max_step", "S", "that ground continues over, meters: a curb (0.2)")
      .option("sensor_height",
              "H",
              "of the scanner above the ground, meters (found: ground is below it)")
      .option("threshold", "L", "the likelihood from which a point is ground (0.5)");
  addFilterOptions(command_line);
  return runApp(command_line, argc, argv, run);
}
