// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Streets and other places, and what stands in them.

#include "scene/worlds/street.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace pcl::scene {
namespace {

constexpr std::uint64_t street_stream = 11;
constexpr double far_end = 120.0; // meters to the front and to the back

/** Puts things on the ground of a street. */
class StreetBuilder {
public:
  StreetBuilder(Street& street, Random& random) : street_(street), random_(random) {}

  void
  beginObject()
  {
    ++street_.objects;
  }

  /** A ball. \param[in] height of its middle above the ground */
  void
  addBall(const StreetPoint& at, double height, double radius)
  {
    Pose pose = upright(at, 0.0);
    pose.origin.z += height;
    add({Shape::Sphere, {radius, 0.0, 0.0}, pose});
  }

  /** Along the street, above the ground. */
  void
  addSlab(const StreetPoint& at,
          double length,
          double width,
          double bottom,
          double thickness)
  {
    addBox(upright(at, 0.0),
           {0.0, 0.0, bottom + 0.5 * thickness},
           {length, width, thickness});
  }

  /** \param[in] at its middle, in the frame of what it belongs to */
  void
  addBox(const Pose& frame, const Vec3& at, const std::array<double, 3>& size)
  {
    Pose pose = frame;
    pose.origin = frame.toWorld(at);
    add({Shape::Box, size, pose});
  }

  /** Along the street, its foot below a slope. */
  void
  addBlock(
      const StreetPoint& at, double below, double length, double width, double height)
  {
    addBox(upright(at, below),
           {0.0, 0.0, 0.5 * (below + height)},
           {length, width, below + height});
  }

  /** Upright. */
  void
  addCylinder(const Pose& frame, double radius, double height)
  {
    add({Shape::Cylinder, {radius, height, 0.0}, frame});
  }

  /** Lying across. \param[in] at the middle of its nearer end */
  void
  addWheel(const Pose& frame, const Vec3& at, double radius, double width)
  {
    Pose pose;
    pose.axes = {frame.axes[2], frame.axes[0], frame.axes[1]};
    pose.origin = frame.toWorld(at);
    add({Shape::Cylinder, {radius, width, 0.0}, pose});
  }

  /** Where something stands whose foot reaches below a slope. */
  Pose
  upright(const StreetPoint& at, double below) const
  {
    const UnitVector heading = street_.ground.profile.heading;
    Pose pose;
    pose.axes = {Vec3{heading.cosine, -heading.sine, 0.0},
                 Vec3{heading.sine, heading.cosine, 0.0},
                 Vec3{0.0, 0.0, 1.0}};
    pose.origin = street_.ground.toSensor(at, street_.ground.height(at) - below);
    return pose;
  }

  void
  addCar(const StreetPoint& at)
  {
    const double length = random_.uniform(3.8, 4.9), width = random_.uniform(1.7, 1.9);
    const double clearance = random_.uniform(0.15, 0.25);
    const double hood = random_.uniform(0.8, 1.0), roof = random_.uniform(1.4, 1.9);
    const Pose frame = street_.ground.standing(at);
    beginObject();
    addBox(
        frame, {0.0, 0.0, 0.5 * (clearance + hood)}, {length, width, hood - clearance});
    addBox(frame,
           {-0.08 * length, 0.0, 0.5 * (hood + roof)},
           {0.55 * length, 0.88 * width, roof - hood});
    constexpr double wheel = 0.32, wheel_width = 0.2;
    for (const double end : {-0.31, 0.31})
      for (const double side : {-0.5 * width + 0.01, 0.5 * width - 0.01 - wheel_width})
        addWheel(frame, {end * length, side, wheel}, wheel, wheel_width);
  }

private:
  void
  add(const Solid& solid)
  {
    street_.solids.push_back(solid);
    street_.instances.push_back(street_.objects);
  }

