// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "scene/table_options.h"

#include "cli/errors.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <sstream>
#include <vector>

namespace pcl::app {
namespace {

using pcl::scene::SceneOptions;

constexpr std::uint64_t most_objects = 30;
constexpr std::uint64_t least_pixels = 16;
constexpr std::uint64_t most_pixels = 4096;
constexpr double most_noise = 0.1;
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
    if (!sigma || *sigma < 0.0 || *sigma > most_noise)
      throw UsageError(
          "-noise '" + noise +
          "': allowed is kinect, none, or a number of metres from 0 to 0.1");
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
      throw UsageError("-shapes '" + arguments.text("shapes") +
                       "': allowed are box, cylinder, sphere, bowl and cone, with "
                       "commas between them");
    shapes.push_back(*found);
  }
  if (arguments.has("shapes") && shapes.empty())
    throw UsageError("-shapes '': allowed are box, cylinder, sphere, bowl and cone");
  return shapes;
}

} // namespace

SceneOptions
tableOptions(const Arguments& arguments)
{
  SceneOptions options;
  options.seed = arguments.integer("seed", 0, std::numeric_limits<std::uint64_t>::max())
                     .value_or(options.seed);
  const auto small = [&](const char* name, std::uint64_t least, std::uint64_t most) {
    const auto value = arguments.integer(name, least, most);
    return value ? std::optional<unsigned>(static_cast<unsigned>(*value))
                 : std::nullopt;
  };
  options.objects = small("objects", 0, most_objects).value_or(options.objects);
  options.shapes = shapesOf(arguments);
  options.width = small("width", least_pixels, most_pixels).value_or(options.width);
  options.height = small("height", least_pixels, most_pixels).value_or(options.height);
  options.turn = arguments.number("turn", turn_range).value_or(options.turn);
  setNoise(arguments, options);
  return options;
}

} // namespace pcl::app
