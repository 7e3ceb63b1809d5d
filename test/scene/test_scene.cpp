// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Generated scenes: seeds, labels, objects, views and bad options.

#include "scene/checksum.h"
#include "scene/scene.h"
#include "scene/worlds/random_world.h"
#include "support/errors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string>

using namespace pcl::scene;

namespace {

SceneOptions
small(std::uint64_t seed, Noise noise = Noise::Kinect)
{
  SceneOptions options;
  options.seed = seed;
  options.width = 320;
  options.height = 240;
  options.noise = noise;
  return options;
}

bool
sameFloats(const std::vector<float>& a, const std::vector<float>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](float x, float y) {
    return x == y || (std::isnan(x) && std::isnan(y));
  });
}

std::string
refusal(const SceneOptions& options)
{
  return pcl::test::exceptionOf<std::invalid_argument>([&] { generateScene(options); });
}

bool
contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

/** A position in the camera's frame, in that of all views. */
std::array<double, 3>
toScene(const Scene& scene, const std::array<double, 3>& p)
{
  std::array<double, 3> result = scene.camera_origin;
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t axis = 0; axis < 3; ++axis)
      result[axis] += scene.camera_axes[row][axis] * p[row];
  return result;
}

} // namespace

TEST(Scene, SameSeedSameScene)
{
  const Scene a = generateScene(small(3)), b = generateScene(small(3));
  EXPECT_TRUE(sameFloats(a.xyz, b.xyz));
  EXPECT_TRUE(sameFloats(a.normals, b.normals));
  EXPECT_TRUE(sameFloats(a.crease_mm, b.crease_mm));
  EXPECT_EQ(a.surface, b.surface);
  EXPECT_EQ(a.edge, b.edge);
  EXPECT_EQ(a.instance, b.instance);
}

TEST(Scene, OfABinWallsAndTheFloorAreNoObjects)
{
  SceneOptions options = small(1, Noise::None);
  options.in_bin = true;
  options.objects = 4;
  const Scene scene = generateScene(options);
  EXPECT_EQ(4u, *std::max_element(scene.instance.begin(), scene.instance.end()));
  std::size_t bottom = 0, walls = 0, floor = 0;
  for (std::size_t i = 0; i < scene.instance.size(); ++i) {
    const double height = toScene(
        scene, {scene.xyz[3 * i], scene.xyz[3 * i + 1], scene.xyz[3 * i + 2]})[2];
    if (std::isnan(height))
      continue;
    if (scene.instance[i] != 0) {
      EXPECT_GT(height, -1e-6) << "an object below the bin";
      continue;
    }
    bottom += std::abs(height) < 1e-6;
    walls += height > 0.02;
    floor += height < -0.15;
  }
  EXPECT_GT(bottom, 20000u);
  EXPECT_GT(walls, 3000u);
  EXPECT_GT(floor, 500u);
}

TEST(Scene, TheRimOfABinHasNoCreasesOfItsOwn)
{
  SceneOptions options;
  options.noise = Noise::None;
  options.in_bin = true;
  options.objects = 1;
  std::size_t corners = 0; // few cameras see one
  for (options.seed = 1; options.seed <= 12; ++options.seed) {
    const Scene scene = generateScene(options);
    const Table bottom = randomWorld(options).world.table;
    for (std::size_t i = 0; i < scene.instance.size(); ++i) {
      const auto at = toScene(
          scene, {scene.xyz[3 * i], scene.xyz[3 * i + 1], scene.xyz[3 * i + 2]});
      const double x = std::abs(at[0] - bottom.center.x) - bottom.half_length;
      const double y = std::abs(at[1] - bottom.center.y) - bottom.half_width;
      if (!(std::min(x, y) > 0.001 && std::max(x, y) < 0.0099 && at[2] > 0.02))
        continue;
      ++corners;
      // The nearest are those that end where two walls meet inside.
      EXPECT_GT(scene.crease_mm[i], 1000.0 * std::hypot(x, y) - 0.5);
    }
  }
  EXPECT_GT(corners, 10u);
}

TEST(Scene, OtherSeedOtherScene)
{
  const Scene a = generateScene(small(3)), b = generateScene(small(4));
  EXPECT_NE(a.instance, b.instance);
  EXPECT_FALSE(sameFloats(a.xyz, b.xyz));
}

TEST(Scene, SameOnEveryMachine)
{
  const Scene scene = generateScene(small(7));
  EXPECT_EQ(pcl_shape_test::checksum(scene), 0x405e6450187bfd9aULL);
  const std::size_t pixels[] = {200 * 320 + 40, 150 * 320 + 160, 100 * 320 + 200};
  const double expected[3][3] = {{-0.33596572, 0.22632000, 0.738},
                                 {0.00161143, 0.09829714, 0.846},
                                 {0.11509714, -0.05541714, 0.746}};
  for (int k = 0; k < 3; ++k)
    for (std::size_t axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(scene.xyz[3 * pixels[k] + axis], expected[k][axis], 1e-6);
}

TEST(Scene, NoiseDoesNotMoveTheObjects)
{
  const Scene exact = generateScene(small(5, Noise::None));
  const Scene noisy = generateScene(small(5));
  ASSERT_EQ(exact.objects.size(), noisy.objects.size());
  for (std::size_t i = 0; i < exact.objects.size(); ++i)
    EXPECT_EQ(exact.objects[i].origin, noisy.objects[i].origin);
}

TEST(Scene, WhiteNoiseHasTheGivenDeviationAlongTheRay)
{
  SceneOptions options = small(5, Noise::White);
  options.white_sigma = 0.004;
  const Scene exact = generateScene(small(5, Noise::None));
  const Scene noisy = generateScene(options);
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < exact.surface.size(); ++i) {
    ASSERT_EQ(std::isnan(exact.xyz[3 * i]), std::isnan(noisy.xyz[3 * i]));
    if (std::isnan(exact.xyz[3 * i]))
      continue;
    for (std::size_t axis = 0; axis < 3; ++axis)
      sum += std::pow(noisy.xyz[3 * i + axis] - exact.xyz[3 * i + axis], 2);
    ++count;
  }
  EXPECT_NEAR(std::sqrt(sum / static_cast<double>(count)), 0.004, 0.00008);
  EXPECT_EQ(exact.surface, noisy.surface);
  EXPECT_TRUE(sameFloats(exact.crease_mm, noisy.crease_mm));
}

