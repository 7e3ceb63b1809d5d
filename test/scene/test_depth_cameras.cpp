// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Waviness, fattened outlines, flying pixels and ripples of depth cameras.

#include "scene/checksum.h"
#include "scene/labels.h"
#include "scene/sensors/depth_cameras.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using namespace pcl::scene;

namespace {

constexpr double table_depth = 0.8;

/** A table from straight above; the camera's y is the world's -y. */
World
tableFromAbove()
{
  World world;
  world.camera = {640, 480, 525.0, {}};
  world.camera.pose.axes = {{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}};
  world.camera.pose.origin = {0.0, 0.0, table_depth};
  world.table.half_length = world.table.half_width = 10.0;
  return world;
}

/** With a box on it, 20 cm wide and long and 10 cm high. */
World
boxFromAbove()
{
  World world = tableFromAbove();
  Solid box;
  box.size = {0.2, 0.2, 0.1};
  box.pose.origin = {0.0, 0.0, 0.05};
  world.solids = {box};
  return world;
}

DepthImage
measured(const World& world, Noise camera, const Waviness& waviness, std::uint64_t seed)
{
  Random random(seed, 1);
  return depthImage(world, look(world), camera, waviness, random);
}

/** Mean product of errors of pixels in a row that are some pixels apart. */
double
covariance(const DepthImage& image, unsigned apart)
{
  double sum = 0.0;
  std::size_t count = 0;
  const unsigned width = image.view.width;
  for (std::size_t i = 0; i + apart < image.depth.size(); ++i) {
    if (i % width + apart >= width ||
        std::isnan(image.depth[i] + image.depth[i + apart]))
      continue;
    sum += (image.depth[i] - table_depth) * (image.depth[i + apart] - table_depth);
    ++count;
  }
  return sum / static_cast<double>(count);
}

} // namespace

TEST(DepthCameras, WavesHaveTheSigmaAndTheLengthAskedFor)
{
  const World world = tableFromAbove();
  const double pixels_per_meter = world.camera.focal / table_depth;
  for (const Waviness& waves :
       {Waviness{0.003, 0.02}, Waviness{0.001, 0.03}, Waviness{0.002, 0.01}}) {
    const DepthImage image = measured(world, Noise::Structured, waves, 3);
    const auto correlation = [&](double lengths) {
      const double apart = lengths * waves.length * pixels_per_meter;
      return covariance(image, static_cast<unsigned>(std::lround(apart))) /
             (waves.sigma * waves.sigma);
    };
    EXPECT_NEAR(std::sqrt(covariance(image, 0)), waves.sigma, 0.06 * waves.sigma);
    EXPECT_NEAR(correlation(0.5), 0.68, 0.08);
    EXPECT_NEAR(correlation(1.5), 0.0, 0.08);
    EXPECT_NEAR(correlation(4.0), 0.0, 0.08);
  }
}

TEST(DepthCameras, TheirOwnNoiseIsWhatTheirPagesSay)
{
  const World world = tableFromAbove();
  const Waviness none{0.0, 0.02};
  const DepthImage tof = measured(world, Noise::TimeOfFlight, none, 4);
  EXPECT_NEAR(std::sqrt(covariance(tof, 0)), 0.0015 * 0.64, 0.00005);
  EXPECT_NEAR(covariance(tof, 1) / covariance(tof, 0), 0.0, 0.02) << "white";

  const DepthImage stereo = measured(world, Noise::Stereo, none, 4);
  // A disparity of 32.8 pixels that is off by .05 (1.22 mm), in steps of 1/32 (.76 mm)
  // and in whole millimeters: 1.407 mm by a simulation of 2 million deviates
  EXPECT_NEAR(std::sqrt(covariance(stereo, 0)), 0.001407, 0.00005);
  EXPECT_GT(covariance(stereo, 2) / covariance(stereo, 0), 0.5) << "a window's";
  EXPECT_NEAR(covariance(stereo, 9) / covariance(stereo, 0), 0.0, 0.1);

  const DepthImage structured = measured(world, Noise::Structured, none, 4);
  const double white = 0.0001 * 0.64 / 0.36, ripple = 0.0001 / std::sqrt(2.0);
  EXPECT_NEAR(covariance(structured, 0), white * white + ripple * ripple, 2e-9);
  EXPECT_NEAR(covariance(structured, 8), ripple * ripple, 5e-10) << "a period";
  EXPECT_NEAR(covariance(structured, 4), -ripple * ripple, 5e-10) << "half of it";
}

