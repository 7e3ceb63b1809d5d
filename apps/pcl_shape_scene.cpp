// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// pcl_shape_scene: makes scenes whose surfaces, edges and objects are known.

#include "cli/command_line.h"
#include "cli/filter_app.h"
#include "io/files.h"
#include "io/pcd.h"
#include "scene/scene_kind.h"
#include "scene/scene_maker.h"

namespace {

using namespace pcl::app;

/** Checks all options. */
SceneMaker
makerOf(const Arguments& arguments)
{
  checkKindOptions(arguments);
  switch (sceneKind(arguments)) {
  case SceneKind::Street:
    return streetScene(arguments);
  case SceneKind::Room:
    return roomScene(arguments);
  case SceneKind::Part: // a camera sees parts on a table
    return isSampled(arguments) ? partScene(arguments) : tableScene(arguments);
  default:
    return tableScene(arguments);
  }
}

int
run(const Arguments& arguments)
{
  const std::string path = arguments.operands(1).front();
  const auto make = makerOf(arguments);
  const PCDFormat format = outputFormat(arguments);
  arguments.threads();
  checkJsonPath(arguments, {path});
  checkCloudOutput(arguments, path);
  AtomicFile output(path);

  Report report;
  report.setText("", "output", path);
  const CloudFile cloud = make(report);
  report.time("write",
              [&] { output.write(encodeOutput(arguments, path, cloud, format)); });
  commitWithJson(arguments, toJson(arguments.app(), report), output);
  printSummary(path, report, path);
  return 0;
}

} // namespace

int
main(int argc, char** argv)
{
  CommandLine command_line(
      "pcl_shape_scene",
      "out.pcd",
      "Make a table scene, a bin, a machined part, a room or a street as a sensor "
      "sees it, with the\nexact fields surface, edge, instance and crease_mm.");
  command_line.option("seed", "N", "another seed, another scene (1)")
      .option("objects", "N", "on the table or in the bin, 0 to 30 (8)")
      .option("shapes",
              "S,S",
              "of the objects, in turn: box, cylinder, sphere, bowl, cone (all)")
      .option("width", "W", "pixels, 16 to 4096 (640)")
      .option("height", "H", "pixels, 16 to 4096 (480)")
      .option("turn",
              "A",
              "another view: from A degrees further right around the objects (0)")
      .option(
          "noise", "X", "kinect (default), none, or the sigma of white noise, meters")
      .option(
          "sampling",
          "S",
          "no camera: points on all surfaces, S meters apart (a table 0.002, a part "
          "1/100 of\nits size)")
      .flag("organized", "keep the image's layout, with NaN where there is no depth")
      .flag("normals", "write the exact normals too")
      .flag("faces", "write face too: which face of its object a point is on");
  addKindOptions(command_line);
  addLidarOptions(command_line);
  addFormatOption(command_line);
  addCommonOptions(command_line, false);
  return runApp(command_line, argc, argv, run);
}
