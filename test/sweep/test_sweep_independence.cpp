// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What a result must not depend on: pose, order, signs, threads, far points.

#include "support/differences.h"
#include "support/kernel_targets.h"
#include "support/shapes.h"
#include "support/sweep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <numeric>

namespace {

using namespace pcl;
using namespace pcl::test;

constexpr double radius = 0.025;

std::vector<float>
inadOf(const Surface& cloud, const NeighborhoodSize& size, unsigned threads = 0)
{
  NeighborhoodSweep sweep(cloud.points());
  sweep.setNumberOfThreads(threads);
  const auto normals = sweptNormals(sweep, size);
  return sweptINAD(sweep, size, {normals.data(), 4, cloud.size()});
}

std::vector<float>
inadOf(const Surface& cloud)
{
  return inadOf(cloud, NeighborhoodSize::ofRadius(radius));
}

/** \brief Counts over 10 x 10 bins of (mu, sigma) in [0, pi/2]. */
std::vector<double>
histogramOf(const std::vector<float>& inad)
{
  std::vector<double> bins(100);
  const auto binOf = [](float angle) {
    return static_cast<std::size_t>(std::min(9.0, angle * 20 / pi));
  };
  for (std::size_t i = 0; i < inad.size(); i += 2)
    if (!std::isnan(inad[i]))
      bins[10 * binOf(inad[i]) + binOf(inad[i + 1])] += 1;
  return bins;
}

double
movedMass(const std::vector<float>& a, const std::vector<float>& b)
{
  const auto p = histogramOf(a), q = histogramOf(b);
  double moved = 0;
  for (std::size_t i = 0; i < p.size(); ++i)
    moved += std::abs(p[i] - q[i]) / 2;
  return moved / std::accumulate(p.begin(), p.end(), 0.0);
}

class SweepIndependence : public testing::TestWithParam<std::string> {
protected:
  SweepIndependence()
  {
    Random random(7);
    scene_ = mixedScene(24000, random); // about as dense as a depth camera's
    scene_.addNoise(0.0005, random);
  }

  void
  expectInvariant(const Eigen::Isometry3d& pose, double share) const
  {
    Surface moved = scene_;
    moved.move(pose);
    const auto before = inadOf(scene_), after = inadOf(moved);
    Differences differences;
    differences.add(before, after);
    EXPECT_GT(differences.known(), scene_.size());
    EXPECT_GE(differences.within(1e-3), share);
    EXPECT_LT(movedMass(before, after), 0.01);
  }

