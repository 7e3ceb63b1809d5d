// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Groups of a target, something on it and something before it.

#include "scene/grasp_scene.h"

#include "scene/sensors/depth_cameras.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace pcl::scene {
namespace {

constexpr std::uint64_t placing_stream = 11;
constexpr std::uint64_t noise_stream = 12;
constexpr double min_cosine = 0.15; // a depth camera measures nothing flatter

/** Mostly boxes and cylinders, which others can stand on; half of the boxes flat. */
Body
randomTarget(Random& random)
{
  constexpr Shape kinds[] = {
      Shape::Box, Shape::Box, Shape::Cylinder, Shape::Cylinder, Shape::Sphere};
  const unsigned kind = random.below(7);
  const double scale = random.uniform(0.9, 1.3);
  Body body =
      randomBody(kinds[kind < 5 ? kind : 0], scale, randomHeading(random), random);
  if (kind == 0 || kind > 4) {
    const double height = random.uniform(0.02, 0.05);
    body.solid.size[2] = body.high = body.widest_high = height;
    body.solid.pose.origin.z = 0.5 * height;
  }
  return body;
}

/** A smaller box or upright cylinder around the middle of the top. */
std::optional<Body>
randomRider(const Body& carrier, Random& random)
{
  if (!carrier.carries)
    return std::nullopt;
  const Shape kind = random.chance(0.5) ? Shape::Box : Shape::Cylinder;
  const Body rider =
      randomBody(kind, random.uniform(0.45, 0.75), randomHeading(random), random);
  const bool is_round = carrier.solid.shape == Shape::Cylinder;
  const double length = is_round ? 2.0 * carrier.solid.size[0] : carrier.solid.size[0];
  const double width = is_round ? length : carrier.solid.size[1];
  const auto& axes = carrier.solid.pose.axes;
  const Vec3 offset = axes[0] * (0.2 * length * random.uniform(-1.0, 1.0)) +
                      axes[1] * (0.2 * width * random.uniform(-1.0, 1.0));
  return moved(rider, carrier.topCenter() + offset);
}

/** A smaller object between the camera and the target, apart from it. */
Body
randomOccluder(const Body& target, Random& random)
{
  const Shape kind = random.chance(0.5) ? Shape::Box : Shape::Cylinder;
  Body body = randomBody(kind, random.uniform(0.5, 0.9), randomHeading(random), random);
  const double sideways = random.uniform(-0.04, 0.04);
  body = moved(body, target.center + Vec3{sideways, 0.0, 0.0});
  const Vec3 to_camera{0.0, -1.0, 0.0};
  const double by = slideToContact(body.footprint, to_camera, target.footprint) +
                    random.uniform(0.005, 0.03);
  return moved(body, to_camera * by);
}

/** Visit points of a disc on a surface, in rings, the last of which is its rim. */
template <typename Visit>
bool
allOfDisc(const Vec3& center, const Vec3& normal, double radius, const Visit& visit)
{
  constexpr int rings = 4, sectors = 24;
  const auto [u, v] = perpendiculars(normal);
  for (int ring = 0; ring <= rings; ++ring)
    for (int s = 0; s < (ring == 0 ? 1 : sectors); ++s) {
      const UnitVector turn = fromTurns((s + 0.5 * (ring % 2)) / sectors);
      const double r = radius * ring / rings;
      if (!visit(center + u * (r * turn.cosine) + v * (r * turn.sine)))
        return false;
    }
  return true;
}

/** Where a line along an approach meets a solid, whatever else is there. */
Hit
meet(const Solid& solid, const Vec3& place, const Vec3& approach)
{
  constexpr double outside = 1.0; // meters; no object is as large
  return intersect(solid, {place - approach * outside, approach});
}

/** True if no other object touches the point, or is above it. */
bool
isFree(const World& world,
       std::size_t object,
       const Vec3& point,
       const Vec3& outward,
       double free_way)
{
  constexpr double contact = 1e-6;
  for (std::size_t i = 0; i < world.solids.size(); ++i) {
    const Solid& other = world.solids[i];
    if (i + 1 != object &&
        (!facesAt(other, point, contact).empty() ||
         intersect(other, {point + outward * contact, outward}).t < free_way))
      return false;
  }
  return true;
}

/** Points and what they lie on, of the pixels that have depth. */
void
storePoints(const View& view, const std::vector<double>& depth, GraspScene& scene)
{
  const Camera& camera = scene.world.camera;
  for (std::size_t i = 0; i < depth.size(); ++i) {
    if (std::isnan(depth[i]) || view.sights[i].object == nothing)
      continue;
    append(camera.direction(i) * depth[i], scene.xyz);
    scene.object.push_back(view.sights[i].object);
    scene.face.push_back(view.sights[i].face);
  }
}

} // namespace

GraspScene
graspScene(const SceneOptions& options)
{
  SceneOptions empty = options;
  empty.objects = 0;
  GraspScene scene;
  scene.world = randomWorld(empty).world;
  Random placing(options.seed, placing_stream);
  auto& solids = scene.world.solids;
  for (const double x : {-0.17, 0.17}) {
    const Body target =
        moved(randomTarget(placing), {x, placing.uniform(0.62, 0.74), 0.0});
    const std::optional<Body> rider = randomRider(target, placing);
    solids.push_back(target.solid);
    scene.targets.push_back(solids.size());
    if (rider)
      solids.push_back(rider->solid);
    solids.push_back(randomOccluder(target, placing).solid);
  }

  DepthImage image{look(scene.world), {}};
  scene.observer = {{scene.world.camera.pose.origin}, min_cosine};
  if (options.noise == Noise::Kinect) {
    Random noise(options.seed, noise_stream);
    scene.observer = depthObserver(options.noise, scene.world);
    image = depthImage(scene.world, image.view, options.noise, {}, noise);
  }
  else
    for (const Sight& sight : image.view.sights)
      image.depth.push_back(sight.depth);
  storePoints(image.view, image.depth, scene);
  return scene;
}

bool
isOnOneFace(const World& world,
            std::size_t object,
            const Vec3& position,
            const Vec3& approach,
            double radius,
            double free_way)
{
  const Solid& solid = world.solids[object - 1];
  const int face = meet(solid, position, approach).face;
  return face >= 0 && allOfDisc(position, approach, radius, [&](const Vec3& place) {
           const Hit at = meet(solid, place, approach);
           return at.face == face &&
                  isFree(world, object, at.point, -approach, free_way);
         });
}

bool
showsDisc(const GraspScene& scene, std::size_t object, double radius, double step)
{
  const RayCaster caster(scene.world);
  const Solid& solid = scene.world.solids[object - 1];
  const View view = look(scene.world);
  std::vector<Vec3> tried;
  return std::any_of(view.sights.begin(), view.sights.end(), [&](const Sight& sight) {
    const auto is_near = [&](const Vec3& p) { return norm(p - sight.point) < step; };
    if (sight.object != static_cast<int>(object) ||
        std::any_of(tried.begin(), tried.end(), is_near))
      return false;
    tried.push_back(sight.point);
    return allOfDisc(sight.point, sight.normal, radius, [&](const Vec3& place) {
      const Hit at = meet(solid, place, -sight.normal);
      return at.face == sight.face && caster.seen(scene.observer, at.point, at.normal);
    });
  });
}

} // namespace pcl::scene
