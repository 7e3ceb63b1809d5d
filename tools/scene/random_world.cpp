// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A camera above a table, both a little askew, and objects in its view.

#include "scene/random_world.h"

namespace pcl::scene {
namespace {

/** A camera 0.55 to 0.66 m above the table, looking 35 to 45 degrees down. */
Camera
randomCamera(const SceneOptions& options, Random& random)
{
  constexpr double focal_at_640 = 525.0;
  Camera camera;
  camera.width = options.width;
  camera.height = options.height;
  camera.focal = focal_at_640 * options.width / 640.0;
  const UnitVector tilt = fromTurns(random.uniform(35.0, 45.0) / 360.0);
  const UnitVector roll = fromTurns(random.uniform(-2.0, 2.0) / 360.0);
  const Vec3 right{1.0, 0.0, 0.0};
  const Vec3 down{0.0, -tilt.sine, -tilt.cosine};
  camera.pose.axes = {{right * roll.cosine + down * roll.sine,
                       down * roll.cosine - right * roll.sine,
                       {0.0, tilt.cosine, -tilt.sine}}};
  camera.pose.origin = {0.0, 0.0, random.uniform(0.55, 0.66)};
  return camera;
}

/** Walk around the middle of where objects may be, looking at the same things. */
void
turnAround(const Ground& ground, double degrees, Camera& camera)
{
  const Vec3 middle{0.0, 0.5 * (ground.near + ground.far), 0.0};
  const UnitVector turn = fromTurns(degrees / 360.0);
  const auto turned = [&](const Vec3& v) {
    return Vec3{
        turn.cosine * v.x - turn.sine * v.y, turn.sine * v.x + turn.cosine * v.y, v.z};
  };
  camera.pose.origin = middle + turned(camera.pose.origin - middle);
  for (Vec3& axis : camera.pose.axes)
    axis = turned(axis);
}

Table
randomTable(Random& random)
{
  Table table;
  const UnitVector turn = fromTurns(random.uniform(-5.0, 5.0) / 360.0);
  table.along = {turn.cosine, turn.sine, 0.0};
  table.across = {-turn.sine, turn.cosine, 0.0};
  table.half_length = random.uniform(0.46, 0.54);
  table.half_width = random.uniform(0.56, 0.68);
  table.center = {random.uniform(-0.06, 0.06), 0.15 + table.half_width, 0.0};
  return table;
}

} // namespace

RandomWorld
randomWorld(const SceneOptions& options)
{
  constexpr std::uint64_t placing_stream = 1;
  Random random(options.seed, placing_stream);
  RandomWorld result;
  result.world.camera = randomCamera(options, random);
  result.world.table = randomTable(random);
  result.bodies = randomLayout(Ground{}, options.objects, options.shapes, random);
  if (options.turn != 0.0)
    turnAround(Ground{}, options.turn, result.world.camera);
  for (const auto& body : result.bodies)
    result.world.solids.push_back(body.solid);
  return result;
}

} // namespace pcl::scene