  ForcedTarget target_{GetParam()};
  Surface scene_;
};

TEST_P(SweepIndependence, RotationAndTranslationOfOneMetre)
{
  const auto axis = Eigen::Vector3d(1, -2, 0.5).normalized();
  const auto away = Eigen::Vector3d(-0.6, 0.64, 0.48);
  for (const double angle : {0.3, 1.6, 3.0})
    expectInvariant(Eigen::Translation3d(away) * Eigen::AngleAxisd(angle, axis), 0.999);
}

TEST_P(SweepIndependence, TranslationOfTenMetres)
{
  expectInvariant(Eigen::Isometry3d(Eigen::Translation3d(6.4, -6, 4.8)), 0.995);
}

TEST_P(SweepIndependence, OrderOfThePoints)
{
  std::vector<std::size_t> order(scene_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  Random random(8);
  for (std::size_t i = order.size() - 1; i > 0; --i)
    std::swap(order[i], order[random.index(i + 1)]);
  Surface shuffled;
  for (const std::size_t i : order)
    shuffled.add({scene_.position(i), scene_.normal(i)});
  const auto before = inadOf(scene_), after = inadOf(shuffled);
  Differences differences;
  for (std::size_t i = 0; i < order.size(); ++i) {
    differences.add(before[2 * order[i]], after[2 * i]);
    differences.add(before[2 * order[i] + 1], after[2 * i + 1]);
  }
  EXPECT_GE(differences.within(1e-5), 0.999);
}

/** \brief Many points have an x in common: what is summed one after the other must not
 * follow the order in which they are given. */
TEST_P(SweepIndependence, OrderOfPointsOfEqualX)
{
  Surface sheets, reversed;
  for (std::size_t i = 0; i < scene_.size(); ++i) {
    Eigen::Vector3d position = scene_.position(i);
    position.x() = std::round(position.x() * 512) / 512;
    sheets.add({position, scene_.normal(i)});
  }
  for (std::size_t i = sheets.size(); i-- > 0;)
    reversed.add({sheets.position(i), sheets.normal(i)});
  const auto size = NeighborhoodSize::ofRadius(radius);
  const auto before = sweptNormals(NeighborhoodSweep(sheets.points()), size);
  const auto after = sweptNormals(NeighborhoodSweep(reversed.points()), size);
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    const float* expected = &before[4 * i];
    const float* result = &after[4 * (sheets.size() - 1 - i)];
    ASSERT_EQ(0, std::memcmp(expected, result, 4 * sizeof(float))) << i;
  }
}

TEST_P(SweepIndependence, SignsOfTheNormals)
{
  Surface flipped = scene_;
  Random random(9);
  for (std::size_t i = 0; i < flipped.size(); ++i) {
    const float sign = random.uniform() < 0.5 ? -1.0f : 1.0f;
    for (std::size_t axis = 0; axis < 3; ++axis)
      flipped.normals[3 * i + axis] *= sign;
  }
  const NeighborhoodSweep sweep(scene_.points());
  const auto size = NeighborhoodSize::ofRadius(radius);
  Differences differences;
  differences.add(sweptINAD(sweep, size, scene_.trueNormals()),
                  sweptINAD(sweep, size, flipped.trueNormals()));
  EXPECT_GE(differences.within(1e-5), 0.999);
}

TEST_P(SweepIndependence, LengthsOfTheNormals)
{
  Surface scaled = scene_;
  for (std::size_t i = 0; i < scaled.normals.size(); ++i)
    scaled.normals[i] *= i / 3 % 2 == 0 ? 1000.0f : 0.001f;
  const NeighborhoodSweep sweep(scene_.points());
  const auto size = NeighborhoodSize::ofRadius(radius);
  Differences differences;
  differences.add(sweptINAD(sweep, size, scene_.trueNormals()),
                  sweptINAD(sweep, size, scaled.trueNormals()));
  EXPECT_GE(differences.within(1e-5), 0.999);
}

/** \brief A tile with a halo equals the whole, to the bit. */
TEST_P(SweepIndependence, PointsFurtherAwayThanTwoRadii)
{
  std::vector<std::size_t> inside;
  Surface tile;
  const double left = scene_.position(0).x(), halo = 2.001 * radius;
  for (std::size_t i = 0; i < scene_.size(); ++i) {
    const double x = scene_.position(i).x();
    if (x < left + halo) {
      inside.push_back(x < left ? i : scene_.size());
      tile.add({scene_.position(i), scene_.normal(i)});
    }
  }
  ASSERT_LT(tile.size(), scene_.size());
  const auto whole = inadOf(scene_), part = inadOf(tile);
  for (std::size_t i = 0; i < inside.size(); ++i)
    if (inside[i] < scene_.size()) {
      ASSERT_EQ(0, std::memcmp(&whole[2 * inside[i]], &part[2 * i], 2 * sizeof(float)));
    }
}

TEST_P(SweepIndependence, NumberOfThreads)
{
  Random random(10);
  Surface large = mixedScene(102000, random);
  large.addNoise(0.0005, random);
  ASSERT_GE(large.size(), 100000U);
  for (const auto& size :
       {NeighborhoodSize::ofRadius(0.006), NeighborhoodSize::ofNearest(40)}) {
    const auto expected = inadOf(large, size, 1);
    for (const unsigned threads : {2U, 4U}) {
      const auto result = inadOf(large, size, threads);
      ASSERT_EQ(expected.size(), result.size());
      EXPECT_EQ(
          0,
          std::memcmp(expected.data(), result.data(), expected.size() * sizeof(float)))
          << threads << " threads";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Targets,
                         SweepIndependence,
                         testing::ValuesIn(kernelTargets()),
                         TargetName());

} // namespace