TEST(Scene, LabelsFollowTheConventions)
{
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    const Scene scene = generateScene(small(seed));
    for (std::size_t i = 0; i < scene.surface.size(); ++i) {
      const float distance = scene.crease_mm[i];
      if (std::isnan(scene.xyz[3 * i])) {
        ASSERT_EQ(scene.surface[i], SurfaceVoid);
        ASSERT_EQ(scene.edge[i], EdgeVoid);
        ASSERT_EQ(scene.instance[i], 0U);
        ASSERT_TRUE(std::isnan(distance));
        continue;
      }
      ASSERT_GE(distance, 0.0F);
      ASSERT_LE(distance, 50.0F);
      ASSERT_EQ(scene.surface[i] == SurfaceCrease, distance < 10.0F);
      ASSERT_EQ(scene.edge[i] == EdgeCrease, distance < 5.0F);
      const bool labeled =
          scene.surface[i] == SurfacePlanar || scene.surface[i] == SurfaceCurved;
      ASSERT_EQ(scene.edge[i] == EdgeNot, labeled);
      ASSERT_LE(scene.instance[i], scene.objects.size());
      if (scene.instance[i] == 0) {
        ASSERT_NE(scene.surface[i], SurfaceCurved);
      }
    }
  }
}

TEST(Scene, HasEveryShapeAndFillsThePicture)
{
  SceneOptions options;
  options.seed = 11;
  const Scene scene = generateScene(options);
  ASSERT_EQ(scene.objects.size(), 8U);
  std::set<Shape> shapes;
  for (const auto& object : scene.objects)
    shapes.insert(object.shape);
  EXPECT_EQ(shapes.size(), 5U);
  std::size_t measured = 0;
  for (std::size_t i = 0; i < scene.surface.size(); ++i)
    measured += !std::isnan(scene.xyz[3 * i]);
  EXPECT_GT(measured, 150000U);
  EXPECT_LT(measured, 290000U);
}

TEST(Scene, AsManyObjectsAsAskedFor)
{
  for (const unsigned count : {0U, 1U, 2U, 30U}) {
    SceneOptions options = small(2);
    options.objects = count;
    EXPECT_EQ(generateScene(options).objects.size(), count);
  }
}

TEST(Scene, AnotherViewShowsTheSameObjects)
{
  const Scene front = generateScene(small(5, Noise::None));
  SceneOptions options = small(5, Noise::None);
  options.turn = 30.0;
  const Scene right = generateScene(options);
  EXPECT_NE(front.instance, right.instance);
  ASSERT_EQ(front.objects.size(), right.objects.size());
  for (std::size_t i = 0; i < front.objects.size(); ++i) {
    const auto a = toScene(front, front.objects[i].origin);
    const auto b = toScene(right, right.objects[i].origin);
    for (std::size_t axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(a[axis], b[axis], 1e-12);
  }
  const double dx = right.camera_origin[0] - front.camera_origin[0];
  EXPECT_NEAR(dx, 0.67 * std::sin(30.0 * std::acos(-1.0) / 180.0), 1e-12);
  EXPECT_EQ(right.camera_origin[2], front.camera_origin[2]);
  std::size_t on_table = 0;
  for (std::size_t i = 0; i < right.surface.size(); ++i) {
    const float* p = &right.xyz[3 * i];
    if (right.instance[i] != 0 || !std::isfinite(p[2]))
      continue;
    ++on_table;
    EXPECT_NEAR(toScene(right, {p[0], p[1], p[2]})[2], 0.0, 1e-6);
  }
  EXPECT_GT(on_table, 1000u);
}

TEST(Scene, RefusesBadOptions)
{
  SceneOptions options;
  options.objects = 31;
  EXPECT_EQ(refusal(options), "objects must be 0 to 30, not 31");
  options = {};
  options.width = 15;
  EXPECT_EQ(refusal(options), "width must be 16 to 4096 pixels, not 15");
  options = {};
  options.height = 5000;
  EXPECT_EQ(refusal(options), "height must be 16 to 4096 pixels, not 5000");
  options = {};
  options.turn = 180.5;
  EXPECT_EQ(refusal(options), "turn must be -180 to 180 degrees, not 180.5");
  options = {};
  options.noise = Noise::White;
  for (const double sigma : {-0.001, 0.2, std::nan(""), HUGE_VAL}) {
    options.white_sigma = sigma;
    EXPECT_TRUE(contains(refusal(options), "white_sigma must be 0 to 0.1 m, not "));
  }
}
