// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A spinning laser scanner in a random street.

#include "scene/lidar.h"

#include "scene/scene.h"
#include "scene/street.h"
#include "scene/world.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace pcl::scene {
namespace {

constexpr std::uint64_t scan_stream = 12;
constexpr double drop_out_rate = 0.01;
constexpr double asphalt_reach = 50.0; // meters
constexpr double min_range = 0.9;      // meters

/** \brief What a ray meets first. */
struct Return {
  double range;
  Vec3 normal;
  std::uint32_t ground, surface, instance;
};

/** \brief Nothing if the ray is lost.
 * \param[in] solids what stands in the street \param[in] direction unit */
std::optional<Return>
cast(const Street& street,
     const World& solids,
     const RayCaster& caster,
     const Vec3& direction,
     double reach)
{
  const Sight sight = caster.cast({{}, direction});
  const double range = sight.object == nothing ? reach : sight.depth;
  if (const auto hit = street.ground.cast(direction, std::min(range, reach))) {
    if (hit->distance > asphalt_reach)
      return std::nullopt;
    const std::uint32_t ground = hit->kerb_face ? GroundVoid : GroundTrue;
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
  else
    throw std::invalid_argument("beams must be 16 or 64, not " + std::to_string(beams));
  return elevations;
}

LidarScan
scanStreet(const LidarOptions& options)
{
  requireRange("sigma", options.sigma, 0.0, 0.1, " m");
  const std::vector<double> elevations = beamElevations(options.beams);
  const unsigned columns = options.beams == 64 ? 2083 : 1800; // in a turn
  const double reach = options.beams == 64 ? 120.0 : 100.0;   // meters
  const Street street = randomStreet(options.seed);
  World solids;
  solids.table.center.x = 1e9; // there is none
  solids.solids = street.solids;
  const RayCaster caster(solids);
  Random random(options.seed, scan_stream);
  LidarScan scan;
  scan.objects = street.objects;
  for (unsigned column = 0; column < columns; ++column) {
    const UnitVector turn = fromTurns(-(column + 0.5) / columns);
    for (std::size_t beam = 0; beam < elevations.size(); ++beam) {
      const UnitVector up = fromTurns(elevations[beam] / 360.0);
      const Vec3 direction{up.cosine * turn.cosine, up.cosine * turn.sine, up.sine};
      const bool lost = random.chance(drop_out_rate) && options.drop_outs;
      const double error = options.sigma * random.normal();
      const auto found = cast(street, solids, caster, direction, reach);
      if (lost || !found)
        continue;
      append(direction * (found->range + error), scan.xyz);
      append(found->normal, scan.normals);
      scan.ground.push_back(found->ground);
      scan.surface.push_back(found->surface);
      scan.instance.push_back(found->instance);
      scan.ring.push_back(static_cast<std::uint32_t>(beam));
    }
  }
  return scan;
}

} // namespace pcl::scene
