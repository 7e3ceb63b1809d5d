// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Radii that grow with depth or density, and the default models.

#include "features/noise/edge_radii.h"
#include "features/noise/noise_level.h"
#include "support/clouds.h"
#include "support/errors.h"

#include <pcl/common/angles.h>
#include <pcl/features/cloud_numbers.h>
#include <pcl/features/inad.h>
#include <pcl/features/normal_3d_sweep.h>
#include <pcl/features/shape_model.h>
#include <pcl/search/kdtree.h>
#include <pcl/features/impl/neighborhoods.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace {

using namespace pcl;
using namespace pcl::test;
using Cloud = PointCloud<PointXYZ>;
using Normals = PointCloud<Normal>;

template <typename Mode>
std::vector<float>
inadOf(const Cloud::Ptr& cloud,
       double radius,
       Mode mode,
       const search::Search<PointXYZ>::Ptr& search = nullptr)
{
  NormalEstimationSweep<PointXYZ, Normal> normal_estimation;
  normal_estimation.setInputCloud(cloud);
  normal_estimation.setRadiusSearch(radius);
  normal_estimation.setRadiusMode(mode);
  normal_estimation.setSearchMethod(search);
  const auto normals = make_shared<Normals>();
  normal_estimation.compute(*normals);
  INADEstimation<PointXYZ, Normal> estimation;
  estimation.setInputCloud(cloud);
  estimation.setInputNormals(normals);
  estimation.setRadiusSearch(radius);
  estimation.setRadiusMode(mode);
  estimation.setSearchMethod(search);
  PointCloud<INAD> inad;
  estimation.compute(inad);
  return valuesOf(inad);
}

Surface
noisyFold(double sigma)
{
  Random random(41);
  Surface surface = dihedral(6000, 120, 0.16, random);
  surface.addNoise(sigma, random);
  return surface;
}

Cloud::Ptr
scaled(const Cloud& cloud, float factor)
{
  const auto result = make_shared<Cloud>(cloud);
  for (PointXYZ& point : *result)
    point.getVector3fMap() *= factor;
  return result;
}

TEST(AdaptiveRadius, DepthGrowsTheRadiusBeyond80Centimetres)
{
  using Estimation = INADEstimation<PointXYZ, Normal>;
  const auto cloud = toCloud<PointXYZ>(noisyFold(0.001));
  for (const float z : {0.5f, 1.6f}) {
    for (PointXYZ& point : *cloud)
      point.z = z; // one depth: one radius
    const double radius = 0.01 * std::max(1.0f, z / 0.8f);
    EXPECT_TRUE(sameBits(inadOf(cloud, radius, Estimation::FIXED),
                         inadOf(cloud, 0.01, Estimation::DEPTH)));
  }
}

TEST(AdaptiveRadius, DensityDoesNotKnowTheUnit)
{
  using Estimation = INADEstimation<PointXYZ, Normal>;
  const auto cloud = toCloud<PointXYZ>(noisyFold(0.001));
  const auto meters = inadOf(cloud, 3.0, Estimation::DENSITY);
  // Powers of two are exact in float: not a bit may change.
  EXPECT_TRUE(sameBits(meters, inadOf(scaled(*cloud, 1024), 3.0, Estimation::DENSITY)));
  EXPECT_TRUE(
      sameBits(meters, inadOf(scaled(*cloud, 1 / 128.0f), 3.0, Estimation::DENSITY)));
  EXPECT_FALSE(sameBits(meters, inadOf(cloud, 3.5, Estimation::DENSITY)));
}

TEST(AdaptiveRadius, WhatNoFloatCanBeReachesAllPointsOrNone)
{
  using Estimation = INADEstimation<PointXYZ, Normal>;
  const auto cloud = toCloud<PointXYZ>(noisyFold(0.001));
  const auto all = inadOf(cloud, 1e6, Estimation::DENSITY);
  for (const auto mode : {Estimation::DEPTH, Estimation::DENSITY}) {
    EXPECT_TRUE(sameBits(all, inadOf(cloud, 1e300, mode)));
    const auto none = inadOf(cloud, 1e-300, mode);
    EXPECT_TRUE(
        std::all_of(none.begin(), none.end(), [](float v) { return std::isnan(v); }));
  }
}

