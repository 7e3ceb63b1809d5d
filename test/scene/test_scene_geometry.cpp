// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Points, normals and contacts of generated scenes against signed distances.

#include "solids.h"

#include <gtest/gtest.h>

using namespace pcl::scene;

namespace {

Scene
exactScene(std::uint64_t seed, unsigned width, unsigned height)
{
  SceneOptions options;
  options.seed = seed;
  options.width = width;
  options.height = height;
  options.noise = Noise::None;
  return generateScene(options);
}

/** Deepest that a point of one object lies in another. */
double
penetration(const SceneObject& a, const SceneObject& b)
{
  double deepest = 0.0;
  for (const auto& point : solids::surfacePoints(a, 0.004))
    deepest = std::max(deepest, -solids::signedDistance(b, point));
  return deepest;
}

} // namespace

TEST(SceneGeometry, PointsAreOnTheirObjects)
{
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Scene scene = exactScene(seed, 320, 240);
    std::size_t on_objects = 0;
    for (std::size_t i = 0; i < scene.instance.size(); ++i) {
      if (scene.instance[i] == 0)
        continue;
      ++on_objects;
      const solids::Point p{
          scene.xyz[3 * i], scene.xyz[3 * i + 1], scene.xyz[3 * i + 2]};
      const SceneObject& object = scene.objects[scene.instance[i] - 1];
      ASSERT_EQ(object.instance, scene.instance[i]);
      ASSERT_NEAR(solids::signedDistance(object, p), 0.0, 1e-6) << name(object.shape);
    }
    EXPECT_GT(on_objects, 3000U);
  }
}

TEST(SceneGeometry, TableIsFlat)
{
  const Scene scene = exactScene(4, 320, 240);
  const float* normal = nullptr;
  const float* origin = nullptr;
  for (std::size_t i = 0; i < scene.instance.size(); ++i) {
    if (scene.instance[i] != 0 || std::isnan(scene.xyz[3 * i]))
      continue;
    if (!normal) {
      normal = &scene.normals[3 * i];
      origin = &scene.xyz[3 * i];
    }
    double distance = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      distance += normal[axis] * (scene.xyz[3 * i + axis] - origin[axis]);
    ASSERT_NEAR(distance, 0.0, 1e-6);
  }
}

TEST(SceneGeometry, NormalsAreGradientsTowardsTheCamera)
{
  const Scene scene = exactScene(1, 160, 120);
  constexpr double h = 1e-5;
  for (std::size_t i = 0; i < scene.instance.size(); ++i) {
    // Beside a crease the distance has no gradient
    if (scene.instance[i] == 0 || scene.surface[i] == SurfaceCrease ||
        scene.surface[i] == SurfaceVoid)
      continue;
    const float* n = &scene.normals[3 * i];
    const float* x = &scene.xyz[3 * i];
    const solids::Point out{x[0] + h * n[0], x[1] + h * n[1], x[2] + h * n[2]};
    const SceneObject& object = scene.objects[scene.instance[i] - 1];
    ASSERT_NEAR(solids::signedDistance(object, out), h, 2e-7) << name(object.shape);
    ASSERT_LT(n[0] * x[0] + n[1] * x[1] + n[2] * x[2], 0.0F);
  }
}

TEST(SceneGeometry, NearestObjectIsSeen)
{
  const Scene scene = exactScene(6, 160, 120);
  for (std::size_t i = 0; i < scene.instance.size(); ++i) {
    if (std::isnan(scene.xyz[3 * i]))
      continue;
    for (double along = 0.4; along < 0.999; along += 0.005) {
      const solids::Point p{scene.xyz[3 * i] * along,
                            scene.xyz[3 * i + 1] * along,
                            scene.xyz[3 * i + 2] * along};
      for (const auto& object : scene.objects)
        ASSERT_GT(solids::signedDistance(object, p), -1e-6) << name(object.shape);
    }
  }
}

TEST(SceneGeometry, ObjectsTouchWithoutOverlap)
{
  std::size_t touching = 0, objects = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const Scene scene = exactScene(seed, 16, 16);
    std::size_t touching_here = 0;
    for (const auto& object : scene.objects) {
      touching_here += !object.touches.empty();
      for (const auto other : object.touches) {
        const auto& back = scene.objects[other - 1].touches;
        EXPECT_TRUE(std::count(back.begin(), back.end(), object.instance));
      }
    }
    EXPECT_GE(10 * touching_here, 3 * scene.objects.size()) << "seed " << seed;
    touching += touching_here;
    objects += scene.objects.size();
  }
  RecordProperty("touching_percent", static_cast<int>(100 * touching / objects));
}

TEST(SceneGeometry, NoObjectIsInsideAnother)
{
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const Scene scene = exactScene(seed, 16, 16);
    for (const auto& a : scene.objects)
      for (const auto& b : scene.objects) {
        if (a.instance == b.instance)
          continue;
        ASSERT_LT(penetration(a, b), 1e-9)
            << "seed " << seed << ": " << name(a.shape) << ' ' << a.instance << " in "
            << name(b.shape) << ' ' << b.instance;
      }
  }
}

TEST(SceneGeometry, TouchingObjectsReallyTouch)
{
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Scene scene = exactScene(seed, 16, 16);
    for (const auto& a : scene.objects)
      for (const auto other : a.touches) {
        const SceneObject& b = scene.objects[other - 1];
        double gap = 1.0;
        for (const auto& point : solids::surfacePoints(a, 0.002))
          gap = std::min(gap, solids::signedDistance(b, point));
        // Sampled points come within a step of the contact
        EXPECT_LT(gap, 0.004) << "seed " << seed << ": " << a.instance << ' ' << other;
      }
  }
}
