// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Points sampled all over surfaces: density, labels and noise.

#include "scene/sensors/surface_samples.h"
#include "scene/worlds/random_world.h"
#include "support/errors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

using namespace pcl::scene;

namespace {

SampleOptions
coarse(std::uint64_t seed)
{
  SampleOptions options;
  options.seed = seed;
  options.spacing = 0.005;
  return options;
}

std::string
refusal(const SampleOptions& options)
{
  return pcl::test::exceptionOf<std::invalid_argument>([&] { sampleScene(options); });
}

/** \brief The surface of a ball, or of a cylinder without what it stands on. */
double
areaAboveTable(const Solid& solid)
{
  constexpr double pi = 3.14159265358979323846;
  const double radius = solid.size[0];
  return solid.shape == Shape::Sphere ? 4.0 * pi * radius * radius
                                      : pi * radius * (2.0 * solid.size[1] + radius);
}

bool
isStandingCylinder(const Solid& solid)
{
  return solid.shape == Shape::Cylinder && std::abs(solid.pose.axes[2].z) > 0.999;
}

} // namespace

TEST(SurfaceSamples, TheDensityIsTheOneAskedFor)
{
  int solids = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const SampleOptions options = coarse(seed);
    const Scene scene = sampleScene(options);
    SceneOptions same;
    same.seed = options.seed;
    same.objects = options.objects;
    const RandomWorld world = randomWorld(same);
    for (std::size_t i = 0; i < world.bodies.size(); ++i) {
      const Body& body = world.bodies[i];
      const bool is_simple =
          body.solid.shape == Shape::Sphere || isStandingCylinder(body.solid);
      if (!is_simple || !body.touches.empty())
        continue;
      const double expected =
          areaAboveTable(body.solid) / (options.spacing * options.spacing);
      const auto count =
          std::count(scene.instance.begin(), scene.instance.end(), i + 1);
      EXPECT_NEAR(static_cast<double>(count), expected, 5.0 * std::sqrt(expected));
      ++solids;
    }
  }
  EXPECT_GT(solids, 2);
}

TEST(SurfaceSamples, LabelsFollowTheSpacing)
{
  const SampleOptions options = coarse(4);
  const Scene scene = sampleScene(options);
  ASSERT_EQ(scene.width, scene.surface.size());
  ASSERT_EQ(3 * scene.surface.size(), scene.xyz.size());
  for (std::size_t i = 0; i < scene.surface.size(); ++i) {
    const double spacings = scene.crease_mm[i] / (1000.0 * options.spacing);
    if (std::abs(spacings - 2.0) > 1e-3) {
      ASSERT_EQ(spacings < 2.0, scene.edge[i] == EdgeCrease) << i;
    }
    if (std::abs(spacings - 4.0) > 1e-3) {
      ASSERT_EQ(spacings < 4.0, scene.surface[i] == SurfaceCrease) << i;
    }
  }
  for (const auto value : {SurfacePlanar, SurfaceCurved, SurfaceCrease})
    EXPECT_GT(std::count(scene.surface.begin(), scene.surface.end(), value), 100);
}

TEST(SurfaceSamples, ExactOrWithWhiteNoise)
{
  SampleOptions options = coarse(5);
  const Scene exact = sampleScene(options);
  options.sigma = 0.001;
  const Scene noisy = sampleScene(options);
  ASSERT_EQ(exact.instance, noisy.instance);
  double squares = 0.0;
  for (std::size_t i = 0; i < exact.xyz.size(); ++i) {
    const double d = noisy.xyz[i] - exact.xyz[i];
    squares += d * d;
  }
  EXPECT_NEAR(
      0.001, std::sqrt(squares / static_cast<double>(exact.xyz.size())), 0.00002);
  for (std::size_t i = 0; i < exact.instance.size(); ++i)
    if (exact.instance[i] == 0) {
      ASSERT_EQ(0.0f, exact.xyz[3 * i + 2]);
    }
}

TEST(SurfaceSamples, TheSameSeedIsTheSameScene)
{
  const Scene a = sampleScene(coarse(6)), b = sampleScene(coarse(6));
  EXPECT_EQ(a.xyz, b.xyz);
  EXPECT_NE(a.xyz, sampleScene(coarse(7)).xyz);
}

TEST(SurfaceSamples, BadOptions)
{
  SampleOptions options;
  options.spacing = 0.0;
  EXPECT_EQ("spacing must be 0.0005 to 0.02 m, not 0", refusal(options));
  options = {};
  options.objects = 31;
  EXPECT_NE(std::string::npos,
            refusal(options).find("objects must be 0 to 30, not 31"));
  options = {};
  options.sigma = std::nan("");
  EXPECT_NE(std::string::npos,
            refusal(options).find("sigma must be 0 to 0.1 m, not nan"));
}
