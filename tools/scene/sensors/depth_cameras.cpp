// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What a Kinect and stereo, time-of-flight and structured-light cameras measure of a
// scene.

#include "scene/sensors/depth_cameras.h"

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
constexpr double min_cosine = 0.15; // less than that, give or take, is not measured

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
  return depthsOf(view, [&](std::size_t i, const Sight& sight) {
    const double noise = short_noise * fine[i] + long_noise / sight.depth * coarse[i];
    const double exact_steps = steps_per_pixel * focal_baseline / sight.depth;
    const double steps = std::floor(exact_steps + noise + 0.5);
    const double millimeters = 1000.0 * steps_per_pixel * focal_baseline / steps;
    return std::floor(millimeters + 0.5) / 1000.0;
  });
}

/** In the shadows of detector and projector, at outlines and at grazing angles. */
void
loseDepth(const World& world,
          const View& view,
          Random& random,
          std::vector<double>& depth)
{
  const RayCaster caster(world);
  Observer everything = depthObserver(Noise::Kinect, world);
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
    const bool grazing = dot(to_eye, sight.normal) < min_cosine + 0.04 * ragged[i];
    if (!measured[i] || frayed || grazing)
      depth[i] = std::numeric_limits<double>::quiet_NaN();
  }
}

DepthImage
kinectImage(const World& world, const View& exact, Random& random)
{
  DepthImage image{raggedView(world, exact, random), {}};
  image.depth = noisyDepth(image.view, random);
  loseDepth(world, image.view, random, image.depth);
  return image;
}

constexpr std::uint64_t waviness_stream = 23;
constexpr double stereo_baseline = 0.05;
constexpr double stereo_window = 7.0;       // pixels of a picture 640 wide
constexpr double disparity_noise = 0.05;    // pixels of a picture 640 wide
constexpr double disparity_steps = 32.0;    // a pixel
constexpr double tof_noise = 0.0015;        // meters at 1 m
constexpr double flying_reach = 1.5;        // pixels beside an outline
constexpr double structured_noise = 0.0001; // meters at structured_depth
constexpr double structured_depth = 0.6;
constexpr double ripple = 0.0001;       // meters
constexpr double fringe = 32.0;         // pixels of a picture 640 wide
constexpr double projector_aside = 0.1; // meters

/** How many pixels are one of a picture 640 wide. */
double
scaleOf(const View& view)
{
  return std::max(1.0, view.width / 640.0);
}

double
middleDepth(const View& view)
{
  std::vector<double> depths;
  for (const Sight& sight : view.sights)
    if (sight.object != nothing)
      depths.push_back(sight.depth);
  if (depths.empty())
    return 1.0;
  const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
  std::nth_element(depths.begin(), middle, depths.end());
  return *middle;
}

Field
wavinessField(const World& world,
              const View& view,
              const Waviness& waviness,
              Random& random)
{
  const double cell = waviness.length * world.camera.focal / middleDepth(view);
  Field field = gridField(view.width, view.height, std::max(1.0, cell), random);
  for (double& value : field)
    value *= waviness.sigma;
  return field;
}

/** A window of the matching that sees something nearer takes its depth. */
View
fattened(const World& world, const View& exact, Random& random)
{
  const double half = 0.5 * (stereo_window - 1.0) * scaleOf(exact);
  const auto outline =
      dilated(silhouettes(world, exact), exact.width, exact.height, half);
  const Field ragged = gridField(exact.width, exact.height, outline_cell, random);
  View view = exact;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    if (!outline[i])
      continue;
    // From none to half a window, usually most of it
    const int reach = static_cast<int>(
        std::clamp(0.7 * half + 0.4 * half * ragged[i], 0.0, half) + 0.5);
    forEachAround(i, exact.width, exact.height, reach, [&](std::size_t at, int) {
      const Sight& other = exact.sights[at];
      // Nearer by more than a slope: an object in front
      constexpr double gap = 0.01;
      if (other.object != nothing && (view.sights[i].object == nothing ||
                                      other.depth < view.sights[i].depth - gap))
        view.sights[i] = other;
    });
  }
  return view;
}

std::vector<double>
stereoDepth(const World& world,
            const View& view,
            const Waviness& waviness,
            Random& random)
{
  const double scale = scaleOf(view);
  const auto window = static_cast<std::size_t>(stereo_window * scale + 0.5);
  const Field matching = boxField(view.width, view.height, window, window, random);
  const Field waves = wavinessField(world, view, waviness, random);
  const double focal_baseline = world.camera.focal * stereo_baseline;
  const double step = scale / disparity_steps;
  return depthsOf(view, [&](std::size_t i, const Sight& sight) {
    const double disparity = focal_baseline / (sight.depth + waves[i]) +
                             disparity_noise * scale * matching[i];
    const double stepped = step * std::floor(disparity / step + 0.5);
    const double millimeters = 1000.0 * focal_baseline / stepped;
    return std::floor(millimeters + 0.5) / 1000.0;
  });
}

