// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Scenes of tables, parts and rooms, from their options to a cloud with its truth.

#include "scene/scene_cloud.h"

#include "cli/errors.h"
#include "cli/filter_app.h"
#include "scene/depth_cameras.h"
#include "scene/place.h"
#include "scene/scene_kind.h"
#include "scene/surface_samples.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <sstream>
#include <string>

namespace pcl::app {
namespace {

using pcl::scene::Scene;

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

/** So many channels of each of some pixels. */
template <typename T>
std::vector<T>
gather(const std::vector<T>& image,
       const std::vector<std::size_t>& pixels,
       std::size_t channels = 1)
{
  std::vector<T> values;
  values.reserve(channels * pixels.size());
  for (const std::size_t pixel : pixels)
    for (std::size_t c = 0; c < channels; ++c)
      values.push_back(image[channels * pixel + c]);
  return values;
}

} // namespace

CloudFile
cloudOf(const std::string& name,
        const std::vector<float>& xyz,
        const std::vector<float>& normals,
        const Arguments& arguments)
{
  CloudFile cloud;
  cloud.path = name;
  cloud.blob.width = static_cast<std::uint32_t>(xyz.size() / 3);
  cloud.blob.height = 1;
  const auto setVectors = [&](const std::string& prefix,
                              const std::vector<float>& vectors) {
    for (std::size_t c = 0; c < 3; ++c) {
      std::vector<float> channel;
      channel.reserve(vectors.size() / 3);
      for (std::size_t i = c; i < vectors.size(); i += 3)
        channel.push_back(vectors[i]);
      setField(cloud, prefix + "xyz"[c], channel);
    }
  };
  setVectors("", xyz);
  if (arguments.has("normals"))
    setVectors("normal_", normals);
  return cloud;
}

CloudFile
sceneCloud(const Scene& scene, const Arguments& arguments)
{
  const bool organized = arguments.has("organized");
  const std::vector<std::size_t> pixels = pixelsOf(scene, organized);
  CloudFile cloud = cloudOf("the generated scene",
                            gather(scene.xyz, pixels, 3),
                            gather(scene.normals, pixels, 3),
                            arguments);
  if (organized) {
    cloud.blob.width = scene.width;
    cloud.blob.height = scene.height;
  }
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

} // namespace

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
  report.setText(
      "parameters", "shapes", has_parts ? "part" : arguments.text("shapes", "all"));
  reportSensor(arguments, options, report);
  report.setFlag("parameters", "organized", arguments.has("organized"));
  return cloud;
}

namespace {

using pcl::scene::PartOptions;

constexpr NumberRange size_range{0.01, 1.0, false, "a number of meters from 0.01 to 1"};

} // namespace

PartOptions
partOptions(const Arguments& arguments)
{
  PartOptions options;
  options.seed = seedOf(arguments);
  options.size = arguments.number("size", size_range).value_or(options.size);
  const double min = 0.001 * options.size, max = 0.1 * options.size;
  const NumberRange spacing_range{
      min, max, false, "a number of meters from 1/1000 to 1/10 of the part's size"};
  options.spacing =
      arguments.number("sampling", spacing_range).value_or(0.01 * options.size);
  options.spread = arguments.choice("spread", {"even", "random"}) == "even"
                       ? pcl::scene::Spread::Even
                       : pcl::scene::Spread::Random;
  options.sigma = noiseSigma(arguments, "none").value_or(options.sigma);
  return options;
}

CloudFile
partCloud(const Arguments& arguments, const PartOptions& options, Report& report)
{
  const bool is_matched = arguments.text("sensor") == "photogrammetry";
  const pcl::scene::PartSamples samples = report.time("generate", [&] {
    return is_matched ? pcl::scene::reconstructPart(options)
                      : pcl::scene::samplePart(options);
  });
  CloudFile cloud = sceneCloud(samples.scene, arguments);
  setField(cloud, "crease_s", samples.crease_s);
  setField(cloud, "radius_s", samples.radius_s);
  setField(cloud, "thin_s", samples.thin_s);
  reportScene(samples.scene, cloud, report);
  report.setCount("parameters", "seed", options.seed);
  report.setText("parameters", "place", "part");
  report.setNumber("parameters", "size", options.size);
  report.setNumber("parameters", "sampling", options.spacing);
  report.setText("parameters", "sensor", is_matched ? "photogrammetry" : "samples");
  if (is_matched)
    return cloud;
  report.setText("parameters", "spread", arguments.text("spread", "even"));
  report.setNumber("parameters", "noise", options.sigma);
  return cloud;
}

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

} // namespace

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

} // namespace pcl::app
