// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Table scenes: their options, the cloud and the report.

#include "scene/scene.h"
#include "scene/scene_cloud.h"
#include "scene/scene_kind.h"
#include "scene/scene_maker.h"
#include "scene/sensors/depth_cameras.h"
#include "scene/sensors/surface_samples.h"

#include <algorithm>
#include <optional>
#include <sstream>

namespace pcl::app {
namespace {

using pcl::scene::Scene;
using pcl::scene::SceneOptions;

constexpr std::uint64_t max_objects = 30; // more do not fit on the table
constexpr std::uint64_t min_pixels = 16;  // fewer show no surface
constexpr std::uint64_t max_pixels = 4096;
constexpr NumberRange turn_range{
    -180.0, 180.0, false, "a number of degrees from -180 to 180"};

constexpr double max_waviness = 0.01; // meters: that of the worst camera is 5 mm
constexpr double min_wave = 0.002, max_wave = 0.2;

void
setWaviness(const Arguments& arguments, SceneOptions& options)
{
  const std::string expected =
      "two numbers of meters, the waves' sigma from 0 to 0.01 and their length from "
      "0.002 to 0.2";
  const auto numbers = arguments.numbers("waviness", 2, expected);
  if (!numbers)
    return;
  const double sigma = numbers->front(), length = numbers->back();
  if (sigma < 0.0 || sigma > max_waviness || length < min_wave || length > max_wave)
    arguments.fail("waviness", expected);
  options.waviness = pcl::scene::Waviness{sigma, length};
}

void
setNoise(const Arguments& arguments, SceneOptions& options)
{
  setWaviness(arguments, options);
  const std::string sensor = arguments.text("sensor", "camera");
  if (sensor == "stereo")
    options.noise = pcl::scene::Noise::Stereo;
  if (sensor == "tof")
    options.noise = pcl::scene::Noise::TimeOfFlight;
  if (sensor == "structured")
    options.noise = pcl::scene::Noise::Structured;
  if (isDepthCamera(arguments))
    return;
  const auto sigma = noiseSigma(arguments, isSampled(arguments) ? "none" : "kinect");
  if (!sigma)
    return;
  options.noise = arguments.text("noise") == "none" ? pcl::scene::Noise::None
                                                    : pcl::scene::Noise::White;
  options.white_sigma = *sigma;
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

constexpr double usual_spacing = 0.002;
constexpr NumberRange spacing_range{
    0.0005, 0.02, false, "a number of meters from 0.0005 to 0.02"};

/** Points all over the surfaces instead of a camera's. */
Scene
sampledScene(const Arguments& arguments, const SceneOptions& options)
{
  pcl::scene::SampleOptions samples;
  samples.seed = options.seed;
  samples.objects = options.objects;
  samples.shapes = options.shapes;
  samples.spacing = arguments.number("sampling", spacing_range).value_or(usual_spacing);
  samples.sigma = options.white_sigma;
  return pcl::scene::sampleScene(samples);
}

void
reportSensor(const Arguments& arguments, const SceneOptions& options, Report& report)
{
  if (isSampled(arguments))
    report.setNumber(
        "parameters",
        "sampling",
        arguments.number("sampling", spacing_range).value_or(usual_spacing));
  else {
    report.setCount("parameters", "width", options.width);
    report.setCount("parameters", "height", options.height);
    report.setNumber("parameters", "turn", options.turn);
  }
  if (isDepthCamera(arguments)) {
    const pcl::scene::Waviness waviness = pcl::scene::wavinessOf(options);
    report.setText("parameters", "sensor", arguments.text("sensor"));
    report.setNumber("parameters", "waviness", waviness.sigma);
    report.setNumber("parameters", "wave_length", waviness.length);
    return;
  }
  const char* usual = isSampled(arguments) ? "none" : "kinect";
  report.setText("parameters", "noise", arguments.text("noise", usual));
}

SceneOptions
tableOptions(const Arguments& arguments)
{
  SceneOptions options;
  options.seed = seedOf(arguments);
  const auto small = [&](const char* name, std::uint64_t min, std::uint64_t max) {
    const auto value = arguments.integer(name, min, max);
    return value ? std::optional<unsigned>(static_cast<unsigned>(*value))
                 : std::nullopt;
  };
  options.objects = small("objects", 0, max_objects).value_or(options.objects);
  options.shapes = shapesOf(arguments);
  if (sceneKind(arguments) == SceneKind::Part) {
    constexpr unsigned usual_parts = 3; // larger than the usual objects
    options.shapes = {pcl::scene::Shape::Part};
    options.objects = small("objects", 0, max_objects).value_or(usual_parts);
  }
  options.in_bin = arguments.text("place") == "bin";
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
    return isSampled(arguments) ? sampledScene(arguments, options)
                                : pcl::scene::generateScene(options);
  });
  CloudFile cloud = sceneCloud(scene, arguments);
  reportScene(scene, cloud, report);
  report.setCount("parameters", "seed", options.seed);
  report.setCount("parameters", "objects", options.objects);
  const bool has_parts = sceneKind(arguments) == SceneKind::Part;
  if (options.in_bin)
    report.setText("parameters", "place", "bin");
  report.setText(
      "parameters", "shapes", has_parts ? "part" : arguments.text("shapes", "all"));
  reportSensor(arguments, options, report);
  report.setFlag("parameters", "organized", arguments.has("organized"));
  return cloud;
}

} // namespace

SceneMaker
tableScene(const Arguments& arguments)
{
  return [&arguments, options = tableOptions(arguments)](Report& report) {
    return tableCloud(arguments, options, report);
  };
}

} // namespace pcl::app