/** The farthest that a pixel's neighbors see, within a few pixels. */
double
farthestBeside(const View& view, std::size_t pixel, int reach)
{
  double farthest = 0.0;
  forEachAround(pixel, view.width, view.height, reach, [&](std::size_t at, int) {
    if (view.sights[at].object != nothing)
      farthest = std::max(farthest, view.sights[at].depth);
  });
  return farthest;
}

std::vector<double>
tofDepth(const World& world, const View& view, const Waviness& waviness, Random& random)
{
  const Field waves = wavinessField(world, view, waviness, random);
  const auto outline =
      dilated(silhouettes(world, view), view.width, view.height, flying_reach);
  return depthsOf(view, [&](std::size_t i, const Sight& sight) {
    const double noise = tof_noise * sight.depth * sight.depth * random.normal();
    const double mixed = random.uniform();
    double z = sight.depth + waves[i] + noise;
    if (outline[i] && sight.object != nothing) {
      const double behind = farthestBeside(view, i, 2) - sight.depth;
      z += behind * mixed * mixed; // more light returns from what is near
    }
    return std::floor(1000.0 * z + 0.5) / 1000.0;
  });
}

std::vector<double>
structuredDepth(const World& world,
                const View& view,
                const Waviness& waviness,
                Random& random)
{
  const Field waves = wavinessField(world, view, waviness, random);
  const double period = 0.25 * fringe * scaleOf(view);
  const double phase = random.uniform();
  return depthsOf(view, [&](std::size_t i, const Sight& sight) {
    const auto column = static_cast<double>(i % view.width);
    const double relative = sight.depth / structured_depth;
    const double noise = structured_noise * relative * relative * random.normal();
    const double error = ripple * fromTurns(column / period + phase).sine;
    return sight.depth + waves[i] + noise + error;
  });
}

/** In shadows and at grazing angles; with structured light also at outlines. */
void
loseDepth(const World& world, Noise camera, DepthImage& image)
{
  const View& view = image.view;
  const RayCaster caster(world);
  const Observer observer = depthObserver(camera, world);
  auto outline = silhouettes(world, view);
  if (camera == Noise::Stereo) // half a window past it there is a depth
    outline = dilated(outline, view.width, view.height, 3.0 * scaleOf(view));
  for (std::size_t i = 0; i < view.sights.size(); ++i) {
    const Sight& sight = view.sights[i];
    if (sight.object == nothing)
      continue;
    const bool is_seen = caster.seen(observer, sight.point, sight.normal) ||
                         (camera == Noise::Stereo && outline[i]);
    const bool is_lost = camera == Noise::Structured && outline[i];
    if (!is_seen || is_lost)
      image.depth[i] = std::numeric_limits<double>::quiet_NaN();
  }
}

} // namespace

Waviness
wavinessOf(const SceneOptions& options)
{
  if (options.waviness)
    return *options.waviness;
  if (options.noise == Noise::Structured)
    return {};
  Random random(options.seed, waviness_stream);
  const double sigma = random.uniform(0.0005, 0.003);
  return {sigma, random.uniform(0.01, 0.06)};
}

Observer
depthObserver(Noise camera, const World& world)
{
  const Pose& pose = world.camera.pose;
  Observer observer{{pose.origin}, min_cosine};
  const auto addEye = [&](double x) {
    observer.eyes.push_back(pose.toWorld({x, 0.0, 0.0}));
  };
  if (camera == Noise::Kinect) {
    addEye(projector_x);
    addEye(detector_x);
  }
  if (camera == Noise::Stereo)
    addEye(stereo_baseline);
  if (camera == Noise::Structured)
    addEye(projector_aside);
  return observer;
}

DepthImage
depthImage(const World& world,
           const View& exact,
           Noise camera,
           const Waviness& waviness,
           Random& random)
{
  if (camera == Noise::Kinect)
    return kinectImage(world, exact, random);
  DepthImage image;
  image.view = camera == Noise::Stereo ? fattened(world, exact, random) : exact;
  image.depth = camera == Noise::Stereo
                    ? stereoDepth(world, image.view, waviness, random)
                : camera == Noise::TimeOfFlight
                    ? tofDepth(world, image.view, waviness, random)
                    : structuredDepth(world, image.view, waviness, random);
  loseDepth(world, camera, image);
  return image;
}

} // namespace pcl::scene
