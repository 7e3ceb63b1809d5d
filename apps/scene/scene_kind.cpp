// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Reads -sensor and -place, and refuses options of other sensors and places.

#include "scene/scene_kind.h"

#include "io/errors.h"

#include <algorithm>
#include <limits>

namespace pcl::app {
namespace {

/** The first word is the default. */
std::string
sensorOf(const Arguments& arguments)
{
  return arguments.choice("sensor",
                          {"camera",
                           "lidar",
                           "samples",
                           "stereo",
                           "tof",
                           "structured",
                           "station",
                           "photogrammetry"});
}

/** What the options must go with. */
std::string
withSensor(const Arguments& arguments)
{
  const std::string sensor = sensorOf(arguments);
  return sensor == "camera" && arguments.has("sampling")
             ? "with -sampling"
             : "with -sensor '" + sensor + '\'';
}

/** Refuse an option that was given. */
void
refuse(const Arguments& arguments,
       const std::string& option,
       const std::string& why,
       const std::string& expected)
{
  if (!arguments.has(option))
    return;
  const bool is_flag = option == "organized" || option == "faces" ||
                       option == "mirrors" || option == "fillers";
  const std::string value = is_flag ? "" : " '" + arguments.text(option) + '\'';
  throw UsageError('-' + option + value + ' ' + why + "; expected " + expected);
}

/** \brief Options, and the sensors that take them. */
struct SensorOptions {
  std::vector<std::string> options;
  std::vector<std::string> sensors;
};

/** Those of a part are not among them: they need a place too. */
const std::vector<SensorOptions>&
sensorOptions()
{
  static const std::vector<SensorOptions> all{
      {{"beams", "pattern", "mirrors", "fillers", "speed", "yaw_rate"}, {"lidar"}},
      {{"stations", "step"}, {"station"}},
      {{"width", "height", "organized", "turn"},
       {"camera", "stereo", "tof", "structured"}},
      {{"waviness"}, {"stereo", "tof", "structured"}},
      {{"sampling"}, {"camera", "samples", "photogrammetry"}},
      {{"objects", "shapes"}, {"camera", "stereo", "tof", "structured", "samples"}},
      {{"faces"},
       {"camera",
        "stereo",
        "tof",
        "structured",
        "samples",
        "photogrammetry",
        "station"}},
      {{"noise"}, {"camera", "samples", "station", "lidar"}}};
  return all;
}

/** E.g. "stereo, tof or structured". */
std::string
listOf(const std::vector<std::string>& words)
{
  std::string list = words.front();
  for (std::size_t i = 1; i < words.size(); ++i)
    list += (i + 1 < words.size() ? ", " : " or ") + words[i];
  return list;
}

/** Refuse options of other sensors. With -sampling there is no camera: points are
 * samples. */
void
checkSensorOptions(const Arguments& arguments)
{
  const std::string sensor = sensorOf(arguments);
  const std::string taken =
      sensor == "camera" && arguments.has("sampling") ? "samples" : sensor;
  for (const auto& [options, sensors] : sensorOptions())
    if (std::find(sensors.begin(), sensors.end(), taken) == sensors.end())
      for (const std::string& option : options)
        refuse(arguments,
               option,
               withSensor(arguments),
               "it with -sensor " + listOf(sensors));
}

/** A station stands in a room or before a house and nowhere else; photogrammetry needs
 * a part, a bin a camera; streets need a laser. */
void
checkPlace(const Arguments& arguments)
{
  const std::string sensor = sensorOf(arguments);
  const std::string place = arguments.text("place", "table");
  if (place != "table" && place != "bin" && place != "part" && place != "room" &&
      place != "facade")
    refuse(arguments,
           "place",
           "without a laser",
           "table, bin, part, room or facade, or -sensor lidar with it");
  const bool is_for_stations = place == "room" || place == "facade";
  if ((sensor == "station") != is_for_stations)
    throw UsageError("-place '" + place + "' with -sensor '" + sensor +
                     "'; expected -place room or facade with -sensor station, and no "
                     "other");
  if (sensor == "photogrammetry" && place != "part")
    throw UsageError("-place '" + place +
                     "' with -sensor 'photogrammetry'; expected -place part");
  if (place == "bin" && isSampled(arguments))
    refuse(arguments, "place", "of samples", "table or part, or a camera with it");
}

void
checkPartOptions(const Arguments& arguments, SceneKind kind)
{
  const bool is_part = kind == SceneKind::Part;
  if (is_part)
    refuse(arguments, "shapes", "with -place 'part'", "it with -place table or bin");
  if (is_part && isSampled(arguments))
    refuse(arguments, "objects", "of one part", "it with a camera");
  else {
    const std::string why = "without a part that is alone";
    refuse(arguments,
           "size",
           why,
           "it with -place part and -sensor samples or photogrammetry");
    refuse(arguments, "spread", why, "it with -place part and -sensor samples");
  }
  if (sensorOf(arguments) == "photogrammetry")
    refuse(arguments, "spread", withSensor(arguments), "it with -sensor samples");
}

} // namespace

void
addKindOptions(CommandLine& command_line)
{
  command_line
      .option(
          "sensor",
          "S",
          "camera (default); stereo, tof or structured: depth cameras with a noise of "
          "their own;\nsamples: no camera, points on all surfaces; photogrammetry: of "
          "a part; station: a\nscanner on a tripod; lidar: a laser scanner "
          "in a street, fields ground,\nsurface, instance and ring; its -noise is "
          "lidar (default), none, or a sigma")
      .option(
          "place",
          "P",
          "table (default), bin (cameras see it from above) or part: machined parts, "
          "on the\ntable for cameras, one alone for samples and photogrammetry; room "
          "or facade for a\nstation; of the lidar: town (default), bumps, bridge, "
          "canopy, country, deck, garage,\ntunnel, corridor, hall")
      .option("size", "S", "of a part that is alone: its longest side, meters (0.1)")
      .option(
          "spread",
          "S",
          "of samples of a part: even (default), no two nearer than 3/4 of -sampling; "
          "or random")
      .option(
          "waviness",
          "S,L",
          "of stereo, tof and structured: sigma and length of the waves, meters (of "
          "the seed:\n0.0005 to 0.003 and 0.01 to 0.06; structured: none)")
      .option("stations", "N", "that make one cloud, 1 to 4 (1)")
      .option("step", "A", "degrees between a station's rays, 0.05 to 2 (0.3)");
}

SceneKind
sceneKind(const Arguments& arguments)
{
  if (sensorOf(arguments) == "lidar")
    return SceneKind::Street;
  if (sensorOf(arguments) == "station")
    return SceneKind::Room;
  return arguments.text("place") == "part" ? SceneKind::Part : SceneKind::Table;
}

std::uint64_t
seedOf(const Arguments& arguments)
{
  return arguments.integer("seed", 0, std::numeric_limits<std::uint64_t>::max())
      .value_or(1);
}

bool
isSampled(const Arguments& arguments)
{
  const std::string sensor = sensorOf(arguments);
  return sensor == "samples" || sensor == "photogrammetry" || arguments.has("sampling");
}

bool
isDepthCamera(const Arguments& arguments)
{
  const std::string sensor = sensorOf(arguments);
  return sensor == "stereo" || sensor == "tof" || sensor == "structured";
}

std::optional<double>
noiseSigma(const Arguments& arguments, const std::string& usual)
{
  constexpr double max_noise = 0.1; // meters: objects, stairs and curbs drown in more
  const std::string noise = arguments.text("noise", usual);
  if (noise == usual)
    return std::nullopt;
  if (noise == "none")
    return 0.0;
  const auto sigma = parseNumber(noise);
  if (!sigma || *sigma < 0.0 || *sigma > max_noise)
    arguments.fail("noise",
                   (usual == "none" ? "" : usual + ", ") +
                       "none, or a number of meters from 0 to 0.1 " +
                       withSensor(arguments));
  return sigma;
}

void
checkKindOptions(const Arguments& arguments)
{
  const SceneKind kind = sceneKind(arguments);
  checkSensorOptions(arguments);
  if (kind != SceneKind::Street)
    checkPlace(arguments);
  checkPartOptions(arguments, kind);
}

} // namespace pcl::app
