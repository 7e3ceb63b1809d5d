// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Random lines through a scene, and the points where they meet its surfaces.

#include "scene/sensors/surface_samples.h"

#include "scene/creases.h"
#include "scene/labels.h"
#include "scene/random.h"
#include "scene/worlds/random_world.h"

#include <cmath>

namespace pcl::scene {
namespace {

constexpr std::uint64_t sampling_stream = 3;
constexpr double edge_spacings = 2.0;
constexpr double crease_spacings = 4.0;
constexpr double contact = 1e-7; // meters between surfaces that touch

class Sampler {
public:
  Sampler(const World& world, const SampleOptions& options)
  : world_(world)
  , options_(options)
  , random_(options.seed, sampling_stream)
  , creases_(world, Observer{})
  , thin_places_(world)
  {}

  /** Random lines of the same density everywhere and in every direction meet each piece
   * of surface equally often, a quarter of their number per area from each side
   * (Cauchy and Crofton). */
  Scene
  run()
  {
    constexpr double pi = 3.14159265358979323846;
    constexpr double reach = 0.6; // meters around the table's center: all of the scene
    const double disc = pi * reach * reach;
    const auto lines =
        static_cast<std::uint64_t>(4.0 * disc / (options_.spacing * options_.spacing));
    for (std::uint64_t i = 0; i < lines; ++i)
      shoot(randomLine(reach));
    scene_.width = static_cast<unsigned>(scene_.surface.size());
    scene_.height = 1;
    return std::move(scene_);
  }

private:
  Ray
  randomLine(double reach)
  {
    const Vec3 direction = random_.direction();
    const auto [right, up] = perpendiculars(direction);
    const double radius = reach * std::sqrt(random_.uniform());
    const UnitVector turn = fromTurns(random_.uniform());
    const Vec3 middle = world_.table.center + right * (radius * turn.cosine) +
                        up * (radius * turn.sine);
    return {middle - direction * (3.0 * reach), direction};
  }

  void
  shoot(const Ray& line)
  {
    if (line.direction.z < 0.0) {
      const double t = line.origin.z / line.direction.z;
      Vec3 point = line.origin - line.direction * t;
      point.z = 0.0;
      if (world_.table.contains(point))
        store({table_index, 0, -t, point, {0.0, 0.0, 1.0}});
    }
    for (std::size_t i = 0; i < world_.solids.size(); ++i) {
      const Hit hit = intersect(world_.solids[i], line);
      if (hit.found() && hit.point.z > contact)
        store({static_cast<int>(i) + 1, hit.face, hit.t, hit.point, hit.normal});
    }
  }

  bool
  touchesAnother(const Sight& sight) const
  {
    for (std::size_t i = 0; i < world_.solids.size(); ++i)
      if (static_cast<int>(i) + 1 != sight.object &&
          !facesAt(world_.solids[i], sight.point, contact).empty())
        return true;
    return false;
  }

  void
  store(const Sight& sight)
  {
    if (touchesAnother(sight))
      return;
    const double distance = creases_.distance(sight.point, crease_cap);
    const bool is_thin =
        thin_places_.areNear(sight, crease_spacings * options_.spacing);
    for (const double value : {sight.point.x, sight.point.y, sight.point.z})
      scene_.xyz.push_back(
          static_cast<float>(value + options_.sigma * random_.normal()));
    append(sight.normal, scene_.normals);
    scene_.instance.push_back(static_cast<std::uint32_t>(sight.object));
    scene_.face.push_back(static_cast<std::uint32_t>(sight.face));
    scene_.crease_mm.push_back(static_cast<float>(1000.0 * distance));
    scene_.edge.push_back(distance < edge_spacings * options_.spacing ? EdgeCrease
                          : is_thin                                   ? EdgeVoid
                                                                      : EdgeNot);
    scene_.surface.push_back(distance < crease_spacings * options_.spacing
                                 ? SurfaceCrease
                             : is_thin                 ? SurfaceVoid
                             : isCurved(world_, sight) ? SurfaceCurved
                                                       : SurfacePlanar);
  }

  const World& world_;
  const SampleOptions& options_;
  Random random_;
  Creases creases_;
  ThinPlaces thin_places_;
  Scene scene_;
};

} // namespace

Scene
sampleScene(const SampleOptions& options)
{
  requireRange("objects", options.objects, 0.0, 30.0, "");
  requireRange("spacing", options.spacing, 0.0005, 0.02, " m");
  requireRange("sigma", options.sigma, 0.0, 0.1, " m");
  SceneOptions scene;
  scene.seed = options.seed;
  scene.objects = options.objects;
  scene.shapes = options.shapes;
  World world = randomWorld(scene).world;
  // Where objects stand: the rest of the table is a plane and nothing else.
  world.table.half_length *= 0.5;
  world.table.half_width *= 0.6;
  return Sampler(world, options).run();
}

} // namespace pcl::scene
