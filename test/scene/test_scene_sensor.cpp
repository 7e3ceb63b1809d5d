// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The noise and the gaps of the virtual depth camera.

#include "scene/labels.h"
#include "scene/scene.h"
#include "scene/sensors/depth_cameras.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace pcl::scene;

namespace {

constexpr double step_at_1m = 1.0 / (8.0 * 43.55); // 2.87 mm

/** A wide table seen from a height, looking down by the angle with that sine. */
World
tableWorld(double height, double sine)
{
  World world;
  const double cosine = std::sqrt(1.0 - sine * sine);
  world.camera = {640, 480, 525.0, {}};
  world.camera.pose.axes = {{{1, 0, 0}, {0, -sine, -cosine}, {0, cosine, -sine}}};
  world.camera.pose.origin = {0.0, 0.0, height};
  world.table.half_length = world.table.half_width = 10.0;
  return world;
}

/** As the tables of real scenes are seen. */
World
usualTable()
{
  return tableWorld(0.6, 0.62);
}

struct Measured {
  World world;
  View exact;
  std::vector<double> depth;
};

Measured
measureTable(std::uint64_t seed)
{
  Measured measured{usualTable(), {}, {}};
  measured.exact = look(measured.world);
  Random random(seed, 1);
  measured.depth =
      depthImage(measured.world, measured.exact, Noise::Kinect, {}, random).depth;
  return measured;
}

/** Standard deviation of the error along the normal where depth is in a range, in mm.
 */
double
deviationAlongNormal(const Measured& measured, double low, double high)
{
  const Camera& camera = measured.world.camera;
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < measured.depth.size(); ++i) {
    const Sight& sight = measured.exact.sights[i];
    if (sight.depth < low || sight.depth > high || std::isnan(measured.depth[i]))
      continue;
    const Vec3 ray = (sight.point - camera.pose.origin) * (1.0 / sight.depth);
    const double error = (measured.depth[i] - sight.depth) * dot(ray, sight.normal);
    sum += error * error;
    ++count;
  }
  return 1000.0 * std::sqrt(sum / static_cast<double>(count));
}

/** Autocorrelation of a field at a shift, for mean 0 and variance 1. */
double
correlation(const Field& field, unsigned width, unsigned dx, unsigned dy)
{
  double sum = 0.0;
  std::size_t count = 0;
  const std::size_t height = field.size() / width;
  for (std::size_t v = 0; v + dy < height; ++v)
    for (std::size_t u = 0; u + dx < width; ++u, ++count)
      sum += field[v * width + u] * field[(v + dy) * width + u + dx];
  return sum / static_cast<double>(count);
}

} // namespace

TEST(SceneSensor, NoiseAlongTheNormalIsThatOfRealScenes)
{
  double near = 0.0, far = 0.0;
  constexpr int seeds = 4;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const Measured measured = measureTable(seed);
    near += deviationAlongNormal(measured, 0.6, 0.9) / seeds;
    far += deviationAlongNormal(measured, 1.4, 1.6) / seeds;
  }
  EXPECT_GT(near, 1.1);
  EXPECT_LT(near, 1.3);
  EXPECT_NEAR(far, 2.0, 0.2);
}

TEST(SceneSensor, DepthIsQuantised)
{
  const Measured measured = measureTable(5);
  for (const double depth : measured.depth) {
    if (std::isnan(depth))
      continue;
    ASSERT_NEAR(1000.0 * depth, std::round(1000.0 * depth), 1e-9);
    const double steps = 1.0 / (step_at_1m * depth);
    const double nearest = 1.0 / (step_at_1m * std::round(steps));
    ASSERT_LE(std::abs(nearest - depth), 0.0005 + 1e-9);
  }
}

TEST(SceneSensor, NoiseIsCorrelatedOverItsBox)
{
  Random random(9, 1);
  const Field field = boxField(640, 480, 8, 4, random);
  EXPECT_NEAR(correlation(field, 640, 0, 0), 1.0, 0.05);
  EXPECT_NEAR(correlation(field, 640, 4, 0), 0.5, 0.05);
  EXPECT_NEAR(correlation(field, 640, 8, 0), 0.0, 0.05);
  EXPECT_NEAR(correlation(field, 640, 0, 2), 0.5, 0.05);
  EXPECT_NEAR(correlation(field, 640, 0, 4), 0.0, 0.05);
}

