// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Which creases count, and how far points are from them.

#include "scene/creases.h"
#include "scene/labels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace pcl::scene;

namespace {

constexpr double cap = 0.05;

/** A camera 0.6 m above the table that looks 45 degrees down along +y. */
World
emptyWorld()
{
  World world;
  const double s = std::sqrt(0.5);
  world.camera = {
      320, 240, 262.5, {{{{1, 0, 0}, {0, -s, -s}, {0, s, -s}}}, {0, 0, 0.6}}};
  world.table.center = {0.0, 0.7, 0.0};
  world.table.half_length = world.table.half_width = 0.6;
  return world;
}

Solid
box(const Vec3& center, double length, double width, double height)
{
  Solid solid;
  solid.size = {length, width, height};
  solid.pose.origin = center;
  return solid;
}

Solid
cylinder(const Vec3& base, double radius, double height)
{
  Solid solid;
  solid.shape = Shape::Cylinder;
  solid.size = {radius, height, 0.0};
  solid.pose.origin = base;
  return solid;
}

Creases
creasesOf(const World& world)
{
  return Creases(world, {{world.camera.pose.origin}, 0.0});
}

double
sampledDistance(const Creases& creases, const Vec3& p)
{
  double nearest = cap;
  for (const auto& part : creases.parts())
    for (int i = 0; i <= 2000; ++i)
      nearest = std::min(nearest, norm(p - part.point(part.parameter(i / 2000.0))));
  return nearest;
}

} // namespace

TEST(SceneCreases, BoxEdgesWhereTwoFacesAreSeen)
{
  World world = emptyWorld();
  world.solids = {box({0.0, 0.6, 0.05}, 0.2, 0.1, 0.1)};
  const Creases creases = creasesOf(world);
  EXPECT_LT(creases.distance({0.0, 0.55, 0.0}, cap), 1e-9) << "front, on the table";
  EXPECT_LT(creases.distance({0.0, 0.55, 0.1}, cap), 1e-9) << "front, top";
  EXPECT_EQ(creases.distance({0.0, 0.65, 0.1}, cap), cap) << "back, top: a silhouette";
  EXPECT_EQ(creases.distance({0.0, 0.65, 0.0}, cap), cap)
      << "back, on the table: hidden";
  EXPECT_GT(creases.distance({0.1, 0.60, 0.1}, cap), 0.04) << "side, top: a silhouette";
}

TEST(SceneCreases, UprightEdgeBetweenTwoSeenFaces)
{
  World world = emptyWorld();
  world.solids = {box({0.3, 0.6, 0.05}, 0.1, 0.1, 0.1)};
  const Creases creases = creasesOf(world);
  EXPECT_LT(creases.distance({0.25, 0.55, 0.05}, cap), 1e-9) << "nearest to the camera";
  EXPECT_LT(creases.distance({0.25, 0.60, 0.10}, cap), 1e-9) << "left, top";
  EXPECT_GT(creases.distance({0.35, 0.55, 0.05}, cap), 0.04) << "right: a silhouette";
}

TEST(SceneCreases, StackedBoxMakesAConcaveCrease)
{
  World world = emptyWorld();
  world.solids = {box({0.0, 0.6, 0.05}, 0.3, 0.2, 0.1),
                  box({0.0, 0.6, 0.13}, 0.1, 0.1, 0.06)};
  const Creases creases = creasesOf(world);
  EXPECT_LT(creases.distance({0.0, 0.55, 0.1}, cap), 1e-9);
  EXPECT_LT(creases.distance({0.1, 0.5, 0.1}, cap), 1e-9);
}

TEST(SceneCreases, OverhangIsASilhouette)
{
  World world = emptyWorld();
  world.solids = {box({0.0, 0.65, 0.05}, 0.1, 0.1, 0.1),
                  box({0.0, 0.62, 0.13}, 0.2, 0.1, 0.06)};
  const Creases creases = creasesOf(world);
  EXPECT_GT(creases.distance({0.0, 0.57, 0.1}, cap), 0.04);
}

TEST(SceneCreases, OccludedCreaseDoesNotCount)
{
  World world = emptyWorld();
  world.solids = {box({0.0, 0.8, 0.05}, 0.4, 0.1, 0.1),
                  box({0.0, 0.6, 0.1}, 0.1, 0.05, 0.2)};
  const Creases creases = creasesOf(world);
  EXPECT_EQ(creases.distance({0.0, 0.75, 0.0}, cap), cap);
  EXPECT_LT(creases.distance({0.18, 0.75, 0.0}, cap), 1e-9);
}