TEST(AdaptiveRadius, ASearchMethodFindsTheSameNeighbors)
{
  using Estimation = INADEstimation<PointXYZ, Normal>;
  const auto cloud = toCloud<PointXYZ>(noisyFold(0.001));
  const auto tree = make_shared<search::KdTree<PointXYZ>>();
  const auto swept = inadOf(cloud, 3.0, Estimation::DENSITY);
  const auto listed = inadOf(cloud, 3.0, Estimation::DENSITY, tree);
  std::size_t same = 0;
  for (std::size_t i = 0; i < swept.size(); ++i)
    same += std::abs(swept[i] - listed[i]) <= 1e-5f ? 1 : 0;
  EXPECT_GE(static_cast<double>(same), 0.999 * static_cast<double>(swept.size()));
}

TEST(AdaptiveRadius, TheSpacingIsTheDistanceToThe12thNeighborSoftened)
{
  // d12 / median: 1, 0.01 (an outlier), 100 (a hole), unknown.
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  const auto spacings = detail::spacingsOf({2.0f, 2.0f, 2.0f, 0.02f, 200.0f, nan});
  EXPECT_FLOAT_EQ(2.0f, spacings[0]);
  EXPECT_FLOAT_EQ(2.0f * std::sqrt(0.6f), spacings[3]);
  EXPECT_FLOAT_EQ(2.0f * std::sqrt(3.0f), spacings[4]);
  EXPECT_FLOAT_EQ(2.0f, spacings[5]);
}

TEST(AdaptiveRadius, SomePointsTellHowManyAreUnknown)
{
  // A plane, and as many points on lines so far apart that none of them has a normal.
  constexpr int side = 100;
  constexpr float step = 0.01f, apart = 0.5f;
  Surface surface;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      for (const float row : {step, apart})
        surface.xyz.insert(surface.xyz.end(),
                           {step * static_cast<float>(x),
                            row * static_cast<float>(y),
                            row == step ? 0.0f : 10.0f});
  const detail::Neighborhoods neighborhoods(surface.points(), 2);
  const auto spacings = detail::localSpacings(neighborhoods);
  const auto share = [&](std::size_t points) {
    return detail::shareUnknown(neighborhoods, spacings, points, 0.0, 2);
  };
  EXPECT_EQ(0.5, share(surface.size()));
  EXPECT_NEAR(0.5, share(1000), 5.0 * std::sqrt(0.25 / 1000.0)); // deviations
  EXPECT_EQ(0.0, share(0));
}

TEST(AdaptiveRadius, NoiseIsMeasuredInSpacings)
{
  const auto noise = [](double sigma) {
    const Surface fold = noisyFold(sigma);
    const detail::Neighborhoods neighborhoods(fold.points(), 1);
    return detail::noiseOf(neighborhoods, detail::localSpacings(neighborhoods));
  };
  EXPECT_LT(noise(0.0), 1e-4);
  // 6000 points on 2 x 0.16 x 0.16 m: d is about 2 * 2.9 mm.
  const double d = 2.0 * std::sqrt(2.0 * 0.16 * 0.16 / 6000.0);
  EXPECT_NEAR(1.55 * 0.0004 / d, noise(0.0004), 0.3 * 1.55 * 0.0004 / d);
  EXPECT_NEAR(2.0, noise(0.0008) / noise(0.0004), 0.2);
  EXPECT_EQ(0.3, noise(0.01));
}

/** The noise of a cloud, and its level and color. */
std::pair<double, detail::NoiseLevel>
noiseOfCloud(const Surface& surface)
{
  const detail::Neighborhoods neighborhoods(surface.points(), 1);
  const std::vector<float> spacings = detail::localSpacings(neighborhoods);
  const double noise = detail::noiseOf(neighborhoods, spacings);
  return {noise, detail::noiseLevelOf(neighborhoods, spacings, noise, 1)};
}

/** The noise and the noise level of a cloud. */
std::pair<double, double>
noiseAndLevelOf(const Surface& surface)
{
  const auto [noise, level] = noiseOfCloud(surface);
  return {noise, level.level};
}

