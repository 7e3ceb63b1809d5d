// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// pcl_shape_viewer: shows a cloud in a window, or draws a picture of it.

#include "cli/command_line.h"
#include "cli/filter_app.h"
#include "io/errors.h"
#include "io/files.h"
#include "viewer/page.h"
#include "viewer/page_points.h"
#include "viewer/window.h"

#include <iostream>
#include <sstream>
#include <utility>

namespace {

using namespace pcl::app;

struct Size {
  int width;
  int height;
};

std::vector<std::string>
splitNames(const Arguments& arguments, const std::string& option)
{
  std::vector<std::string> names;
  std::istringstream words(arguments.text(option));
  for (std::string word; std::getline(words, word, ',');)
    if (!word.empty())
      names.push_back(word);
  constexpr std::size_t max_views = 16; // smaller ones show nothing
  if (arguments.has(option) && (names.empty() || names.size() > max_views))
    arguments.fail(option, "1 to 16 names of fields, as surface,edge");
  return names;
}

Size
sizeOf(const Arguments& arguments, std::size_t views)
{
  constexpr int view_width = 640, view_height = 480;
  const int columns = columnsOf(views);
  const int rows = rowsOf(views);
  if (!arguments.has("size"))
    return views == 1 ? Size{960, 720} : Size{columns * view_width, rows * view_height};
  const std::string text = arguments.text("size");
  const std::size_t cross = text.find('x');
  constexpr double min_side = 64,
                   max_side = 16384; // legends need the one, OpenGL the other
  const auto width = parseNumber(text.substr(0, cross));
  const auto height =
      parseNumber(cross == std::string::npos ? "" : text.substr(cross + 1));
  for (const auto& side : {width, height})
    if (!side || *side < min_side || *side > max_side ||
        *side != static_cast<int>(*side))
      arguments.fail("size", "WIDTHxHEIGHT, each from 64 to 16384 pixels");
  return {static_cast<int>(*width), static_cast<int>(*height)};
}

std::size_t
maxPointsOf(const Arguments& arguments)
{
  constexpr std::uint64_t usual = 2000000; // a laptop draws 30 times a second
  constexpr std::uint64_t most = 20000000; // a browser still loads
  return arguments.integer("max_points", 1, most).value_or(usual);
}

/** What is drawn over the cloud. */
void
readOverlays(const Arguments& arguments, const CloudFile& cloud, Scene& scene)
{
  if (arguments.has("lines"))
    scene.lines = readLines(arguments.text("lines"));
  if (arguments.has("instances"))
    scene.instances = boxesOf(readInstances(arguments.text("instances")), cloud);
  if (arguments.has("grasps"))
    scene.grasps = readGrasps(arguments.text("grasps"));
  if (arguments.has("normals"))
    scene.normals = normalsOf(cloud);
}

std::vector<std::string>
fieldsOf(const Arguments& arguments, const CloudFile& cloud)
{
  if (arguments.has("field"))
    return splitNames(arguments, "field");
  if (arguments.has("html"))
    return fieldsOfPage(cloud);
  const bool draws_more = arguments.has("lines") || arguments.has("grasps");
  return {draws_more ? "plain" : defaultField(cloud)};
}

void
makeViews(const Arguments& arguments, const CloudFile& cloud, Scene& scene)
{
  const auto names = parseLabelNames(arguments.text("names"));
  for (const std::string& field : fieldsOf(arguments, cloud)) {
    scene.views.push_back(viewOf(cloud, field, names));
    if (arguments.has("shade") && !arguments.has("html"))
      shade(cloud, scene.views.back());
  }
}

Scene
sceneOf(const Arguments& arguments, const CloudFile& cloud)
{
  Scene scene;
  scene.title = "pcl_shape_viewer: " + cloud.path;
  scene.points = pointsOf(cloud);
  scene.keys = arguments.has("keys");
  makeViews(arguments, cloud, scene);
  readOverlays(arguments, cloud, scene);

  const std::size_t pictures = arguments.has("html") ? 1 : scene.views.size();
  const Size size = sizeOf(arguments, pictures);
  scene.width = size.width;
  scene.height = size.height;
  const int columns = columnsOf(pictures);
  const int rows = rowsOf(pictures);
  const float aspect =
      static_cast<float>(size.width * rows) / static_cast<float>(size.height * columns);
  const std::size_t strays = arguments.has("camera") ? 0 : hideStrays(*scene.points);
  if (strays > 0)
    logLine(arguments.app() + ": " + cloud.path +
            ": warning: " + std::to_string(strays) +
            " points that are far from all others are not shown; -camera shows them");
  scene.camera = arguments.has("camera") ? parseCamera(arguments.text("camera"))
                                         : defaultCamera(*scene.points, aspect);
  const auto point_size = arguments.integer("point_size", 1, 50);
  scene.has_point_size = point_size.has_value();
  scene.point_size = point_size
                         ? static_cast<int>(*point_size)
                         : pointSize(*scene.points, scene.camera, scene.height / rows);
  return scene;
}

void
reportView(const FieldView& view, Report& report)
{
  const std::string section = "views/" + view.field;
  if (view.range) {
    report.setNumber(section, "least", view.range->min);
    report.setNumber(section, "most", view.range->max);
    report.setCount(section, "unknown", view.unknown);
  }
  for (const LegendEntry& entry : view.legend)
    report.setCount(section, entry.name, entry.points);
}

void
reportScene(const Scene& scene, Report& report)
{
  reportPoints(*scene.points, report);
  report.setText("", "camera", toText(scene.camera));
  report.setCount("", "width", static_cast<std::uint64_t>(scene.width));
  report.setCount("", "height", static_cast<std::uint64_t>(scene.height));
  report.setCount("", "point_size", static_cast<std::uint64_t>(scene.point_size));
  for (const FieldView& view : scene.views)
    reportView(view, report);
  report.setCount("overlays", "lines", scene.lines.size());
  report.setCount("overlays", "instances", scene.instances.size());
  report.setCount("overlays", "grasps", scene.grasps.grasps.size());
}

void
checkFiles(const Arguments& arguments, const std::string& input)
{
  std::vector<std::string> others{input};
  for (const char* const option : {"lines", "instances", "grasps"})
    if (arguments.has(option))
      others.push_back(arguments.text(option));
  for (const char* const option : {"screenshot", "html"}) {
    checkOutputPath(arguments, option, others);
    if (arguments.has(option))
      others.push_back(arguments.text(option));
  }
  checkJsonPath(arguments, others);
}

void
checkPageOptions(const Arguments& arguments)
{
  arguments.exclude("html", "screenshot");
  if (arguments.has("max_points") && !arguments.has("html"))
    throw UsageError("-max_points is of pages: expected -html with it");
  if (arguments.has("keys") && arguments.has("html"))
    throw UsageError("-keys is of windows and pictures: expected no -html with it");
  maxPointsOf(arguments);
  if (arguments.has("html"))
    requirePage();
}

void
writePage(const Arguments& arguments,
          const CloudFile& cloud,
          Scene seen,
          Report& report)
{
  AtomicFile page(arguments.text("html"));
  const Eigen::Vector3f origin = boxOf(*seen.points).center();
  const Scene scene = moved(std::move(seen), -origin);
  const PageContents contents{
      cloud,
      scene,
      choosePoints(cloud, *scene.points, maxPointsOf(arguments)),
      origin,
      arguments.has("shade")};
  const std::string html = report.time("draw", [&] { return drawPage(contents); });
  page.write(html);
  report.setCount("", "points_shown", contents.points.size());
  commitWithJson(arguments, toJson(arguments.app(), report), page);
  constexpr double bytes_per_megabyte = 1e6;
  std::printf("%s: %zu of %zu points, %zu fields, %.1f MB\n",
              arguments.text("html").c_str(),
              contents.points.size(),
              countFinite(*scene.points),
              scene.views.size(),
              static_cast<double>(html.size()) / bytes_per_megabyte);
}

int
run(const Arguments& arguments)
{
  const std::string input = arguments.operands(1)[0];
  arguments.threads();
  checkPageOptions(arguments);
  checkInputOptions(arguments);
  checkFiles(arguments, input);
  Report report;
  report.setText("", "input", input);
  const CloudFile cloud =
      report.time("read", [&] { return readInput(arguments, input, report); });
  Scene scene = report.time("prepare", [&] { return sceneOf(arguments, cloud); });
  reportScene(scene, report);
  if (arguments.has("html")) {
    writePage(arguments, cloud, std::move(scene), report);
    return 0;
  }
  requireDisplay();
  if (!arguments.has("screenshot")) {
    writeJson(arguments, toJson(arguments.app(), report));
    showWindow(scene);
    return 0;
  }
  AtomicFile picture(arguments.text("screenshot"));
  picture.write(report.time("draw", [&] { return drawPicture(scene); }));
  commitWithJson(arguments, toJson(arguments.app(), report), picture);
  std::cout << arguments.text("screenshot") << ": " << scene.width << " x "
            << scene.height << " pixels, camera " << toText(scene.camera) << '\n';
  return 0;
}

} // namespace

