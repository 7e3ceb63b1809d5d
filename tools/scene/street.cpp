// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Random streets: houses, cars, poles, hedges, boxes and people.

#include "scene/street.h"

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

/** Puts things on the ground. */
class Builder {
public:
  Builder(Street& street, Random& random) : street_(street), random_(random) {}

  void
  beginObject()
  {
    ++street_.objects;
  }

  /** \param[in] at its middle, in the frame of what it belongs to */
  void
  addBox(const Pose& frame, const Vec3& at, const std::array<double, 3>& size)
  {
    Pose pose = frame;
    pose.origin = frame.toWorld(at);
    add({Shape::Box, size, pose});
  }

  /** \brief Along the street, its foot below a slope. */
  void
  addBlock(
      const StreetPoint& at, double below, double length, double width, double height)
  {
    addBox(upright(at, below),
           {0.0, 0.0, 0.5 * (below + height)},
           {length, width, below + height});
  }

  /** \brief Upright. */
  void
  addCylinder(const Pose& frame, double radius, double height)
  {
    add({Shape::Cylinder, {radius, height, 0.0}, frame});
  }

  /** \brief Lying across. \param[in] at the middle of its nearer end */
  void
  addWheel(const Pose& frame, const Vec3& at, double radius, double width)
  {
    Pose pose;
    pose.axes = {frame.axes[2], frame.axes[0], frame.axes[1]};
    pose.origin = frame.toWorld(at);
    add({Shape::Cylinder, {radius, width, 0.0}, pose});
  }

  /** \brief Where something stands whose foot reaches below a slope. */
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

/** House fronts along one side, with gaps; some stand back. */
void
addHouses(Builder& builder, double side, double front, Random& random)
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
addCars(Builder& builder, double side, double half_width, Random& random)
{
  for (double s = -60.0 + random.uniform(0.0, 8.0); s < 60.0;
       s += random.uniform(5.5, 14.0))
    if (std::abs(s) > 5.0 && random.chance(0.6))
      builder.addCar({s, side * (half_width - random.uniform(1.0, 1.2))});
}

void
addSmallThings(Builder& builder, double side, double kerb, double front, Random& random)
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

} // namespace

Street
randomStreet(std::uint64_t seed)
{
  Random random(seed, street_stream);
  const StreetProfile profile = randomProfile(random);
  Street street(profile);
  Builder builder(street, random);
  for (const double side : {-1.0, 1.0}) {
    const double kerb = profile.half_width;
    const double front = kerb + random.uniform(1.8, 5.0);
    addHouses(builder, side, front, random);
    addCars(builder, side, kerb, random);
    addSmallThings(builder, side, kerb, front, random);
  }
  for (const double s : {random.uniform(10.0, 35.0), random.uniform(-40.0, -12.0)})
    builder.addCar({s, profile.lane});
  return street;
}

} // namespace pcl::scene
