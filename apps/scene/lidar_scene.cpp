// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Street scenes: their options, the cloud and the report.

#include "scene/lidar_scene.h"

#include "cli/errors.h"
#include "cli/filter_app.h"
#include "scene/lidar.h"

#include <algorithm>
#include <limits>

namespace pcl::app {
namespace {

using pcl::scene::LidarOptions;
using pcl::scene::LidarScan;

constexpr double max_noise = 0.1; // meters: a kerb drowns in more

LidarOptions
lidarOptions(const Arguments& arguments)
{
  LidarOptions options;
  options.seed = arguments.integer("seed", 0, std::numeric_limits<std::uint64_t>::max())
                     .value_or(options.seed);
  options.beams = arguments.choice("beams", {"64", "16"}) == "16" ? 16 : 64;
  const std::string noise = arguments.text("noise", "lidar");
  if (noise == "none") {
    options.sigma = 0.0;
    options.drop_outs = false;
  }
  else if (noise != "lidar") {
    const auto sigma = parseNumber(noise);
    if (!sigma || *sigma < 0.0 || *sigma > max_noise)
      arguments.fail("noise",
                     "lidar, none, or a number of meters from 0 to 0.1 with -sensor "
                     "lidar");
    options.sigma = *sigma;
    options.drop_outs = false;
  }
  return options;
}

std::vector<float>
channel(const std::vector<float>& values, std::size_t first)
{
  std::vector<float> one;
  one.reserve(values.size() / 3);
  for (std::size_t i = first; i < values.size(); i += 3)
    one.push_back(values[i]);
  return one;
}

CloudFile
toCloud(const LidarScan& scan, bool with_normals)
{
  CloudFile cloud;
  cloud.path = "the generated street";
  cloud.blob.width = static_cast<std::uint32_t>(scan.size());
  cloud.blob.height = 1;
  const char* const names[] = {"x", "y", "z", "normal_x", "normal_y", "normal_z"};
  for (std::size_t c = 0; c < 3; ++c)
    setField(cloud, names[c], channel(scan.xyz, c));
  for (std::size_t c = 0; c < 3 && with_normals; ++c)
    setField(cloud, names[3 + c], channel(scan.normals, c));
  setField(cloud, "ground", scan.ground);
  setField(cloud, "surface", scan.surface);
  setField(cloud, "instance", scan.instance);
  setField(cloud, "ring", scan.ring);
  return cloud;
}

} // namespace

void
addLidarOptions(CommandLine& command_line)
{
  command_line
      .option("sensor",
              "S",
              "camera (default), or lidar: a laser scanner in a street, fields ground, "
              "surface,\ninstance and ring; its -noise is lidar (default), none, or a "
              "sigma")
      .option("beams", "N", "of the lidar, 64 (default) or 16");
}

bool
isLidar(const Arguments& arguments)
{
  if (arguments.choice("sensor", {"camera", "lidar"}) == "camera") {
    if (arguments.has("beams"))
      throw UsageError("-beams '" + arguments.text("beams") +
                       "' without a laser; expected -sensor lidar with it");
    return false;
  }
  for (const char* camera : {"objects",
                             "width",
                             "height",
                             "organized",
                             "sampling",
                             "label",
                             "shapes",
                             "turn",
                             "faces"})
    if (arguments.has(camera))
      throw UsageError(std::string("-") + camera +
                       " with -sensor 'lidar'; expected only with -sensor camera");
  return true;
}

CloudFile
lidarCloud(const Arguments& arguments, Report& report)
{
  const LidarOptions options = lidarOptions(arguments);
  const LidarScan scan =
      report.time("generate", [&] { return pcl::scene::scanStreet(options); });
  CloudFile cloud = toCloud(scan, arguments.has("normals"));
  reportPoints(*pointsOf(cloud), report);
  const auto count = [&](std::uint32_t label) {
    return static_cast<std::uint64_t>(
        std::count(scan.ground.begin(), scan.ground.end(), label));
  };
  report.setCount("counts", "ground", count(pcl::scene::GroundTrue));
  report.setCount("counts", "kerb", count(pcl::scene::GroundVoid));
  report.setCount("counts", "objects", scan.objects);
  report.setText("parameters", "sensor", "lidar");
  report.setCount("parameters", "seed", options.seed);
  report.setCount("parameters", "beams", options.beams);
  report.setText("parameters", "noise", arguments.text("noise", "lidar"));
  return cloud;
}

} // namespace pcl::app
