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
  return arguments.choice(
      "sensor", {"camera", "lidar", "samples", "stereo", "tof", "structured"});
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
  const std::string value = arguments.text(option);
  throw UsageError('-' + option + (value.empty() ? "" : " '" + value + "'") + ' ' +
                   why + "; expected " + expected);
}

void
refuseOfLaser(const Arguments& arguments)
{
  for (const char* laser : {"beams", "pattern", "mirrors", "fillers"})
    refuse(arguments, laser, "without a laser", "-sensor lidar with it");
  const std::string place = arguments.text("place", "table");
  if (place != "table" && place != "part")
    refuse(arguments,
           "place",
           "without a laser",
           "table or part, or -sensor lidar with it");
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
                             "waviness"})
    if (arguments.has(camera))
      throw UsageError(std::string("-") + camera +
                       " with -sensor 'lidar'; expected only with -sensor camera");
}

} // namespace

void
addKindOptions(CommandLine& command_line)
{
  command_line
      .option(
          "sensor",
          "S",
          "camera (default); stereo, tof or structured: depth cameras with their own "
          "noise;\nsamples: no camera, points on all surfaces; lidar: a laser scanner "
          "in a street,\nfields ground, surface, instance and ring; its -noise is "
          "lidar (default), none, or\na sigma")
      .option(
          "place",
          "P",
          "table (default) or part: machined parts, on the table for cameras, one "
          "alone for\nsamples; of the lidar: town (default), bumps, bridge, canopy, "
          "country, deck,\ngarage, tunnel, corridor, hall")
      .option("size", "S", "of a part for samples: its longest side, meters (0.1)")
      .option(
          "spread",
          "S",
          "of samples of a part: even (default), no two nearer than 3/4 of -sampling; "
          "or random")
      .option(
          "waviness",
          "S,L",
          "of stereo, tof and structured: sigma and length of the waves, meters (of "
          "the seed:\n0.0005 to 0.003 and 0.01 to 0.06; structured: none)");
}

SceneKind
sceneKind(const Arguments& arguments)
{
  if (sensorOf(arguments) == "lidar")
    return SceneKind::Street;
  return arguments.text("place") == "part" ? SceneKind::Part : SceneKind::Table;
}

bool
isSampled(const Arguments& arguments)
{
  return sensorOf(arguments) == "samples" || arguments.has("sampling");
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
  const bool is_part = kind == SceneKind::Part;
  if (isDepthCamera(arguments)) {
    const std::string with = "with -sensor '" + arguments.text("sensor") + '\'';
    refuse(arguments, "noise", with, "-noise with -sensor camera or samples only");
    refuse(arguments, "sampling", with, "-sampling with -sensor samples only");
  }
  else
    refuse(arguments,
           "waviness",
           "without a depth camera",
           "-sensor stereo, tof or structured with it");
  if (is_part)
    refuse(arguments, "shapes", "with -place 'part'", "-shapes with -place table only");
  const bool is_sampled_part = is_part && isSampled(arguments);
  if (isSampled(arguments))
    for (const char* camera : {"width", "height", "organized", "turn"})
      refuse(arguments, camera, "without a camera", "it without -sampling");
  if (is_sampled_part)
    refuse(arguments, "objects", "of one part", "it with a camera only");
  else
    for (const char* option : {"size", "spread"})
      refuse(arguments,
             option,
             "without a sampled part",
             "-place part -sensor samples with it");
}

} // namespace pcl::app
