// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "scene/scene.h"

#include "scene/labels.h"
#include "scene/random_world.h"
#include "scene/sensor.h"

#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace pcl::scene {
namespace {

constexpr std::uint64_t noise_stream = 2;
constexpr std::uint64_t noise_stream_of_turned = 4; // 3 is that of surface samples

template <class Value>
void
requireRange(
    const char* parameter, Value value, Value low, Value high, const char* unit)
{
  if (value >= low && value <= high)
    return;
  std::ostringstream message;
  message << parameter << " is " << value << ", allowed is " << low << " to " << high
          << unit;
  throw std::invalid_argument(message.str());
}

void
validate(const SceneOptions& options)
{
  requireRange("objects", options.objects, 0U, 30U, "");
  requireRange("width", options.width, 16U, 4096U, " pixels");
  requireRange("height", options.height, 16U, 4096U, " pixels");
  requireRange("white_sigma", options.white_sigma, 0.0, 0.1, " m");
  requireRange("turn", options.turn, -180.0, 180.0, " degrees");
}

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

Scene
emptyScene(const SceneOptions& options)
{
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  const std::size_t pixels = std::size_t{options.width} * options.height;
  Scene scene;
  scene.width = options.width;
  scene.height = options.height;
  scene.xyz.assign(3 * pixels, nan);
  scene.normals.assign(3 * pixels, nan);
  scene.surface.assign(pixels, SurfaceVoid);
  scene.edge.assign(pixels, EdgeVoid);
  scene.instance.assign(pixels, 0);
  scene.face.assign(pixels, 0);
  scene.crease_mm.assign(pixels, nan);
  return scene;
}

void
store(const Vec3& v, std::size_t pixel, std::vector<float>& values)
{
  values[3 * pixel] = static_cast<float>(v.x);
  values[3 * pixel + 1] = static_cast<float>(v.y);
  values[3 * pixel + 2] = static_cast<float>(v.z);
}

/** Points of the given depths (NaN: none) and the exact normals there. */
void
storeGeometry(const Camera& camera,
              const View& view,
              const std::vector<double>& depth,
              Scene& scene)
{
  for (std::size_t i = 0; i < depth.size(); ++i) {
    if (std::isnan(depth[i]))
      continue;
    const auto u = static_cast<unsigned>(i % camera.width);
    const auto v = static_cast<unsigned>(i / camera.width);
    store(camera.direction(u, v) * depth[i], i, scene.xyz);
    store(camera.pose.directionToLocal(view.sights[i].normal), i, scene.normals);
  }
}

std::vector<double>
exactDepth(const View& view)
{
  std::vector<double> depth;
  depth.reserve(view.sights.size());
  for (const auto& sight : view.sights)
    depth.push_back(sight.object == nothing ? std::numeric_limits<double>::quiet_NaN()
                                            : sight.depth);
  return depth;
}

std::vector<double>
withWhiteNoise(std::vector<double> depth,
               const Camera& camera,
               double sigma,
               Random& random)
{
  for (std::size_t i = 0; i < depth.size(); ++i) {
    const auto u = static_cast<unsigned>(i % camera.width);
    const auto v = static_cast<unsigned>(i / camera.width);
    depth[i] += sigma * random.normal() / norm(camera.direction(u, v));
  }
  return depth;
}

std::vector<char>
silhouettesAndGaps(const World& world,
                   const View& view,
                   const std::vector<double>& depth)
{
  auto marks = silhouettes(world, view);
  for (std::size_t i = 0; i < marks.size(); ++i)
    if (view.sights[i].object != nothing && std::isnan(depth[i]))
      marks[i] = 1;
  return marks;
}

} // namespace

Scene
generateScene(const SceneOptions& options)
{
  validate(options);
  const RandomWorld random_world = randomWorld(options);
  const World& world = random_world.world;
  Random noise(options.seed,
               options.turn == 0.0 ? noise_stream : noise_stream_of_turned);

  View view = look(world);
  std::vector<double> depth = exactDepth(view);
  if (options.noise == Noise::White)
    depth = withWhiteNoise(depth, world.camera, options.white_sigma, noise);
  Observer observer{{world.camera.pose.origin}};
  if (options.noise == Noise::Kinect) {
    observer = KinectSensor::observer(world);
    const KinectSensor sensor(world, view, noise);
    view = sensor.view();
    depth = sensor.depth();
  }

  Scene scene = emptyScene(options);
  scene.objects = describe(random_world.bodies, world.camera);
  scene.camera_origin = toArray(world.camera.pose.origin);
  for (std::size_t i = 0; i < 3; ++i)
    scene.camera_axes[i] = toArray(world.camera.pose.axes[i]);
  storeGeometry(world.camera, view, depth, scene);
  const double band = silhouette_band * options.width / 640.0;
  label(world,
        view,
        Creases(world, observer),
        dilated(silhouettesAndGaps(world, view, depth),
                options.width,
                options.height,
                std::max(1.0, band)),
        scene);
  return scene;
}

} // namespace pcl::scene