TEST(AdaptiveRadius, WhiteNoiseNeedsSmallRadii)
{
  EXPECT_EQ(0.0, noiseAndLevelOf(noisyFold(0.0)).second);
  const double d = 2.0 * std::sqrt(2.0 * 0.16 * 0.16 / 6000.0);
  const auto [some, level_of_some] = noiseAndLevelOf(noisyFold(0.05 * d));
  EXPECT_GT(some, 0.05);
  EXPECT_LT(level_of_some, 0.25 * some);
  const auto [more, level_of_more] = noiseAndLevelOf(noisyFold(0.16 * d));
  EXPECT_GT(more, 0.2);
  EXPECT_GT(level_of_more, 0.02);
  EXPECT_LT(level_of_more, 0.5 * more);
}

TEST(AdaptiveRadius, CurvatureIsNotTakenForNoiseThatNeighborsShare)
{
  // A sphere of 35 spacings: its normals differ by more within larger radii.
  Random random(43);
  Surface surface = sampled(60000, random, [](Random& any) {
    const Eigen::Vector3d n =
        Eigen::Vector3d(any.normal(), any.normal(), any.normal()).normalized();
    return SurfacePoint{0.1 * n, n};
  });
  const double d = 2.0 * std::sqrt(4.0 * pi * 0.01 / 60000.0);
  surface.addNoise(0.07 * d, random);
  const auto [noise, level] = noiseOfCloud(surface);
  EXPECT_EQ(0.0, level.correlation);
  EXPECT_LT(level.level, noise);
}

TEST(AdaptiveRadius, NoiseThatNeighborsShareNeedsRadiiOfItsSize)
{
  // Waves of six spacings: they tilt small neighborhoods without becoming less.
  Surface surface = noisyFold(0.0);
  const double d = 2.0 * std::sqrt(2.0 * 0.16 * 0.16 / 6000.0);
  for (std::size_t i = 0; i < surface.size(); ++i) {
    const Eigen::Vector3d p = surface.position(i), n = surface.normal(i);
    const double wave =
        std::sin(p.x() * pi / (3.0 * d)) * std::sin(p.y() * pi / (3.0 * d));
    for (std::size_t axis = 0; axis < 3; ++axis)
      surface.xyz[3 * i + axis] +=
          static_cast<float>(0.5 * d * wave * n[static_cast<Eigen::Index>(axis)]);
  }
  const auto [noise, level] = noiseAndLevelOf(surface);
  EXPECT_GT(noise, 0.05);
  EXPECT_EQ(noise, level);
}

/** A tilted plane whose depth has steps, each as wide as some spacings. */
Surface
planeOfSteps(double width)
{
  constexpr double slope = 0.5, spacing = 0.0015;
  Random random(44);
  Surface surface;
  for (int y = 0; y < 120; ++y)
    for (int x = 0; x < 120; ++x) {
      const double u = spacing * (x + random.uniform(-0.3, 0.3));
      const double v = spacing * (y + random.uniform(-0.3, 0.3));
      const double step = slope * width * spacing;
      surface.add({{u, v, step * std::round(slope * u / step)}, {0, 0, 1}});
    }
  return surface;
}

TEST(AdaptiveRadius, StepsOfASensorAreBeyondRadii)
{
  const auto isBeyondRadii = [](const Surface& surface) {
    return noiseOfCloud(surface).second.isBeyondRadii();
  };
  EXPECT_FALSE(isBeyondRadii(planeOfSteps(1e-6)));
  EXPECT_TRUE(isBeyondRadii(planeOfSteps(6.0)));
  EXPECT_TRUE(isBeyondRadii(planeOfSteps(8.0)));
  EXPECT_TRUE(isBeyondRadii(planeOfSteps(12.0)));
  // Stairs that are higher than neighborhoods, edges and curvature are not.
  EXPECT_FALSE(isBeyondRadii(planeOfSteps(24.0)));
  EXPECT_FALSE(isBeyondRadii(noisyFold(0.0)));
  Random random(43);
  EXPECT_FALSE(isBeyondRadii(sampled(60000, random, [](Random& any) {
    const Eigen::Vector3d n =
        Eigen::Vector3d(any.normal(), any.normal(), any.normal()).normalized();
    return SurfacePoint{0.1 * n, n};
  })));
}

