// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Rooms and house fronts: their options, the cloud and the report.

#include "io/errors.h"
#include "scene/scene_cloud.h"
#include "scene/scene_kind.h"
#include "scene/scene_maker.h"
#include "scene/sensors/station_scan.h"
#include "scene/worlds/place.h"

#include <string>

namespace pcl::app {
namespace {

using pcl::scene::StationOptions;

constexpr NumberRange step_range{
    0.05, 2.0, false, "a number of degrees from 0.05 to 2"};

/** In a few rooms furniture leaves fewer places than usual. */
void
checkStations(const StationOptions& options)
{
  if (options.is_outdoors)
    return;
  const std::size_t places = pcl::scene::randomRoom(options.seed).stations.size();
  if (options.stations > places)
    throw UsageError("-stations '" + std::to_string(options.stations) +
                     "': the room of -seed " + std::to_string(options.seed) +
                     " has places for " + std::to_string(places) +
                     "; expected that many at most, or another -seed");
}

StationOptions
stationOptions(const Arguments& arguments)
{
  StationOptions options;
  options.seed = seedOf(arguments);
  options.is_outdoors = arguments.text("place") == "facade";
  options.stations =
      static_cast<unsigned>(arguments.integer("stations", 1, pcl::scene::max_stations)
                                .value_or(options.stations));
  options.step = arguments.number("step", step_range).value_or(options.step);
  options.sigma = noiseSigma(arguments, "station").value_or(options.sigma);
  checkStations(options);
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

} // namespace

SceneMaker
roomScene(const Arguments& arguments)
{
  return [&arguments, options = stationOptions(arguments)](Report& report) {
    return roomCloud(arguments, options, report);
  };
}

} // namespace pcl::app