TEST(SceneCreases, CylinderRims)
{
  World world = emptyWorld();
  world.solids = {cylinder({0.0, 0.6, 0.0}, 0.05, 0.1)};
  const Creases creases = creasesOf(world);
  EXPECT_LT(creases.distance({0.0, 0.55, 0.0}, cap), 1e-9) << "front, on the table";
  EXPECT_LT(creases.distance({0.0, 0.55, 0.1}, cap), 1e-9) << "front, top";
  EXPECT_GT(creases.distance({0.0, 0.65, 0.1}, cap), 0.02) << "back, top: a silhouette";
  EXPECT_NEAR(creases.distance({0.0, 0.55, 0.03}, cap), 0.03, 1e-12);
}

TEST(SceneCreases, LyingCylinderHidesItsContact)
{
  World world = emptyWorld();
  Solid lying = cylinder({-0.1, 0.6, 0.04}, 0.04, 0.2);
  lying.pose.axes = {{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}};
  world.solids = {lying};
  EXPECT_EQ(creasesOf(world).distance({0.0, 0.6, 0.0}, cap), cap);
}

TEST(SceneCreases, DistanceIsThatToTheSampledCreases)
{
  World world = emptyWorld();
  world.solids = {box({-0.15, 0.6, 0.05}, 0.2, 0.1, 0.1),
                  cylinder({-0.12, 0.6, 0.1}, 0.04, 0.06),
                  cylinder({0.1, 0.7, 0.0}, 0.05, 0.1)};
  const Creases creases = creasesOf(world);
  const View view = look(world);
  std::size_t near = 0;
  for (std::size_t i = 0; i < view.sights.size(); i += 29) {
    const Sight& sight = view.sights[i];
    if (sight.object == nothing)
      continue;
    const double exact = creases.distance(sight.point, cap);
    const double sampled = sampledDistance(creases, sight.point);
    ASSERT_LE(exact, sampled + 1e-12);
    ASSERT_NEAR(exact, sampled, 5e-5 * 5e-5 / std::max(exact, 1e-5) + 5e-5);
    near += exact < cap;
  }
  EXPECT_GT(near, 200U);
}

TEST(SceneCreases, SilhouettesAreVoidAndTheTablesBorderIsNot)
{
  World world = emptyWorld();
  world.table.half_length = 0.3;
  world.solids = {box({0.0, 0.6, 0.1}, 0.2, 0.1, 0.2)};
  const View view = look(world);
  const auto marks = silhouettes(world, view);
  std::size_t marked = 0;
  for (std::size_t v = 0; v < view.height; ++v)
    for (std::size_t u = 1; u < view.width; ++u) {
      const std::size_t i = v * view.width + u;
      const Sight &left = view.sights[i - 1], &right = view.sights[i];
      const double jump = std::abs(left.depth - right.depth);
      if (left.object == nothing || right.object == nothing)
        continue;
      if (left.object != right.object && jump > 0.03) {
        ASSERT_TRUE(marks[i] && marks[i - 1]);
        ++marked;
      }
      const bool border = u == 1 || view.sights[i + 1].object == nothing;
      if (border && right.object == table_index && left.object == table_index &&
          view.sights[i - view.width].object != 1) {
        ASSERT_FALSE(marks[i]);
      }
    }
  EXPECT_GT(marked, 50U);
}

TEST(SceneCreases, BowlRimAndConeApexAreVoid)
{
  Solid bowl;
  bowl.shape = Shape::Bowl;
  bowl.size = {0.08, 0.06, 0.004};
  ASSERT_EQ(thinPlaces(bowl).size(), 1U);
  EXPECT_TRUE(edges(bowl).empty());
  const BowlOpening opening = bowlOpening(bowl);
  EXPECT_LT(thinPlaces(bowl).front().distance({opening.outer, 0.0, 0.06}), 0.003);
  Solid cone;
  cone.shape = Shape::Cone;
  cone.size = {0.04, 0.1, 0.0};
  ASSERT_EQ(thinPlaces(cone).size(), 1U);
  EXPECT_NEAR(thinPlaces(cone).front().distance({0.0, 0.0, 0.09}), 0.01, 1e-12);
}