TEST(SceneSensor, GridNoiseHasUnitVariance)
{
  Random random(9, 1);
  const Field field = gridField(640, 480, 16.0, random);
  EXPECT_NEAR(correlation(field, 640, 0, 0), 1.0, 0.15);
  EXPECT_GT(correlation(field, 640, 2, 0), 0.9);
  EXPECT_NEAR(correlation(field, 640, 48, 0), 0.0, 0.15);
}

TEST(SceneSensor, NormalDeviates)
{
  Random random(1, 1);
  constexpr int count = 200000;
  double mean = 0.0, square = 0.0, fourth = 0.0;
  for (int i = 0; i < count; ++i) {
    const double x = random.normal();
    mean += x / count;
    square += x * x / count;
    fourth += x * x * x * x / count;
  }
  EXPECT_NEAR(mean, 0.0, 0.01);
  EXPECT_NEAR(square, 1.0, 0.02);
  EXPECT_NEAR(fourth, 3.0, 0.1);
}

TEST(SceneSensor, PortableFunctions)
{
  for (double x = 1e-9; x < 10.0; x *= 1.7)
    EXPECT_NEAR(portableLog(x), std::log(x), 1e-13 * (1.0 + std::abs(std::log(x))));
  for (double turns = -2.0; turns < 2.0; turns += 0.0137) {
    const UnitVector unit = fromTurns(turns);
    EXPECT_NEAR(unit.cosine, std::cos(2.0 * M_PI * turns), 1e-14);
    EXPECT_NEAR(unit.sine, std::sin(2.0 * M_PI * turns), 1e-14);
  }
}

TEST(SceneSensor, ShadowsLieBesideObjects)
{
  World world = usualTable();
  world.table.center.y = 0.7;
  world.table.half_length = world.table.half_width = 0.6;
  Solid box;
  box.size = {0.1, 0.1, 0.2};
  box.pose.origin = {0.0, 0.5, 0.1};
  world.solids = {box};
  const View exact = look(world);
  Random random(5, 1);
  const DepthImage sensor = depthImage(world, exact, Noise::Kinect, {}, random);
  const auto beside = dilated(silhouettes(world, exact), 640, 480, 30.0);
  std::size_t missing = 0, missing_elsewhere = 0, left = 0;
  for (std::size_t i = 0; i < exact.sights.size(); ++i)
    if (exact.sights[i].object != nothing && std::isnan(sensor.depth[i])) {
      ++missing;
      missing_elsewhere += !beside[i];
      left += i % 640 < 320;
    }
  EXPECT_GT(missing, 1000U);
  EXPECT_LT(missing, 12000U);
  EXPECT_EQ(missing_elsewhere, 0U);
  EXPECT_GT(left, missing / 2) << "the projector is on the right";
}

TEST(SceneSensor, GrazingSurfacesAreNotMeasured)
{
  const World world = tableWorld(0.1, 0.2);
  const View exact = look(world);
  Random random(5, 1);
  const DepthImage sensor = depthImage(world, exact, Noise::Kinect, {}, random);
  std::size_t grazing = 0, grazing_measured = 0, steep = 0, steep_measured = 0;
  for (std::size_t i = 0; i < exact.sights.size(); ++i) {
    const Sight& sight = exact.sights[i];
    if (sight.object == nothing)
      continue;
    const bool measured = !std::isnan(sensor.depth[i]);
    const double cosine =
        dot(normalized(world.camera.pose.origin - sight.point), sight.normal);
    if (cosine < 0.05) {
      ++grazing;
      grazing_measured += measured;
    }
    if (cosine > 0.3) {
      ++steep;
      steep_measured += measured;
    }
  }
  EXPECT_GT(grazing, 10000U);
  EXPECT_LT(grazing_measured, grazing / 50);
  EXPECT_GT(steep, 10000U);
  EXPECT_GT(steep_measured, steep - steep / 50);
}
