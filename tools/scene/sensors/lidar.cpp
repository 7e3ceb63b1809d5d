// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A laser scanner in a random street: its rays and what they meet.

#include "scene/sensors/lidar.h"

#include "scene/scene.h"
#include "scene/worlds/world.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace pcl::scene {
namespace {

constexpr std::uint64_t scan_stream = 12, rough_stream = 13;
constexpr double drop_out_rate = 0.01;
constexpr double asphalt_reach = 50.0; // meters
constexpr double min_range = 0.9;      // meters
constexpr double indoor_range = 0.3;   // meters: scanners of robots
constexpr double wet_share = 0.5;      // of the rays at wet ground are mirrored
constexpr double scan_seconds = 0.1;

/** \brief What a ray meets first. */
struct Return {
  double range;
  Vec3 normal;
  std::uint32_t ground, surface, instance;
};

/** \brief Nothing if the ray is lost.
 * \param[in] solids what stands in the street \param[in] ray its direction is unit */
std::optional<Return>
cast(const Street& street,
     const World& solids,
     const RayCaster& caster,
     const Ray& ray,
     double reach,
     double min_range,
     double tuft)
{
  const Sight sight = caster.cast(ray);
  const double range = sight.object == nothing ? reach : sight.depth;
  if (const auto hit = street.ground.cast(ray, std::min(range, reach), tuft)) {
    if (hit->distance > asphalt_reach)
      return std::nullopt;
    const std::uint32_t ground = hit->curb_face ? GroundVoid : GroundTrue;
    return Return{hit->distance, hit->normal, ground, SurfacePlanar, 0};
  }
  if (range >= reach || range < min_range)
    return std::nullopt;
  return Return{range,
                sight.normal,
                GroundNot,
                isCurved(solids, sight) ? SurfaceCurved : SurfacePlanar,
                street.instances[static_cast<std::size_t>(sight.object - 1)]};
}

/** Wet places on the ground. */
struct Puddles {
  std::vector<Vec3> middles; /**< z is the radius */

  Puddles(const Street& street, Random& random)
  {
    for (int i = 0; i < 12; ++i) {
      const Vec3 at = street.ground.toSensor(
          {random.uniform(-25.0, 25.0), random.uniform(-5.0, 5.0)}, 0.0);
      middles.push_back({at.x, at.y, random.uniform(0.4, 1.5)});
    }
  }

  bool
  haveAt(const Vec3& p) const
  {
    return std::any_of(middles.begin(), middles.end(), [&](const Vec3& m) {
      return (p.x - m.x) * (p.x - m.x) + (p.y - m.y) * (p.y - m.y) < m.z * m.z;
    });
  }
};

/** What wet ground shows instead of itself, as far behind it as it is before it. */
std::optional<Return>
mirrored(const RayCaster& caster,
         const Return& ground,
         const Vec3& at,
         const Vec3& from,
         double reach)
{
  const Vec3 direction = normalized(at - from);
  const Vec3 up = ground.normal;
  const Vec3 away = direction - up * (2.0 * dot(direction, up));
  const Sight sight = caster.cast({at + up * 1e-6, away});
  if (sight.object == nothing || ground.range + sight.depth > reach)
    return std::nullopt;
  return Return{ground.range + sight.depth, -direction, GroundNot, SurfacePlanar, 0};
}

struct LidarRay {
  Vec3 direction; /**< unit */
  std::size_t beam;
  double time; /**< of the scan, 0 to 1 */
};

/** Where the scanner has come to, and where it looks. */
struct Scanner {
  Vec3 origin;
  UnitVector yaw{1.0, 0.0};

  /** Of a vector in its own frame. */
  Vec3
  turned(const Vec3& v) const
  {
    return {yaw.cosine * v.x - yaw.sine * v.y, yaw.sine * v.x + yaw.cosine * v.y, v.z};
  }