TEST(DepthCameras, StereoHasStepsAndWholeMillimeters)
{
  const World world = tableFromAbove();
  const DepthImage image = measured(world, Noise::Stereo, {0.001, 0.02}, 5);
  for (const double depth : image.depth) {
    ASSERT_NEAR(1000.0 * depth, std::round(1000.0 * depth), 1e-9);
    const double steps = 32.0 * 525.0 * 0.05 / depth;
    const double of_a_step = 525.0 * 0.05 * 32.0 / std::round(steps);
    ASSERT_LE(std::abs(of_a_step - depth), 0.0005 + 1e-9);
  }
}

TEST(DepthCameras, StereoFattensWhatIsInFront)
{
  const World world = boxFromAbove();
  const View exact = look(world);
  const auto onTop = [](const View& view) {
    std::size_t count = 0;
    for (const Sight& sight : view.sights)
      count += sight.object == 1 && sight.face == 5;
    return static_cast<double>(count);
  };
  // The top is 150 pixels wide; half a window of 7 pixels is 3.
  const double top = 150.0 * 150.0;
  ASSERT_NEAR(onTop(exact), top, 0.02 * top);
  const double grown =
      onTop(measured(world, Noise::Stereo, {0.0, 0.02}, 6).view) - onTop(exact);
  EXPECT_GT(grown, 1.0 * 4 * 150);
  EXPECT_LE(grown, 3.2 * 4 * 153);
  EXPECT_EQ(onTop(measured(world, Noise::TimeOfFlight, {0.0, 0.02}, 6).view),
            onTop(exact));
}

TEST(DepthCameras, PixelsFlyBesideOutlinesOfTimeOfFlight)
{
  const World world = boxFromAbove();
  const auto outline = dilated(silhouettes(world, look(world)), 640, 480, 2.0);
  const auto flying = [&](Noise camera, bool elsewhere) {
    const DepthImage image = measured(world, camera, {0.0, 0.02}, 7);
    std::size_t count = 0;
    for (std::size_t i = 0; i < image.depth.size(); ++i)
      count += image.depth[i] > 0.72 && image.depth[i] < 0.78 &&
               (outline[i] == 0) == elsewhere;
    return count;
  };
  EXPECT_GT(flying(Noise::TimeOfFlight, false), 300U);
  EXPECT_EQ(flying(Noise::TimeOfFlight, true), 0U);
  EXPECT_EQ(flying(Noise::Structured, false), 0U);
  EXPECT_EQ(flying(Noise::Stereo, false), 0U);
}

TEST(DepthCameras, StructuredLightHasAShadowAndLosesOutlines)
{
  const World world = boxFromAbove();
  const DepthImage image = measured(world, Noise::Structured, {0.0, 0.02}, 8);
  const auto outline = silhouettes(world, image.view);
  std::size_t left = 0, right = 0;
  for (std::size_t i = 0; i < image.depth.size(); ++i) {
    const bool is_lost = std::isnan(image.depth[i]);
    ASSERT_TRUE(!outline[i] || is_lost);
    (i % 640 < 320 ? left : right) += is_lost;
  }
  // The projector, 10 cm to the right, throws a shadow of 10 / 70 of 10 cm and more to
  // the left: (0.1 + 0.1) / 0.7 * 0.1 instead of 0.1 / 0.7 * 0.1, which the box hides.
  EXPECT_GT(left, right + 1000U);
}

