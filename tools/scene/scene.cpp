// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A random scene on a table or in a bin, looked at with a virtual depth camera.

#include "scene/scene.h"

#include "scene/labels.h"
#include "scene/sensors/depth_cameras.h"
#include "scene/worlds/random_world.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace pcl::scene {
namespace {

constexpr std::uint64_t noise_stream = 2;
constexpr std::uint64_t noise_stream_of_turned = 4; // 3 is that of surface samples

std::array<double, 3>
toArray(const Vec3& v)
{
  return {v.x, v.y, v.z};
}

std::vector<SceneObject>
describe(const std::vector<Body>& bodies, const Camera& camera)
{
  std::vector<SceneObject> objects;
  for (const auto& body : bodies) {
    SceneObject object;
    object.shape = body.solid.shape;
    object.instance = static_cast<std::uint32_t>(objects.size() + 1);
    object.size = body.solid.size;
    for (std::size_t i = 0; i < 3; ++i)
      object.axes[i] = toArray(camera.pose.directionToLocal(body.solid.pose.axes[i]));
    object.origin = toArray(camera.pose.toLocal(body.solid.pose.origin));
    object.touches_table = body.low == 0.0;
    for (const std::size_t other : body.touches)
      object.touches.push_back(static_cast<std::uint32_t>(other + 1));
    objects.push_back(object);
  }
  return objects;
}

/** Points of the given depths (NaN: none) and the exact normals there. */
void
storeGeometry(const Camera& camera,
              const View& view,
              const std::vector<double>& depth,
              Scene& scene)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < depth.size(); ++i) {
    const bool has_depth = !std::isnan(depth[i]);
    append(has_depth ? camera.direction(i) * depth[i] : Vec3{nan, nan, nan}, scene.xyz);
    append(has_depth ? camera.pose.directionToLocal(view.sights[i].normal)
                     : Vec3{nan, nan, nan},
           scene.normals);
  }
}

/** Along the rays, with white noise of this sigma. */
std::vector<double>
depthOf(const View& view, const Camera& camera, double sigma, Random& random)
{
  return depthsOf(view, [&](std::size_t i, const Sight& sight) {
    return sight.depth + sigma * random.normal() / norm(camera.direction(i));
  });
}

} // namespace

void
requireRange(
    const char* parameter, double value, double min, double max, const char* unit)
{
  if (value >= min && value <= max)
    return;
  std::ostringstream message;
  message << parameter << " must be " << min << " to " << max << unit << ", not "
          << value;
  throw std::invalid_argument(message.str());
}

Scene
generateScene(const SceneOptions& options)
{
  requireRange("objects", options.objects, 0.0, 30.0, "");
  requireRange("width", options.width, 16.0, 4096.0, " pixels");
  requireRange("height", options.height, 16.0, 4096.0, " pixels");
  requireRange("white_sigma", options.white_sigma, 0.0, 0.1, " m");
  requireRange("turn", options.turn, -180.0, 180.0, " degrees");
  const auto& shapes = options.shapes;
  if (options.in_bin &&
      std::find(shapes.begin(), shapes.end(), Shape::Part) != shapes.end())
    throw std::invalid_argument("shapes must be no parts in a bin, which is too small");
  if (options.waviness) {
    requireRange("waviness.sigma", options.waviness->sigma, 0.0, 0.01, " m");
    requireRange("waviness.length", options.waviness->length, 0.002, 0.2, " m");
  }
  const RandomWorld random_world = randomWorld(options);
  const World& world = random_world.world;
  Random noise(options.seed,
               options.turn == 0.0 ? noise_stream : noise_stream_of_turned);

  DepthImage image{look(world), {}};
  Observer observer{{world.camera.pose.origin}};
  if (options.noise == Noise::None || options.noise == Noise::White) {
    const double sigma = options.noise == Noise::White ? options.white_sigma : 0.0;
    image.depth = depthOf(image.view, world.camera, sigma, noise);
  }
  else {
    observer = depthObserver(options.noise, world);
    image = depthImage(world, image.view, options.noise, wavinessOf(options), noise);
  }
  const auto& [view, depth] = image;

  Scene scene;
  scene.width = options.width;
  scene.height = options.height;
  scene.objects = describe(random_world.bodies, world.camera);
  scene.camera_origin = toArray(world.camera.pose.origin);
  for (std::size_t i = 0; i < 3; ++i)
    scene.camera_axes[i] = toArray(world.camera.pose.axes[i]);
  storeGeometry(world.camera, view, depth, scene);
  std::vector<char> gaps = silhouettes(world, view);
  for (std::size_t i = 0; i < gaps.size(); ++i)
    if (view.sights[i].object != nothing && std::isnan(depth[i]))
      gaps[i] = 1;
  const double band = std::max(1.0, silhouette_band * options.width / 640.0);
  label(world,
        view,
        Creases(world, observer),
        dilated(gaps, options.width, options.height, band),
        scene);
  for (std::uint32_t& instance : scene.instance)
    if (instance > random_world.bodies.size())
      instance = 0;
  return scene;
}

} // namespace pcl::scene
