// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Rays of stations in a room or before a house, and the truth about the points where
// they end.

#include "scene/sensors/station_scan.h"

#include "scene/creases.h"
#include "scene/labels.h"
#include "scene/worlds/place.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace pcl::scene {
namespace {

constexpr std::uint64_t range_stream = 31;
constexpr double lowest = -60.0, highest = 90.0; // degrees: the tripod is below
constexpr double degree = 0.01745329251994329577;
constexpr double edge_rays = 1.5, crease_rays = 3.0, outline_rays = 3.0;
constexpr double room_cap = 0.5;     // meters; crease_mm is never larger
constexpr double crease_step = 0.01; // meters at which visibility is looked up

/** \brief One station's picture: columns turn around, rows go down. */
struct Panorama {
  unsigned width = 0, height = 0;

  explicit Panorama(double step)
  : width(static_cast<unsigned>(360.0 / step))
  , height(static_cast<unsigned>((highest - lowest) / step))
  {}

  Vec3
  direction(std::size_t pixel) const
  {
    const auto column = static_cast<double>(pixel % width);
    const auto row = static_cast<double>(pixel / width);
    const UnitVector turn = fromTurns(-(column + 0.5) / width);
    const double degrees = highest - (row + 0.5) * (highest - lowest) / height;
    const UnitVector up = fromTurns(degrees / 360.0);
    return {up.cosine * turn.cosine, up.cosine * turn.sine, up.sine};
  }
};

/** Objects are numbered from 1 in the order of the solids behind the shell's. */
std::uint32_t
instanceOf(const Place& place, const Sight& sight)
{
  const auto solid = static_cast<std::size_t>(sight.object - 1);
  return solid < place.shell ? 0 : static_cast<std::uint32_t>(solid - place.shell + 1);
}

class Scanner {
public:
  Scanner(const Place& place, const StationOptions& options)
  : place_(place)
  , options_(options)
  , panorama_(options.step)
  , random_(options.seed, range_stream)
  , caster_(place.world)
  , creases_(place.world, observersOf(place, options), crease_step)
  {}

  Scene
  run()
  {
    for (unsigned i = 0; i < options_.stations; ++i)
      scan(place_.stations[i]);
    scene_.width = static_cast<unsigned>(scene_.surface.size());
    scene_.height = 1;
    return std::move(scene_);
  }

private:
  static std::vector<Observer>
  observersOf(const Place& place, const StationOptions& options)
  {
    std::vector<Observer> observers;
    for (unsigned i = 0; i < options.stations; ++i)
      observers.push_back({{place.stations[i]}});
    return observers;
  }

  void
  scan(const Vec3& station)
  {
    View view{panorama_.width, panorama_.height, {}};
    const std::size_t rays = std::size_t{view.width} * view.height;
    for (std::size_t i = 0; i < rays; ++i)
      view.sights.push_back(caster_.cast({station, panorama_.direction(i)}));
    // To a panorama a camera is a place and an angle between rays.
    World seen = place_.world;
    seen.camera.focal = 1.0 / (options_.step * degree);
    seen.camera.pose.origin = station;
    const auto outline =
        dilated(silhouettes(seen, view), view.width, view.height, outline_rays);
    for (std::size_t i = 0; i < rays; ++i)
      if (view.sights[i].object != nothing)
        store(station, panorama_.direction(i), view.sights[i], outline[i] != 0);
  }

  void
  store(const Vec3& station, const Vec3& direction, const Sight& sight, bool beside)
  {
    const double range = sight.depth + options_.sigma * random_.normal();
    append(station + direction * range - place_.stations.front(), scene_.xyz);
    append(sight.normal, scene_.normals);
    scene_.instance.push_back(instanceOf(place_, sight));
    scene_.face.push_back(static_cast<std::uint32_t>(sight.face));
    const double distance = creases_.distance(sight.point, room_cap);
    scene_.crease_mm.push_back(static_cast<float>(1000.0 * distance));
    // At grazing angles capped, as a pixel's footprint is
    const double cosine = std::max(0.3, -dot(direction, sight.normal));
    const double spacing = sight.depth * options_.step * degree / std::sqrt(cosine);
    const double edge = std::min(room_cap, std::max(edge_band, edge_rays * spacing));
    const double crease =
        std::min(room_cap, std::max(crease_band, crease_rays * spacing));
    scene_.edge.push_back(distance < edge               ? EdgeCrease
                          : distance < crease || beside ? EdgeVoid
                                                        : EdgeNot);
    scene_.surface.push_back(distance < crease               ? SurfaceCrease
                             : beside                        ? SurfaceVoid
                             : isCurved(place_.world, sight) ? SurfaceCurved
                                                             : SurfacePlanar);
  }

  const Place& place_;
  const StationOptions& options_;
  Panorama panorama_;
  Random random_;
  RayCaster caster_;
  Creases creases_;
  Scene scene_;
};

} // namespace

Scene
scanPlace(const StationOptions& options)
{
  requireRange("step", options.step, 0.05, 2.0, " degrees");
  requireRange("sigma", options.sigma, 0.0, 0.1, " m");
  const Place place =
      options.is_outdoors ? randomFacade(options.seed) : randomRoom(options.seed);
  const std::string in_room = " in the room of seed " + std::to_string(options.seed);
  requireRange("stations",
               options.stations,
               1.0,
               static_cast<double>(place.stations.size()),
               place.stations.size() < max_stations ? in_room.c_str() : "");
  return Scanner(place, options).run();
}

} // namespace pcl::scene
