// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Sizes and poses of boxes, cylinders, balls, bowls and cones that rest on something.

#include "scene/worlds/body.h"

#include "scene/parts/part.h"

#include <algorithm>
#include <cmath>

namespace pcl::scene {
namespace {

Pose
upright(const Vec3& heading, const Vec3& origin)
{
  return {{{heading, leftOf(heading), {0, 0, 1}}}, origin};
}

Body
randomBox(double scale, const Vec3& heading, Random& random)
{
  const double length = scale * random.uniform(0.08, 0.20);
  const double width = scale * random.uniform(0.06, 0.14);
  const double height = scale * random.uniform(0.04, 0.17);
  Body body;
  body.solid = {
      Shape::Box, {length, width, height}, upright(heading, {0.0, 0.0, 0.5 * height})};
  body.footprint = rectangle({}, heading, length, width);
  body.high = body.widest_high = height;
  body.carries = true;
  return body;
}

/** A cylinder or a cone on its base. */
Body
standing(Shape shape, double radius, double height, const Vec3& heading)
{
  Body body;
  body.solid = {shape, {radius, height, 0.0}, upright(heading, {})};
  body.footprint = {{Vec3{}}, radius};
  body.high = height;
  return body;
}

Body
randomCylinder(double scale, const Vec3& heading, Random& random)
{
  const double radius = scale * random.uniform(0.028, 0.065);
  const double height = scale * random.uniform(0.06, 0.17);
  Body body = standing(Shape::Cylinder, radius, height, heading);
  if (random.chance(0.25)) {
    body.solid.pose = {{{leftOf(heading), {0.0, 0.0, 1.0}, heading}},
                       Vec3{0.0, 0.0, radius} - heading * (0.5 * height)};
    body.footprint = rectangle({}, heading, height, 2.0 * radius);
    body.high = 2.0 * radius;
    body.widest_low = body.widest_high = radius;
    return body;
  }
  body.widest_high = height;
  body.carries = true;
  return body;
}

Body
ballOfRadius(double radius)
{
  Body body;
  body.solid = {Shape::Sphere, {radius, 0.0, 0.0}, {}};
  body.solid.pose.origin = {0.0, 0.0, radius};
  body.footprint = {{Vec3{}}, radius};
  body.high = 2.0 * radius;
  body.widest_low = body.widest_high = radius;
  return body;
}

Body
randomBowl(double scale, Random& random)
{
  const double radius = scale * random.uniform(0.06, 0.09);
  const double height = radius * random.uniform(0.60, 0.95);
  const double wall = random.uniform(0.003, 0.005);
  Body body;
  body.solid.shape = Shape::Bowl;
  body.solid.size = {radius, height, wall};
  body.footprint = {{Vec3{}}, bowlOpening(body.solid).outer};
  body.high = height;
  body.open = random.chance(0.65);
  if (body.open)
    body.widest_low = body.widest_high = height;
  else
    body.solid.pose = {{{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}}, {0.0, 0.0, height}};
  return body;
}

/** On its side a cone touches the ground along a line; its axis falls towards the apex
 * by the half angle at the apex. */
Pose
coneOnItsSide(double radius, double height, const Vec3& heading)
{
  const double slant = std::sqrt(radius * radius + height * height);
  const double cosine = height / slant, sine = radius / slant;
  const Vec3 axis{heading.x * cosine, heading.y * cosine, -sine};
  const Vec3 side = leftOf(heading);
  return {{{side, cross(axis, side), axis}}, {0.0, 0.0, radius * cosine}};
}

Body
randomCone(double scale, const Vec3& heading, Random& random)
{
  const double radius = scale * random.uniform(0.035, 0.06);
  const double height = scale * random.uniform(0.08, 0.15);
  Body body = standing(Shape::Cone, radius, height, heading);
  if (random.chance(0.25)) {
    Pose pose = coneOnItsSide(radius, height, heading);
    const double behind =
        -radius * radius / std::sqrt(radius * radius + height * height);
    const double ahead = height * dot(pose.axes[2], heading);
    pose.origin = pose.origin - heading * (0.5 * (behind + ahead));
    body.solid.pose = pose;
    body.footprint = rectangle({}, heading, ahead - behind, 2.0 * radius);
    body.high = 2.0 * pose.origin.z;
    body.widest_low = 1.0; // nowhere: it is narrower than its footprint at every height
  }
  return body;
}

Body
randomPartBody(double scale, const Vec3& heading, Random& random)
{
  // Features are a tenth of it: a camera should see them.
  const double size = scale * random.uniform(0.20, 0.36);
  Body body;
  body.solid.shape = Shape::Part;
  body.solid.part = std::make_shared<Part>(randomPart(size, random));
  body.solid.pose = upright(heading, {});
  const Sphere bounds = body.solid.part->bounds();
  body.footprint = {{Vec3{}}, bounds.radius};
  body.high = body.widest_high = 2.0 * bounds.center.z;
  return body;
}

} // namespace

bool
Body::isTouching(std::size_t other) const
{
  return std::find(touches.begin(), touches.end(), other) != touches.end();
}

Vec3
randomHeading(Random& random)
{
  const UnitVector heading = fromTurns(random.uniform());
  return {heading.cosine, heading.sine, 0.0};
}

Body
randomBody(Shape shape, double scale, const Vec3& heading, Random& random)
{
  switch (shape) {
  case Shape::Box:
    return randomBox(scale, heading, random);
  case Shape::Cylinder:
    return randomCylinder(scale, heading, random);
  case Shape::Sphere:
    return ballOfRadius(scale * random.uniform(0.03, 0.06));
  case Shape::Bowl:
    return randomBowl(scale, random);
  case Shape::Cone:
    return randomCone(scale, heading, random);
  case Shape::Part:
    return randomPartBody(scale, heading, random);
  }
  return {};
}

Body
randomLeaningBox(const Body& support, const Vec3& outward, double scale, Random& random)
{
  const UnitVector slope = fromTurns(random.uniform(50.0, 70.0) / 360.0);
  const double foot = support.high * slope.cosine / slope.sine; // from the support
  const double length = support.high / slope.sine * random.uniform(1.1, 1.5);
  const double thickness = scale * random.uniform(0.02, 0.045);
  const double width = scale * random.uniform(0.08, 0.16);

  const Vec3 up{0.0, 0.0, 1.0};
  const Vec3 rise = up * slope.sine - outward * slope.cosine;
  const Vec3 normal = up * slope.cosine + outward * slope.sine;
  const auto& support_axes = support.solid.pose.axes;
  const bool first_axis = std::abs(dot(outward, support_axes[0])) > 0.5;
  const double half_depth = 0.5 * support.solid.size[first_axis ? 0 : 1];
  const double sideways =
      0.25 * support.solid.size[first_axis ? 1 : 0] * random.uniform(-1.0, 1.0);
  const Vec3 edge = cross(rise, normal);
  const Vec3 face{support.solid.pose.origin.x, support.solid.pose.origin.y, 0.0};
  const Vec3 on_face = face + outward * half_depth + edge * sideways;

  Body body;
  body.solid = {
      Shape::Box,
      {width, length, thickness},
      {{{edge, rise, normal}},
       on_face + outward * foot + rise * (0.5 * length) + normal * (0.5 * thickness)}};
  const double nearest = foot - length * slope.cosine;
  const double farthest = foot + thickness * slope.sine;
  body.center = on_face + outward * (0.5 * (nearest + farthest));
  body.center.z = 0.0;
  body.footprint = rectangle(body.center, outward, farthest - nearest, width);
  body.high = length * slope.sine + thickness * slope.cosine;
  body.widest_low = 1.0; // nowhere
  return body;
}

Body
randomBallInBowl(const Body& bowl, Random& random)
{
  const double radius = bowl.solid.size[0], wall = bowl.solid.size[2];
  const Body ball = ballOfRadius((radius - wall) * random.uniform(0.35, 0.6));
  return moved(ball, bowl.solid.pose.origin + Vec3{0.0, 0.0, wall});
}

Body
moved(Body body, const Vec3& by)
{
  body.solid.pose.origin = body.solid.pose.origin + by;
  body.footprint = moved(body.footprint, by);
  body.center = body.center + Vec3{by.x, by.y, 0.0};
  body.low += by.z;
  body.high += by.z;
  body.widest_low += by.z;
  body.widest_high += by.z;
  return body;
}

} // namespace pcl::scene
