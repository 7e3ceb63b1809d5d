// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Table scenes: their options, the cloud and the report.

#include "scene/table_scene.h"

#include "cli/errors.h"
#include "cli/filter_app.h"
#include "scene/surface_samples.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <sstream>

namespace pcl::app {
namespace {

using pcl::scene::Scene;
using pcl::scene::SceneOptions;

constexpr std::uint64_t max_objects = 30; // more do not fit on the table
constexpr std::uint64_t min_pixels = 16;  // fewer show no surface
constexpr std::uint64_t max_pixels = 4096;
constexpr double max_noise = 0.1; // meters: an object's size
constexpr NumberRange turn_range{
    -180.0, 180.0, false, "a number of degrees from -180 to 180"};

void
setNoise(const Arguments& arguments, SceneOptions& options)
{
  const std::string noise = arguments.text("noise", "kinect");
  if (noise == "kinect")
    options.noise = pcl::scene::Noise::Kinect;
  else if (noise == "none")
    options.noise = pcl::scene::Noise::None;
  else {
    const auto sigma = parseNumber(noise);
    if (!sigma || *sigma < 0.0 || *sigma > max_noise)
      arguments.fail("noise", "kinect, none, or a number of meters from 0 to 0.1");
    options.noise = pcl::scene::Noise::White;
    options.white_sigma = *sigma;
  }
}

std::vector<pcl::scene::Shape>
shapesOf(const Arguments& arguments)
{
  using pcl::scene::Shape;
  std::vector<Shape> shapes;
  std::istringstream names(arguments.text("shapes"));
  for (std::string name; std::getline(names, name, ',');) {
    const auto all = {
        Shape::Box, Shape::Cylinder, Shape::Sphere, Shape::Bowl, Shape::Cone};
    const auto* const found = std::find_if(all.begin(), all.end(), [&](Shape shape) {
      return name == pcl::scene::name(shape);
    });
    if (found == all.end())
      arguments.fail("shapes",
                     "box, cylinder, sphere, bowl and cone, with commas between them");
    shapes.push_back(*found);
  }
  return shapes;
}

constexpr NumberRange spacing_range{
    0.0005, 0.02, false, "a number of meters from 0.0005 to 0.02"};

/** Points all over the surfaces instead of a camera's. */
Scene
sampledScene(const Arguments& arguments, const SceneOptions& options)
{
  for (const char* camera : {"width", "height", "organized", "turn"})
    arguments.exclude("sampling", camera);
  pcl::scene::SampleOptions samples;
  samples.seed = options.seed;
  samples.objects = options.objects;
  samples.shapes = options.shapes;
  samples.spacing = *arguments.number("sampling", spacing_range);
  if (arguments.has("noise") && options.noise == pcl::scene::Noise::Kinect)
    throw UsageError("-noise 'kinect' with -sampling; expected none, or a number of "
                     "meters from 0 to 0.1");
  samples.sigma = options.white_sigma;
  return pcl::scene::sampleScene(samples);
}

/** The pixels of an image that have depth, or all. */
std::vector<std::size_t>
pixelsOf(const Scene& scene, bool organized)
{
  std::vector<std::size_t> pixels;
  for (std::size_t i = 0; i < scene.surface.size(); ++i)
    if (organized || std::isfinite(scene.xyz[3 * i + 2]))
      pixels.push_back(i);
  return pixels;
}

template <typename T>
std::vector<T>
gather(const std::vector<T>& image,
       const std::vector<std::size_t>& pixels,
       std::size_t channels = 1,
       std::size_t channel = 0)
{
  std::vector<T> values;
  values.reserve(pixels.size());
  for (const std::size_t pixel : pixels)
    values.push_back(image[channels * pixel + channel]);
  return values;
}

CloudFile
toCloud(const Scene& scene, const Arguments& arguments)
{
  const bool organized = arguments.has("organized");
  const std::vector<std::size_t> pixels = pixelsOf(scene, organized);
  CloudFile cloud;
  cloud.path = "the generated scene";
  cloud.blob.width =
      organized ? scene.width : static_cast<std::uint32_t>(pixels.size());
  cloud.blob.height = organized ? scene.height : 1;
  const char* const names[] = {"x", "y", "z", "normal_x", "normal_y", "normal_z"};
  for (std::size_t c = 0; c < 3; ++c)
    setField(cloud, names[c], gather(scene.xyz, pixels, 3, c));
  if (arguments.has("normals"))
    for (std::size_t c = 0; c < 3; ++c)
      setField(cloud, names[3 + c], gather(scene.normals, pixels, 3, c));
  setField(cloud, "surface", gather(scene.surface, pixels));
  setField(cloud, "edge", gather(scene.edge, pixels));
  setField(cloud, "instance", gather(scene.instance, pixels));
  setField(cloud, "crease_mm", gather(scene.crease_mm, pixels));
  if (arguments.has("faces"))
    setField(cloud, "face", gather(scene.face, pixels));
  return cloud;
}

void
reportScene(const Scene& scene, const CloudFile& cloud, Report& report)
{
  reportPoints(*pointsOf(cloud), report);
  const auto count = [](const std::vector<std::uint32_t>& labels, std::uint32_t label) {
    return static_cast<std::uint64_t>(std::count(labels.begin(), labels.end(), label));
  };
  const auto surface = labelsOf(cloud, "surface");
  report.setCount("counts", "planar", count(surface, pcl::scene::SurfacePlanar));
  report.setCount("counts", "curved", count(surface, pcl::scene::SurfaceCurved));
  report.setCount("counts", "near_creases", count(surface, pcl::scene::SurfaceCrease));
  report.setCount(
      "counts", "edge", count(labelsOf(cloud, "edge"), pcl::scene::EdgeCrease));
  if (scene.objects.empty()) { // of surfaces without a camera
    const std::set<std::uint32_t> seen(scene.instance.begin(), scene.instance.end());
    report.setCount("counts", "objects", seen.size() - seen.count(0));
    return;
  }
  report.setCount("counts", "objects", scene.objects.size());
  report.setCount("counts",
                  "touching_objects",
                  static_cast<std::uint64_t>(std::count_if(
                      scene.objects.begin(), scene.objects.end(), [](const auto& o) {
                        return !o.touches.empty();
                      })));
}

void
reportSensor(const Arguments& arguments, const SceneOptions& options, Report& report)
{
  if (arguments.has("sampling"))
    report.setNumber(
        "parameters", "sampling", *arguments.number("sampling", spacing_range));
  else {
    report.setCount("parameters", "width", options.width);
    report.setCount("parameters", "height", options.height);
    report.setNumber("parameters", "turn", options.turn);
  }
  const char* usual = arguments.has("sampling") ? "none" : "kinect";
  report.setText("parameters", "noise", arguments.text("noise", usual));
}

} // namespace

SceneOptions
tableOptions(const Arguments& arguments)
{
  SceneOptions options;
  options.seed = arguments.integer("seed", 0, std::numeric_limits<std::uint64_t>::max())
                     .value_or(options.seed);
  const auto small = [&](const char* name, std::uint64_t min, std::uint64_t max) {
    const auto value = arguments.integer(name, min, max);
    return value ? std::optional<unsigned>(static_cast<unsigned>(*value))
                 : std::nullopt;
  };
  options.objects = small("objects", 0, max_objects).value_or(options.objects);
  options.shapes = shapesOf(arguments);
  options.width = small("width", min_pixels, max_pixels).value_or(options.width);
  options.height = small("height", min_pixels, max_pixels).value_or(options.height);
  options.turn = arguments.number("turn", turn_range).value_or(options.turn);
  setNoise(arguments, options);
  return options;
}

CloudFile
tableCloud(const Arguments& arguments, const SceneOptions& options, Report& report)
{
  const Scene scene = report.time("generate", [&] {
    return arguments.has("sampling") ? sampledScene(arguments, options)
                                     : pcl::scene::generateScene(options);
  });
  CloudFile cloud = toCloud(scene, arguments);
  reportScene(scene, cloud, report);
  report.setCount("parameters", "seed", options.seed);
  report.setCount("parameters", "objects", options.objects);
  report.setText("parameters", "shapes", arguments.text("shapes", "all"));
  reportSensor(arguments, options, report);
  report.setFlag("parameters", "organized", arguments.has("organized"));
  return cloud;
}

} // namespace pcl::app
