// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Street scenes: their options, the cloud and the report.

#include "cli/filter_app.h"
#include "io/errors.h"
#include "scene/scene_cloud.h"
#include "scene/scene_kind.h"
#include "scene/scene_maker.h"
#include "scene/sensors/lidar.h"

#include <algorithm>
#include <array>

namespace pcl::app {
namespace {

using pcl::scene::LidarOptions;
using pcl::scene::LidarPattern;
using pcl::scene::LidarScan;
using pcl::scene::StreetPlace;

const std::array<std::pair<const char*, StreetPlace>, 10> places{
    {{"town", StreetPlace::Town},
     {"bumps", StreetPlace::Bumps},
     {"bridge", StreetPlace::Bridge},
     {"canopy", StreetPlace::Canopy},
     {"country", StreetPlace::Country},
     {"deck", StreetPlace::Deck},
     {"garage", StreetPlace::Garage},
     {"tunnel", StreetPlace::Tunnel},
     {"corridor", StreetPlace::Corridor},
     {"hall", StreetPlace::Hall}}};

constexpr NumberRange speed_range{0.0, 60.0, false, "a number of m/s from 0 to 60"};
constexpr NumberRange yaw_rate_range{
    -180.0, 180.0, false, "a number of degrees per second from -180 to 180"};

const std::array<std::pair<const char*, LidarPattern>, 3> patterns{
    {{"turn", LidarPattern::Turn},
     {"rosette70", LidarPattern::Rosette70},
     {"rosette120", LidarPattern::Rosette120}}};

/** The choice of that name; the first one is the default. */
template <typename Choices>
auto
chosen(const Arguments& arguments, const std::string& option, const Choices& choices)
{
  std::vector<std::string> names;
  for (const auto& choice : choices)
    names.emplace_back(choice.first);
  const std::string name = arguments.choice(option, names);
  for (const auto& choice : choices)
    if (name == choice.first)
      return choice.second;
  return choices.front().second;
}

LidarOptions
lidarOptions(const Arguments& arguments)
{
  LidarOptions options;
  options.seed = seedOf(arguments);
  options.beams = static_cast<unsigned>(
      std::stoul(arguments.choice("beams", {"64", "16", "32", "128"})));
  options.place = chosen(arguments, "place", places);
  options.pattern = chosen(arguments, "pattern", patterns);
  options.mirrors = arguments.has("mirrors");
  options.fillers = arguments.has("fillers");
  options.speed = arguments.number("speed", speed_range).value_or(options.speed);
  options.yaw_rate =
      arguments.number("yaw_rate", yaw_rate_range).value_or(options.yaw_rate);
  if (options.pattern != LidarPattern::Turn && arguments.has("beams"))
    throw UsageError("-beams '" + arguments.text("beams") +
                     "' of a rosette; expected only with -pattern turn");
  if (const auto sigma = noiseSigma(arguments, "lidar")) {
    options.sigma = *sigma;
    options.drop_outs = false;
  }
  return options;
}

CloudFile
toCloud(const LidarScan& scan, const Arguments& arguments)
{
  CloudFile cloud = cloudOf("the generated street", scan.xyz, scan.normals, arguments);
  setField(cloud, "ground", scan.ground);
  setField(cloud, "surface", scan.surface);
  setField(cloud, "instance", scan.instance);
  setField(cloud, "ring", scan.ring);
  return cloud;
}

CloudFile
lidarCloud(const Arguments& arguments, const LidarOptions& options, Report& report)
{
  const LidarScan scan =
      report.time("generate", [&] { return pcl::scene::scanStreet(options); });
  CloudFile cloud = toCloud(scan, arguments);
  reportPoints(*pointsOf(cloud), report);
  const auto count = [&](std::uint32_t label) {
    return static_cast<std::uint64_t>(
        std::count(scan.ground.begin(), scan.ground.end(), label));
  };
  report.setCount("counts", "ground", count(pcl::scene::GroundTrue));
  report.setCount("counts", "curb", count(pcl::scene::GroundVoid));
  report.setCount("counts", "objects", scan.objects);
  report.setText("parameters", "sensor", "lidar");
  report.setCount("parameters", "seed", options.seed);
  report.setText("parameters", "place", arguments.text("place", "town"));
  report.setText("parameters", "pattern", arguments.text("pattern", "turn"));
  if (options.pattern == LidarPattern::Turn)
    report.setCount("parameters", "beams", options.beams);
  report.setText("parameters", "noise", arguments.text("noise", "lidar"));
  report.setNumber("parameters", "speed", options.speed);
  report.setNumber("parameters", "yaw_rate", options.yaw_rate);
  return cloud;
}

} // namespace

void
addLidarOptions(CommandLine& command_line)
{
  command_line.option("beams", "N", "of the lidar, 64 (default), 16, 32 or 128")
      .option("pattern",
              "P",
              "of the lidar: turn (default), or rosette70 or rosette120, which look "
              "forward only")
      .flag("mirrors", "wet ground mirrors what is behind it: points below the ground")
      .flag("fillers", "rays of the lidar that do not return are points at 0,0,0")
      .option(
          "speed",
          "V",
          "m/s: the lidar drives on during its scan of a tenth of a second, and each "
          "point\nis in the frame of its own ray (0)")
      .option("yaw_rate", "W", "degrees per second: it turns left meanwhile (0)");
}

SceneMaker
streetScene(const Arguments& arguments)
{
  return [&arguments, options = lidarOptions(arguments)](Report& report) {
    return lidarCloud(arguments, options, report);
  };
}

} // namespace pcl::app