  Street& street_;
  Random& random_;
};

/** Ranges as found in towns: curbs of 8 to 16 cm, crowns of 1.5 to 3 %, grades to 6 %,
 * crests and sags with radii of 600 m and more, undulation of a few centimeters. */
StreetProfile
randomProfile(Random& random)
{
  StreetProfile profile;
  profile.heading = fromTurns(random.uniform(-0.015, 0.015));
  profile.half_width = random.uniform(3.5, 5.5);
  profile.lane = random.uniform(-2.0, 0.0);
  profile.height = random.uniform(1.68, 1.78);
  profile.curb = random.uniform(0.08, 0.16);
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
    StreetBuilder& builder, double side, double curb, double front, Random& random)
{
  constexpr double below = 0.3;
  for (double s = -70.0 + random.uniform(0.0, 10.0); s < 70.0;
       s += random.uniform(4.0, 12.0)) {
    const double inner = curb + 0.6;
    const double across = side * random.uniform(inner, std::max(inner, front - 0.8));
    const double kind = random.uniform();
    builder.beginObject();
    if (kind < 0.4) { // pole, at the curb
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

void
addDrivingCars(Random& random, StreetBuilder& builder, const StreetProfile& profile)
{
  for (const double s : {random.uniform(10.0, 35.0), random.uniform(-40.0, -12.0)})
    builder.addCar({s, profile.lane});
}

/** Things on both sides, and two cars that drive. */
void
addTraffic(StreetBuilder& builder, const StreetProfile& profile, Random& random)
{
  for (const double side : {-1.0, 1.0}) {
    const double curb = profile.half_width;
    const double front = curb + random.uniform(1.8, 5.0);
    addHouses(builder, side, front, random);
    addCars(builder, side, curb, random);
    addSmallThings(builder, side, curb, front, random);
  }
  addDrivingCars(random, builder, profile);
}

constexpr double below = 0.3; // meters that things reach into the ground

/** A floor: nearly level, without a curb. */
void
flatten(Random& random, double half_width, StreetProfile& profile)
{
  profile.half_width = half_width;
  profile.lane = random.uniform(-0.4, 0.4) * half_width;
  profile.curb = 0.0;
  profile.grade = random.uniform(-0.015, 0.015);
  profile.tilt = random.uniform(-0.01, 0.01);
  profile.curvature = 0.0;
  profile.crown = 0.0;
  profile.wave = 0.0;
}

/** A ditch, then a field or an embankment of up to 10 degrees. */
std::vector<SideKnot>
countrySide(Random& random)
{
  const double begin = random.uniform(1.0, 2.5);
  std::vector<SideKnot> knots{{0.0, 0.0}, {begin, -0.03 * begin}};
  if (random.chance(0.6)) { // sides of 1 in 3
    const double depth = random.uniform(0.3, 0.8), half = 3.0 * depth;
    const double rise = knots.back().rise;
    knots.push_back({begin + half, rise - depth});
    knots.push_back({begin + half + 0.4, rise - depth});
    knots.push_back({begin + 2.0 * half + 0.4, rise});
  }
  const SideKnot last = knots.back();
  const double slope = random.uniform(-0.17, 0.17);
  const double width = random.uniform(5.0, 30.0);
  knots.push_back({last.across + width, last.rise + slope * width});
  knots.push_back({last.across + 2.0 * width, last.rise + 1.2 * slope * width});
  return knots;
}

void
shapeTownWithBumps(Random& random, StreetProfile& profile)
{
  for (double s = -45.0 + random.uniform(0.0, 20.0); s < 50.0;
       s += random.uniform(15.0, 30.0))
    profile.bumps.push_back({s, random.uniform(0.05, 0.10), random.uniform(0.45, 2.0)});
  for (const double side : {-1.0, 1.0}) {
    const double begin = random.uniform(4.0, 15.0) * (random.chance(0.5) ? 1.0 : -1.0);
    profile.driveways.push_back({begin,
                                 begin + random.uniform(4.0, 7.0),
                                 side,
                                 random.uniform(-0.17, 0.17),
                                 random.uniform(4.0, 10.0)});
  }
}

/** Along both sides of the driveways. */
void
addWalls(Random& /*random*/, StreetBuilder& builder, const StreetProfile& profile)
{
  constexpr double thickness = 0.3;
  for (const Driveway& way : profile.driveways) {
    const double depth = std::abs(way.slope) * way.length;
    for (const double s : {way.begin, way.end}) {
      builder.beginObject();
      builder.addBlock({s, way.side * (profile.half_width + 1.2 + 0.5 * way.length)},
                       depth + 1.0,
                       thickness,
                       way.length,
                       depth + 0.8);
    }
  }
}

/** A ceiling on walls all around. */
void
addRoom(const StreetPoint& middle,
        double length,
        double width,
        double height,
        StreetBuilder& builder)
{
  constexpr double thickness = 0.4;
  builder.beginObject();
  builder.addSlab(middle, length + 2.0, width + 2.0, height, thickness);
  for (const double side : {-0.5, 0.5}) {
    builder.addBlock({middle.s, middle.t + side * (width + thickness)},
                     below,
                     length + 1.0,
                     thickness,
                     height + thickness);
    builder.addBlock({middle.s + side * (length + thickness), middle.t},
                     below,
                     thickness,
                     width + 1.0,
                     height + thickness);
  }
}

void
addGarage(Random& random, StreetBuilder& builder, const StreetProfile& profile)
{
  const double height = profile.height + random.uniform(0.35, 1.0);
  const double width = 2.0 * profile.half_width, length = random.uniform(25.0, 80.0);
  const double middle = random.uniform(-0.3, 0.3) * length;
  addRoom({middle, 0.0}, length, width, height, builder);
  const double beam = random.uniform(0.1, 0.3), gap = random.uniform(5.0, 8.0);
  for (double s = middle - 0.5 * length + 2.0; s < middle + 0.5 * length; s += gap) {
    builder.beginObject();
    builder.addSlab({s, 0.0}, 0.4, width, height - beam, beam);
    for (const double t : {-0.6, 0.6}) {
      builder.beginObject();
      builder.addBlock({s, t * profile.half_width}, below, 0.4, 0.4, height);
    }
    for (const double t : {-1.0, 1.0})
      if (std::abs(s) > 4.0 && random.chance(0.6))
        builder.addCar({s + 2.7, t * (profile.half_width - 1.5)});
  }
}

void
addTunnel(Random& random, StreetBuilder& builder, const StreetProfile& profile)
{
  const double width = 2.0 * profile.half_width + random.uniform(1.5, 3.0);
  addRoom({random.uniform(-40.0, 40.0), 0.0},
          random.uniform(80.0, 220.0),
          width,
          random.uniform(4.5, 6.0),
          builder);
  addDrivingCars(random, builder, profile);
}

void
addBridge(Random& random, StreetBuilder& builder, const StreetProfile& profile)
{
  const double s = random.uniform(-5.0, 25.0), length = random.uniform(8.0, 20.0);
  builder.beginObject();
  builder.addSlab({s, 0.0}, length, 80.0, random.uniform(4.2, 6.0), 1.2);
  for (const double side : {-1.0, 1.0})
    builder.addBlock({s, side * (profile.half_width + 1.5)}, below, length, 0.8, 4.5);
}

void
addCanopy(Random& random, StreetBuilder& builder, const StreetProfile& profile)
{
  for (double s = -50.0; s < 50.0; s += random.uniform(5.0, 10.0))
    for (const double side : {-1.0, 1.0}) {
      builder.beginObject();
      for (int i = 0; i < 12; ++i) {
        const double radius = random.uniform(0.4, 1.1);
        builder.addBall({s + random.uniform(-3.0, 3.0),
                         side * (profile.half_width + random.uniform(-3.0, 2.0))},
                        2.6 + radius + random.uniform(0.0, 3.0),
                        radius);
      }
    }
}

void
addCountry(Random& random, StreetBuilder& builder, const StreetProfile& profile)
{
  for (const double side : {-1.0, 1.0})
    for (double s = -60.0 + random.uniform(0.0, 10.0); s < 60.0;
         s += random.uniform(4.0, 12.0)) {
      const StreetPoint at{s, side * (profile.half_width + random.uniform(1.5, 15.0))};
      builder.beginObject();
      if (random.chance(0.5)) { // a tree
        builder.addCylinder(
            builder.upright(at, below), random.uniform(0.1, 0.3), below + 5.0);
        builder.addBall(at, 5.0, random.uniform(1.0, 2.5));
      }
      else if (random.chance(0.5)) // a bush
        builder.addBall(at, random.uniform(0.2, 0.6), random.uniform(0.5, 1.0));
      else // a post
        builder.addCylinder(builder.upright(at, below), 0.05, below + 1.2);
    }
  addDrivingCars(random, builder, profile);
}

void
addDeck(Random& random, StreetBuilder& builder, const StreetProfile& profile)
{
  for (const double side : {-1.0, 1.0}) {
    builder.beginObject();
    builder.addBlock({0.0, side * (profile.half_width - 0.15)},
                     below,
                     240.0,
                     0.3,
                     random.uniform(0.4, 1.0));
    for (double s = -40.0; s < 40.0; s += random.uniform(2.6, 8.0))
      if (std::abs(s) > 5.0 && random.chance(0.6))
        builder.addCar({s, side * (profile.half_width - 2.0)});
  }
}

void
addCorridor(Random& random, StreetBuilder& builder, const StreetProfile& profile)
{
  const double length = random.uniform(15.0, 60.0);
  const double middle = random.uniform(-0.4, 0.4) * length;
  addRoom({middle, 0.0},
          length,
          2.0 * profile.half_width,
          random.uniform(2.3, 3.0),
          builder);
  for (double s = middle - 0.4 * length; s < middle + 0.4 * length;
       s += random.uniform(3.0, 9.0)) {
    if (std::abs(s) < 1.0)
      continue;
    builder.beginObject();
    builder.addBlock(
        {s, (random.chance(0.5) ? 1.0 : -1.0) * (profile.half_width - 0.25)},
        below,
        random.uniform(0.4, 1.5),
        0.4,
        random.uniform(0.4, 1.8));
  }
}

void
addHall(Random& random, StreetBuilder& builder, const StreetProfile& profile)
{
  const double length = random.uniform(20.0, 70.0);
  addRoom({random.uniform(-0.3, 0.3) * length, 0.0},
          length,
          2.0 * profile.half_width,
          random.uniform(4.0, 10.0),
          builder);
  for (double s = -0.2 * length; s < 0.2 * length; s += random.uniform(4.0, 8.0))
    for (const double t : {-0.7, 0.7}) {
      builder.beginObject();
      builder.addBlock({s, t * profile.half_width},
                       below,
                       random.uniform(1.0, 3.0),
                       random.uniform(0.5, 1.2),
                       random.uniform(0.5, 3.0));
    }
}

/** Changes the shape of a street to that of another place. */
void
shapePlace(StreetPlace place, Random& random, StreetProfile& profile)
{
  if (place == StreetPlace::Bumps)
    shapeTownWithBumps(random, profile);
  if (place == StreetPlace::Country) {
    profile.curb = 0.0;
    profile.grass = random.uniform(0.05, 0.15);
    profile.sides = {countrySide(random), countrySide(random)};
  }
  if (place == StreetPlace::Deck) {
    flatten(random, random.uniform(6.0, 10.0), profile);
    const double depth = random.uniform(3.0, 8.0);
    for (auto& side : profile.sides)
      side = {{0.0, 0.0}, {0.01, -depth}, {100.0, -depth}};
    profile.low_level = profile.half_width;
  }
  if (place == StreetPlace::Garage)
    flatten(random, random.uniform(7.0, 16.0), profile);
  if (place == StreetPlace::Corridor)
    flatten(random, random.uniform(0.8, 1.6), profile);
  if (place == StreetPlace::Hall)
    flatten(random, random.uniform(6.0, 20.0), profile);
  if (place == StreetPlace::Corridor || place == StreetPlace::Hall)
    profile.height = random.uniform(0.4, 1.4);
}

/** Adds what a place has besides the traffic of a town. */
void
fillPlace(StreetPlace place,
          Random& random,
          StreetBuilder& builder,
          const StreetProfile& profile)
{
  using Fill = void (*)(Random&, StreetBuilder&, const StreetProfile&);
  static const std::map<StreetPlace, Fill> fills{{StreetPlace::Bumps, addWalls},
                                                 {StreetPlace::Bridge, addBridge},
                                                 {StreetPlace::Canopy, addCanopy},
                                                 {StreetPlace::Country, addCountry},
                                                 {StreetPlace::Deck, addDeck},
                                                 {StreetPlace::Garage, addGarage},
                                                 {StreetPlace::Tunnel, addTunnel},
                                                 {StreetPlace::Corridor, addCorridor},
                                                 {StreetPlace::Hall, addHall}};
  if (const auto fill = fills.find(place); fill != fills.end())
    fill->second(random, builder, profile);
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
