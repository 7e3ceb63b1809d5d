// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Reads -sensor and -place, and refuses options that another one has.

#include "scene/scene_kind.h"

#include "cli/errors.h"

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

/** Refuse an option that was given. */
void
refuse(const Arguments& arguments,
       const std::string& option,
       const std::string& why,
       const std::string& expected)
{
  if (!arguments.has(option))
    return;
  const bool is_flag =
      option == "organized" || option == "mirrors" || option == "fillers";
  const std::string value = is_flag ? "" : " '" + arguments.text(option) + '\'';
  throw UsageError('-' + option + value + ' ' + why + "; expected " + expected);
}

void
refuseOfLaser(const Arguments& arguments)
{
  for (const char* laser : {"beams", "pattern", "mirrors", "fillers"})
    refuse(arguments, laser, "without a laser", "-sensor lidar with it");
  const std::string place = arguments.text("place", "table");
  if (place != "table" && place != "part" && place != "room" && place != "facade")
    refuse(arguments,
           "place",
           "without a laser",
           "table, part, room or facade, or -sensor lidar with it");
}

/** A station stands in a room or before a house and nowhere else; photogrammetry needs
 * a part. */
void
checkPlace(const Arguments& arguments)
{
  const std::string sensor = sensorOf(arguments);
  const std::string place = arguments.text("place", "table");
  const bool is_for_stations = place == "room" || place == "facade";
  if ((sensor == "station") != is_for_stations)
    throw UsageError("-place '" + place + "' with -sensor '" + sensor +
                     "'; expected -place room or facade with -sensor station, and no "
                     "other");
  if (sensor == "photogrammetry" && place != "part")
    throw UsageError("-place '" + place +
                     "' with -sensor 'photogrammetry'; expected -place part");
}

void
refuseOfCamera(const Arguments& arguments)
{
  for (const char* camera : {"objects",
                             "width",
                             "height",
                             "organized",
                             "sampling",
                             "shapes",
                             "turn",
                             "faces",
                             "size",
                             "spread",
                             "waviness",
                             "stations",
                             "step"})
    if (arguments.has(camera))
      throw UsageError(std::string("-") + camera +
                       " with -sensor 'lidar'; expected only with -sensor camera");
}

void
checkPartOptions(const Arguments& arguments, SceneKind kind)
{
  const bool is_part = kind == SceneKind::Part;
  if (is_part)
    refuse(arguments, "shapes", "with -place 'part'", "-shapes with -place table only");
  if (is_part && isSampled(arguments))
    refuse(arguments, "objects", "of one part", "it with a camera only");
  else
    for (const char* option : {"size", "spread"})
      refuse(arguments,
             option,
             "without a part that is alone",
             "-place part -sensor samples with it");
  if (sensorOf(arguments) == "photogrammetry")
    for (const char* option : {"noise", "spread"})
      refuse(
          arguments, option, "with -sensor 'photogrammetry'", "it with samples only");
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
      .option("place",
              "P",
              "table (default) or part: machined parts, on the table for cameras, one "
              "alone for\nsamples and photogrammetry; room or facade for a station; of "
              "the lidar: "
              "town (default), bumps,\nbridge, canopy, country, deck, garage, tunnel, "
              "corridor, hall")
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

void
checkKindOptions(const Arguments& arguments)
{
  const SceneKind kind = sceneKind(arguments);
  if (kind == SceneKind::Street)
    return refuseOfCamera(arguments);
  refuseOfLaser(arguments);
  checkPlace(arguments);
  const std::string with = "with -sensor '" + sensorOf(arguments) + '\'';
  if (kind == SceneKind::Room) {
    for (const char* option : {"sampling", "shapes", "objects"})
      refuse(arguments, option, with, "it with another sensor");
  }
  else
    for (const char* option : {"stations", "step"})
      refuse(arguments, option, with, "-sensor station with it");
  if (isDepthCamera(arguments)) {
    refuse(arguments, "noise", with, "-noise with -sensor camera or samples only");
    refuse(arguments, "sampling", with, "-sampling with -sensor samples only");
  }
  else
    refuse(arguments, "waviness", with, "-sensor stereo, tof or structured with it");
  if (isSampled(arguments) || kind == SceneKind::Room)
    for (const char* camera : {"width", "height", "organized", "turn"})
      refuse(arguments, camera, "without a camera", "it without -sampling");
  checkPartOptions(arguments, kind);
}

} // namespace pcl::app
