// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Noise, ragged outlines and missing depth, as a Kinect makes them.

#include "scene/kinect_sensor.h"

#include "scene/labels.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::scene {

Field
boxField(std::size_t width,
         std::size_t height,
         std::size_t box_width,
         std::size_t box_height,
         Random& random)
{
  const std::size_t padded = width + box_width - 1, rows = height + box_height - 1;
  std::vector<double> white(padded * rows);
  for (auto& value : white)
    value = random.normal();

  std::vector<double> summed(width * rows, 0.0);
  for (std::size_t v = 0; v < rows; ++v)
    for (std::size_t u = 0; u < width; ++u)
      for (std::size_t k = 0; k < box_width; ++k)
        summed[v * width + u] += white[v * padded + u + k];

  const double scale = 1.0 / std::sqrt(static_cast<double>(box_width * box_height));
  Field field(width * height, 0.0);
  for (std::size_t i = 0; i < field.size(); ++i) {
    for (std::size_t k = 0; k < box_height; ++k)
      field[i] += summed[i + k * width];
    field[i] *= scale;
  }
  return field;
}

Field
gridField(unsigned width, unsigned height, double cell, Random& random)
{
  const auto columns = static_cast<std::size_t>(width / cell) + 2;
  const auto rows = static_cast<std::size_t>(height / cell) + 2;
  std::vector<double> grid(columns * rows);
  for (auto& value : grid)
    value = random.normal();

  const auto weight = [](double t) { return t * t * (3.0 - 2.0 * t); };
  Field field;
  field.reserve(std::size_t{width} * height);
  for (unsigned v = 0; v < height; ++v)
    for (unsigned u = 0; u < width; ++u) {
      const double x = u / cell, y = v / cell;
      const auto i = static_cast<std::size_t>(x), j = static_cast<std::size_t>(y);
      const double a = weight(x - static_cast<double>(i));
      const double b = weight(y - static_cast<double>(j));
      const double* corner = &grid[j * columns + i];
      const double upper = (1.0 - a) * corner[0] + a * corner[1];
      const double lower = (1.0 - a) * corner[columns] + a * corner[columns + 1];
      const double variance =
          ((1.0 - a) * (1.0 - a) + a * a) * ((1.0 - b) * (1.0 - b) + b * b);
      field.push_back(((1.0 - b) * upper + b * lower) / std::sqrt(variance));
    }
  return field;
}

namespace {

constexpr double focal_baseline =
    43.55;                              // pixel meters: z^2 / (8 * 43.55) = 2.87 mm z^2
constexpr double steps_per_pixel = 8.0; // of disparity
constexpr double short_noise = 0.62;    // steps, over 8 by 4 pixels
constexpr double long_noise = 0.45;     // steps at 1 m, inversely proportional to depth
constexpr double long_noise_cell = 80.0; // pixels
constexpr double outline_cell = 5.0;     // pixels between bumps of a ragged outline
constexpr double projector_x = 0.045;    // meters to the right of the view point
constexpr double detector_x = -0.022;    // likewise: depth is seen from between the two
constexpr double grazing_cosine = 0.15; // less than that, give or take, is not measured

View
raggedView(const World& world, const View& exact, Random& random)
{
  constexpr double displacement = 0.9; // pixels, standard deviation
  View view = exact;
  const Field across = gridField(exact.width, exact.height, outline_cell, random);
  const Field down = gridField(exact.width, exact.height, outline_cell, random);
  const auto near_silhouette =
      dilated(silhouettes(world, exact), exact.width, exact.height, 2.5);
  const auto moved = [](unsigned from, double by, unsigned count) {
    const double to = std::floor(from + displacement * by + 0.5);
    return static_cast<std::size_t>(std::clamp(to, 0.0, count - 1.0));
  };
  for (unsigned v = 0; v < exact.height; ++v)
    for (unsigned u = 0; u < exact.width; ++u) {
      const std::size_t i = std::size_t{v} * exact.width + u;
      if (near_silhouette[i])
        view.sights[i] = exact.sights[moved(v, down[i], exact.height) * exact.width +
                                      moved(u, across[i], exact.width)];
    }
  return view;
}

std::vector<double>
noisyDepth(const View& view, Random& random)
{
  const Field fine = boxField(view.width, view.height, 8, 4, random);
  const Field coarse = gridField(view.width, view.height, long_noise_cell, random);
  std::vector<double> depth(view.sights.size(),
                            std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < depth.size(); ++i) {
    const Sight& sight = view.sights[i];
    if (sight.object == nothing)
      continue;
    const double noise = short_noise * fine[i] + long_noise / sight.depth * coarse[i];
    const double exact_steps = steps_per_pixel * focal_baseline / sight.depth;
    const double steps = std::floor(exact_steps + noise + 0.5);
    const double millimeters = 1000.0 * steps_per_pixel * focal_baseline / steps;
    depth[i] = std::floor(millimeters + 0.5) / 1000.0;
  }
  return depth;
}

/** In the shadows of detector and projector, at outlines and at grazing angles. */
void
loseDepth(const World& world,
          const View& view,
          Random& random,
          std::vector<double>& depth)
{
  const RayCaster caster(world);
  Observer everything = KinectSensor::observer(world);
  everything.min_cosine = 0.0;
  const Field ragged = gridField(view.width, view.height, outline_cell, random);
  const auto outline = dilated(silhouettes(world, view), view.width, view.height, 1.5);
  std::vector<char> measured;
  for (const Sight& sight : view.sights)
    measured.push_back(sight.object != nothing &&
                       caster.seen(everything, sight.point, sight.normal));
  // The correlation window sees a little into the shadows
  measured = dilated(measured, view.width, view.height, 1.0);
  for (std::size_t i = 0; i < depth.size(); ++i) {
    const Sight& sight = view.sights[i];
    if (sight.object == nothing)
      continue;
    const Vec3 to_eye = normalized(world.camera.pose.origin - sight.point);
    const bool frayed = outline[i] && ragged[i] > 1.4;
    const bool grazing = dot(to_eye, sight.normal) < grazing_cosine + 0.04 * ragged[i];
    if (!measured[i] || frayed || grazing)
      depth[i] = std::numeric_limits<double>::quiet_NaN();
  }
}

} // namespace

KinectSensor::KinectSensor(const World& world, const View& exact, Random& random)
: view(raggedView(world, exact, random))
, depth(noisyDepth(view, random))
{
  loseDepth(world, view, random, depth);
}

Observer
KinectSensor::observer(const World& world)
{
  const Pose& pose = world.camera.pose;
  return {{pose.origin,
           pose.toWorld({projector_x, 0.0, 0.0}),
           pose.toWorld({detector_x, 0.0, 0.0})},
          grazing_cosine};
}

} // namespace pcl::scene
