// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Rooms and house fronts: their options, the cloud and the report.

#include "scene/room_scene.h"

#include "cli/errors.h"
#include "scene/scene_cloud.h"

#include <limits>

namespace pcl::app {
namespace {

using pcl::scene::StationOptions;

constexpr std::uint64_t max_stations = 4;
constexpr double max_noise = 0.1; // meters: a step of a stair drowns in more
constexpr NumberRange step_range{
    0.05, 2.0, false, "a number of degrees from 0.05 to 2"};

} // namespace

StationOptions
stationOptions(const Arguments& arguments)
{
  StationOptions options;
  options.seed = arguments.integer("seed", 0, std::numeric_limits<std::uint64_t>::max())
                     .value_or(options.seed);
  options.is_outdoors = arguments.text("place") == "facade";
  options.stations = static_cast<unsigned>(
      arguments.integer("stations", 1, max_stations).value_or(options.stations));
  options.step = arguments.number("step", step_range).value_or(options.step);
  const std::string noise = arguments.text("noise", "station");
  if (noise == "none")
    options.sigma = 0.0;
  else if (noise != "station") {
    const auto sigma = parseNumber(noise);
    if (!sigma || *sigma < 0.0 || *sigma > max_noise)
      arguments.fail("noise",
                     "station, none, or a number of meters from 0 to 0.1 with -sensor "
                     "station");
    options.sigma = *sigma;
  }
  return options;
}

CloudFile
roomCloud(const Arguments& arguments, const StationOptions& options, Report& report)
{
  const pcl::scene::Scene scene =
      report.time("generate", [&] { return pcl::scene::scanPlace(options); });
  CloudFile cloud = sceneCloud(scene, arguments);
  reportScene(scene, cloud, report);
  report.setText("parameters", "sensor", "station");
  report.setCount("parameters", "seed", options.seed);
  report.setText("parameters", "place", arguments.text("place"));
  report.setCount("parameters", "stations", options.stations);
  report.setNumber("parameters", "step", options.step);
  report.setNumber("parameters", "noise", options.sigma);
  return cloud;
}

} // namespace pcl::app
