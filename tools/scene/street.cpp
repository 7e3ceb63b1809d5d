// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Random streets: houses, cars, poles, hedges, boxes and people.

#include "scene/street.h"

#include "scene/street_builder.h"
#include "scene/street_places.h"

#include <cmath>

namespace pcl::scene {
namespace {

constexpr std::uint64_t street_stream = 11;
constexpr double far_end = 120.0; // meters to the front and to the back

/** Ranges as found in towns: kerbs of 8 to 16 cm, crowns of 1.5 to 3 %, grades to 6 %,
 * crests and sags with radii of 600 m and more, undulation of a few centimeters. */
StreetProfile
randomProfile(Random& random)
{
  StreetProfile profile;
  profile.heading = fromTurns(random.uniform(-0.015, 0.015));
  profile.half_width = random.uniform(3.5, 5.5);
  profile.lane = random.uniform(-2.0, 0.0);
  profile.height = random.uniform(1.68, 1.78);
  profile.kerb = random.uniform(0.08, 0.16);
  profile.grade = random.uniform(-0.06, 0.06);
  profile.tilt = random.uniform(-0.015, 0.015);
  profile.curvature = random.uniform(-1.0, 1.0) / 600.0;
  profile.crown = random.uniform(0.015, 0.03);
  profile.wave = random.uniform(0.0, 0.04);
  profile.wave_length = random.uniform(15.0, 40.0);
  profile.wave_phase = random.uniform();
  return profile;
}

/** House fronts along one side, with gaps; some stand back. */
void
addHouses(StreetBuilder& builder, double side, double front, Random& random)
{
  constexpr double below = 3.0, depth = 10.0;
  double s = -far_end + random.uniform(0.0, 10.0);
  while (s < far_end) {
    const double length = random.uniform(8.0, 25.0);
    const double height = random.uniform(4.0, 14.0);
    const double back = random.chance(0.3) ? random.uniform(1.0, 4.0) : 0.0;
    const double middle = side * (front + back + 0.5 * depth);
    builder.beginObject();
    builder.addBlock({s + 0.5 * length, middle}, below, length, depth, height);
    s += length + (random.chance(0.4) ? random.uniform(2.0, 12.0) : 0.0);
  }
}

/** Cars along one side, and one or two that drive. */
void
addCars(StreetBuilder& builder, double side, double half_width, Random& random)
{
  for (double s = -60.0 + random.uniform(0.0, 8.0); s < 60.0;
       s += random.uniform(5.5, 14.0))
    if (std::abs(s) > 5.0 && random.chance(0.6))
      builder.addCar({s, side * (half_width - random.uniform(1.0, 1.2))});
}

void
addSmallThings(
    StreetBuilder& builder, double side, double kerb, double front, Random& random)
{
  constexpr double below = 0.3;
  for (double s = -70.0 + random.uniform(0.0, 10.0); s < 70.0;
       s += random.uniform(4.0, 12.0)) {
    const double inner = kerb + 0.6;
    const double across = side * random.uniform(inner, std::max(inner, front - 0.8));
    const double kind = random.uniform();
    builder.beginObject();
    if (kind < 0.4) { // pole, at the kerb
      builder.addCylinder(builder.upright({s, side * inner}, below),
                          random.uniform(0.06, 0.2),
                          below + random.uniform(2.5, 8.0));
    }
    else if (kind < 0.65) { // someone
      builder.addCylinder(builder.upright({s, across}, below),
                          random.uniform(0.2, 0.3),
                          below + random.uniform(1.5, 1.9));
    }
    else if (kind < 0.85) { // box, bin
      const double height = random.uniform(0.5, 1.3);
      builder.addBlock({s, across}, below, random.uniform(0.4, 1.2), 0.6, height);
    }
    else { // hedge, before a house
      const double height = random.uniform(0.6, 1.8);
      const double length = random.uniform(2.0, 6.0);
      builder.addBlock({s, side * (front - 0.3)}, below, length, 0.5, height);
    }
  }
}

/** Things on both sides, and two cars that drive. */
void
addTraffic(StreetBuilder& builder, const StreetProfile& profile, Random& random)
{
  for (const double side : {-1.0, 1.0}) {
    const double kerb = profile.half_width;
    const double front = kerb + random.uniform(1.8, 5.0);
    addHouses(builder, side, front, random);
    addCars(builder, side, kerb, random);
    addSmallThings(builder, side, kerb, front, random);
  }
  for (const double s : {random.uniform(10.0, 35.0), random.uniform(-40.0, -12.0)})
    builder.addCar({s, profile.lane});
}

} // namespace

Street
randomStreet(std::uint64_t seed, StreetPlace place)
{
  Random random(seed, street_stream);
  StreetProfile profile = randomProfile(random);
  shapePlace(place, random, profile);
  Street street(profile);
  StreetBuilder builder(street, random);
  if (place == StreetPlace::Town || place == StreetPlace::Bridge ||
      place == StreetPlace::Canopy || place == StreetPlace::Bumps)
    addTraffic(builder, profile, random);
  fillPlace(place, random, builder, profile);
  return street;
}

} // namespace pcl::scene