int
main(int argc, char** argv)
{
  CommandLine command_line("pcl_shape_viewer",
                           "in.pcd",
                           "Show a cloud in a window, colored by its fields; or write "
                           "a picture of it with -screenshot, or a page for any "
                           "browser with -html.\nA picture without a screen: "
                           "xvfb-run -a pcl_shape_viewer in.pcd -screenshot out.png");
  command_line
      .option("field",
              "F[,F2,...]",
              "color by these fields, side by side; plain: one color (the field that "
              "says most)")
      .option("names", "V=N,...", "names of labels, as 1=flat,2=corrugated")
      .flag("shade", "darker where the surface turns away; needs normals")
      .flag("normals", "draw the fields normal_x, normal_y, normal_z as arrows")
      .option("lines", "F", "draw the creases of pcl_shape_edge_detection -lines F")
      .option("instances", "F", "draw the objects of pcl_shape_instances -json F")
      .option("grasps", "F", "draw the grasps of pcl_shape_grasp -json F")
      .option(
          "screenshot", "F", "write the picture F (PNG) instead of showing a window")
      .option("html",
              "F",
              "write the page F instead: the cloud with all fields, or those of "
              "-field, for any browser, without a network or a screen")
      .option("max_points", "N", "of a page (2000000); of more, an even choice")
      .option(
          "size", "WxH", "of all views together, pixels (640x480 each, 960x720 one)")
      .option("camera",
              "X,...",
              "x,y,z of position, focus and up, and degrees of view (the cloud's "
              "viewpoint)")
      .option("point_size", "N", "pixels, 1 to 50 (by the distance between points)")
      .flag("keys", "begin with the list of keys on the screen");
  addInputOptions(command_line);
  addCommonOptions(command_line, false);
  return runApp(command_line, argc, argv, run);
}
