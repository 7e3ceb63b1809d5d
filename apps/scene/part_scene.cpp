// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Machined parts: their options, the cloud and the report.

#include "scene/scene_cloud.h"
#include "scene/scene_kind.h"
#include "scene/scene_maker.h"
#include "scene/sensors/part_samples.h"
#include "scene/sensors/photogrammetry.h"

namespace pcl::app {
namespace {

using pcl::scene::PartOptions;

constexpr NumberRange size_range{0.01, 1.0, false, "a number of meters from 0.01 to 1"};

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

} // namespace

SceneMaker
partScene(const Arguments& arguments)
{
  return [&arguments, options = partOptions(arguments)](Report& report) {
    return partCloud(arguments, options, report);
  };
}

} // namespace pcl::app