TEST(AdaptiveRadius, RadiiWhoseSquaresAreZeroHaveNoNoiseLevel)
{
  const Surface surface = noisyFold(0.001);
  const detail::Neighborhoods neighborhoods(surface.points(), 1);
  const std::vector<float> spacings(surface.size(), 1e-30f);
  const detail::NoiseLevel level =
      detail::noiseLevelOf(neighborhoods, spacings, 0.2, 1);
  EXPECT_EQ(0.0, level.level);
  EXPECT_EQ(0.0, level.correlation);
}

/** How far normals differ at each level, in degrees, where neither wide steps nor thin
 * plates are. */
NoiseMeasures
anglesOf(const std::array<double, 8>& degrees)
{
  NoiseMeasures measures;
  for (std::size_t level = 0; level < degrees.size(); ++level)
    measures.angles[level] = {static_cast<float>(pcl::deg2rad(degrees[level]))};
  return measures;
}

TEST(AdaptiveRadius, NormalsThatAreNeverStableAreBeyondRadii)
{
  // Neighbors share their noise: a stereo camera's, a Kinect's, and a curved surface.
  const auto stereo = anglesOf({7.2, 5.6, 5.3, 5.0, 4.6, 4.2, 3.7, 3.4});
  const auto kinect = anglesOf({5.4, 3.4, 3.0, 2.6, 2.1, 1.8, 1.4, 1.1});
  const auto curved = anglesOf({6.0, 6.4, 6.7, 7.0, 7.4, 7.1, 7.6, 7.4});
  EXPECT_TRUE(detail::noiseLevelOf(0.27, stereo).isBeyondRadii());
  EXPECT_FALSE(detail::noiseLevelOf(0.2, kinect).isBeyondRadii());
  EXPECT_FALSE(detail::noiseLevelOf(0.2, curved).isBeyondRadii());
}

TEST(AdaptiveRadius, WhiteNoiseAmongCrowdedCreasesHasTheMostStableRadii)
{
  const auto crowded = anglesOf({5.2, 2.6, 3.5, 5.0, 6.7, 7.4, 6.4, 5.9});
  EXPECT_EQ(0.05, detail::noiseLevelOf(0.28, crowded).level);
  // Noise that only grows less: as far as the noise says.
  const auto strong = anglesOf({20.0, 10.0, 7.6, 6.2, 5.0, 4.2, 3.6, 3.2});
  EXPECT_EQ(0.3, detail::noiseLevelOf(0.3, strong).level);
}

TEST(DefaultModels, AreThereAndSeparateTheirClasses)
{
  const ShapeModel& edges = ShapeModel::defaultEdges();
  const ShapeModel& surfaces = ShapeModel::defaultSurfaces();
  ASSERT_EQ(2U, edges.classes().size());
  EXPECT_EQ("edge", edges.classes()[0].name);
  EXPECT_EQ("planar", surfaces.classes()[0].name);
  EXPECT_EQ("curved", surfaces.classes()[1].name);
  EXPECT_EQ(AdaptiveRadius::DENSITY, edges.parameters().radius_mode);
  using namespace detail::edge_radii;
  EXPECT_EQ(normal_radius, edges.parameters().normal_radius);
  EXPECT_EQ(normal_radius_noise, edges.parameters().normal_radius_noise);
  EXPECT_EQ(inad_radius, edges.parameters().radius);
  EXPECT_EQ(inad_radius_noise, edges.parameters().radius_noise);
  float values[2];
  edges.evaluate({0.4f, 0.3f}, values);
  EXPECT_GT(values[0], 0.9f);
  surfaces.evaluate({0.01f, 0.01f}, values);
  EXPECT_GT(values[0], 0.9f);
}

TEST(ModelScale, ParametersAreChecked)
{
  INADParameters parameters;
  parameters.radius_noise = 1.0;
  expectParts(exceptionOf<BadArgumentException>([&] { ShapeModel model(parameters); }),
              {"grows by 1", "density mode"});
  parameters = {0.0, 0.0, 12, 2.0};
  parameters.radius_mode = AdaptiveRadius::DENSITY;
  expectParts(exceptionOf<BadArgumentException>([&] { ShapeModel model(parameters); }),
              {"k 12", "fixed"});
  ShapeModel model;
  expectParts(exceptionOf<BadArgumentException>([&] { model.setSmoothing(-1); }),
              {"smoothing -1", "0 to"});
  expectParts(model.disagreement(ShapeModel::defaultEdges().parameters()),
              {"radius mode", "noise"});
}

} // namespace