  Vec3
  turnedBack(const Vec3& v) const
  {
    return {yaw.cosine * v.x + yaw.sine * v.y, yaw.cosine * v.y - yaw.sine * v.x, v.z};
  }
};

/** Along an arc of the road, at the same height above it. */
Scanner
scannerAt(const StreetGround& ground, const LidarOptions& options, double time)
{
  if (options.speed == 0.0 && options.yaw_rate == 0.0)
    return {};
  const double seconds = time * scan_seconds;
  const double turns = options.yaw_rate * seconds / 360.0;
  const UnitVector chord = fromTurns(0.5 * turns); // of the arc, which is short
  const double way = options.speed * seconds;
  const Vec3 at{way * chord.cosine, way * chord.sine, 0.0};
  const double road = ground.height(ground.toStreet(at.x, at.y));
  return {{at.x, at.y, road + ground.profile.height}, fromTurns(turns)};
}

double
sum(UnitVector a, UnitVector b, bool sine)
{
  return 0.5 * (sine ? a.sine + b.sine : a.cosine + b.cosine);
}

/** Two prisms that turn against each other: no ray is like another one. */
std::vector<LidarRay>
rosette(double width, double height, double phase)
{
  constexpr std::size_t rays = 48000;
  constexpr double one = 0.0061803398875, other = -0.0035321; // turns per ray
  std::vector<LidarRay> found;
  for (std::size_t i = 0; i < rays; ++i) {
    const double at = static_cast<double>(i) + phase * 1e4;
    const UnitVector a = fromTurns(one * at), b = fromTurns(other * at);
    const UnitVector side = fromTurns(0.5 * width / 360.0 * sum(a, b, false));
    const UnitVector up = fromTurns(0.5 * height / 360.0 * sum(a, b, true));
    found.push_back({{up.cosine * side.cosine, up.cosine * side.sine, up.sine},
                     0,
                     static_cast<double>(i) / rays});
  }
  return found;
}

std::vector<LidarRay>
raysOf(const LidarOptions& options)
{
  const std::vector<double> elevations = beamElevations(options.beams);
  if (options.pattern != LidarPattern::Turn) {
    const double phase = static_cast<double>(options.seed % 1000) / 1000.0;
    return options.pattern == LidarPattern::Rosette70 ? rosette(70.4, 77.2, phase)
                                                      : rosette(120.0, 25.0, phase);
  }
  const unsigned columns = options.beams == 64    ? 2083
                           : options.beams == 128 ? 1024
                           : options.beams == 32  ? 2170
                                                  : 1800;
  std::vector<LidarRay> rays;
  for (unsigned column = 0; column < columns; ++column) {
    const UnitVector turn = fromTurns(-(column + 0.5) / columns);
    for (std::size_t beam = 0; beam < elevations.size(); ++beam) {
      const UnitVector up = fromTurns(elevations[beam] / 360.0);
      rays.push_back({{up.cosine * turn.cosine, up.cosine * turn.sine, up.sine},
                      beam,
                      static_cast<double>(column) / columns});
    }
  }
  return rays;
}

bool
isIndoor(StreetPlace place)
{
  return place == StreetPlace::Garage || place == StreetPlace::Corridor ||
         place == StreetPlace::Hall;
}

void
append(const Return& found, const Vec3& point, std::size_t beam, LidarScan& scan)
{
  append(point, scan.xyz);
  append(found.normal, scan.normals);
  scan.ground.push_back(found.ground);
  scan.surface.push_back(found.surface);
  scan.instance.push_back(found.instance);
  scan.ring.push_back(static_cast<std::uint32_t>(beam));
}

} // namespace

std::vector<double>
beamElevations(unsigned beams)
{
  std::vector<double> elevations;
  if (beams == 64) {
    for (int i = 31; i >= 0; --i)
      elevations.push_back(-8.0 - 5.0 / 6.0 - i / 2.0);
    for (int i = 31; i >= 0; --i)
      elevations.push_back(2.0 - i / 3.0);
  }
  else if (beams == 16) {
    for (int i = 0; i < 16; ++i)
      elevations.push_back(-15.0 + 2.0 * i);
  }
  else if (beams == 32) {
    for (int i = 0; i < 32; ++i)
      elevations.push_back((-92.0 + 4.0 * i) / 3.0);
  }
  else if (beams == 128) {
    for (int i = 0; i < 128; ++i)
      elevations.push_back(-22.5 + 45.0 * i / 127.0);
  }
  else
    throw std::invalid_argument("beams must be 16, 32, 64 or 128, not " +
                                std::to_string(beams));
  return elevations;
}

LidarScan
scanStreet(const LidarOptions& options)
{
  requireRange("sigma", options.sigma, 0.0, 0.1, " m");
  requireRange("speed", options.speed, 0.0, 60.0, " m/s");
  requireRange("yaw_rate", options.yaw_rate, -180.0, 180.0, " degrees per second");
  const std::vector<LidarRay> rays = raysOf(options);
  const double reach = options.pattern == LidarPattern::Turn && options.beams >= 64
                           ? 120.0
                           : 100.0; // meters
  const Street street = randomStreet(options.seed, options.place);
  World solids;
  solids.solids = street.solids;
  const RayCaster caster(solids);
  Random random(options.seed, scan_stream);
  // Other numbers, so that a street without them has the noise that it always had.
  Random rough(options.seed, rough_stream);
  const Puddles puddles(street, rough);
  const double nearest = isIndoor(options.place) ? indoor_range : min_range;
  LidarScan scan;
  scan.objects = street.objects;
  for (const LidarRay& ray : rays) {
    const bool lost = random.chance(drop_out_rate) && options.drop_outs;
    const double error = options.sigma * random.normal();
    const Scanner scanner = scannerAt(street.ground, options, ray.time);
    const Ray cast_ray{scanner.origin, scanner.turned(ray.direction)};
    auto found =
        cast(street, solids, caster, cast_ray, reach, nearest, rough.uniform());
    const bool is_mirrored = rough.chance(wet_share) && options.mirrors;
    if (found && is_mirrored && found->ground == GroundTrue) {
      const Vec3 at = cast_ray.origin + cast_ray.direction * found->range;
      if (puddles.haveAt(at))
        found = mirrored(caster, *found, at, cast_ray.origin, reach);
    }
    if (!lost && found) {
      found->normal = scanner.turnedBack(found->normal);
      append(*found, ray.direction * (found->range + error), ray.beam, scan);
    }
    else if (options.fillers)
      append(Return{0.0, -ray.direction, GroundNot, SurfaceVoid, 0},
             Vec3{},
             ray.beam,
             scan);
  }
  return scan;
}

} // namespace pcl::scene