TEST(DepthCameras, ScenesHaveRandomWavesOrThoseAskedFor)
{
  SceneOptions options;
  options.noise = Noise::Stereo;
  double min_sigma = 1.0, max_sigma = 0.0, min_length = 1.0, max_length = 0.0;
  for (options.seed = 1; options.seed <= 40; ++options.seed) {
    const Waviness waves = wavinessOf(options);
    min_sigma = std::min(min_sigma, waves.sigma);
    max_sigma = std::max(max_sigma, waves.sigma);
    min_length = std::min(min_length, waves.length);
    max_length = std::max(max_length, waves.length);
  }
  EXPECT_GE(min_sigma, 0.0005);
  EXPECT_LT(min_sigma, 0.001);
  EXPECT_LE(max_sigma, 0.003);
  EXPECT_GT(max_sigma, 0.0025);
  EXPECT_GE(min_length, 0.01);
  EXPECT_LE(max_length, 0.06);
  EXPECT_GT(max_length, 2.0 * min_length);
  options.waviness = Waviness{0.004, 0.05};
  EXPECT_EQ(wavinessOf(options).sigma, 0.004);
  options.waviness = std::nullopt;
  options.noise = Noise::Structured;
  EXPECT_EQ(wavinessOf(options).sigma, 0.0);
}

TEST(DepthCameras, ScenesOfPartsHaveTruth)
{
  SceneOptions options;
  options.width = 320;
  options.height = 240;
  options.shapes = {Shape::Part};
  options.objects = 2;
  options.seed = 4;
  options.noise = Noise::None;
  const Scene exact = generateScene(options);
  std::size_t on_parts = 0, creases = 0, curved = 0;
  for (std::size_t i = 0; i < exact.surface.size(); ++i) {
    on_parts += exact.instance[i] > 0;
    creases += exact.edge[i] == EdgeCrease;
    curved += exact.surface[i] == SurfaceCurved;
  }
  EXPECT_GT(on_parts, 3000U);
  EXPECT_GT(creases, 500U);
  EXPECT_GT(curved, 100U);
  EXPECT_TRUE(exact.objects.front().touches.empty());
  for (const Noise camera : {Noise::Stereo, Noise::TimeOfFlight, Noise::Structured}) {
    options.noise = camera;
    const Scene a = generateScene(options), b = generateScene(options);
    EXPECT_EQ(a.edge, b.edge);
    std::size_t same_class = 0, both = 0;
    for (std::size_t i = 0; i < a.surface.size(); ++i) {
      ASSERT_TRUE(a.xyz[3 * i] == b.xyz[3 * i] || std::isnan(a.xyz[3 * i]));
      if (a.surface[i] == SurfaceVoid || exact.surface[i] == SurfaceVoid)
        continue;
      ++both;
      same_class += a.surface[i] == exact.surface[i];
    }
    EXPECT_GT(both, 40000U);
    EXPECT_GT(same_class, both - both / 50);
  }
}

TEST(DepthCameras, SameOnEveryMachine)
{
  SceneOptions options;
  options.seed = 9;
  options.width = 160;
  options.height = 120;
  options.shapes = {Shape::Part};
  options.objects = 2;
  const std::uint64_t expected[] = {
      0x8f32e840435ca9dbULL, 0x38dfde810e63f9a2ULL, 0x24aa2c5f3c0aff4fULL};
  const Noise cameras[] = {Noise::Stereo, Noise::TimeOfFlight, Noise::Structured};
  for (int i = 0; i < 3; ++i) {
    options.noise = cameras[i];
    EXPECT_EQ(pcl_shape_test::checksum(generateScene(options)), expected[i]) << i;
  }
}

TEST(DepthCameras, BadWaves)
{
  SceneOptions options;
  options.noise = Noise::Stereo;
  for (const Waviness& waves : {Waviness{0.02, 0.02}, Waviness{0.001, 1.0}}) {
    options.waviness = waves;
    EXPECT_THROW(generateScene(options), std::invalid_argument);
  }
}
