// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The largest and the smallest coordinates and sizes that the sweep takes.

#include "support/kernel_targets.h"
#include "support/random.h"
#include "support/shapes.h"
#include "support/sweep.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace {

using namespace pcl;
using namespace pcl::test;

class SweepLimits : public testing::TestWithParam<std::string> {
protected:
  ForcedTarget target_{GetParam()};
  Random random_{3};
};

void
expectNothingRejected(const Surface& cloud, const NeighborhoodSize& size)
{
  const NeighborhoodSweep sweep(cloud.points());
  const auto all = sweptINAD(sweep, size, cloud.trueNormals(), 0.0);
  constexpr double most = std::numeric_limits<double>::max();
  EXPECT_EQ(all, sweptINAD(sweep, size, cloud.trueNormals(), most));
  for (const float value : all)
    EXPECT_GE(value, 0.0f);
}

TEST_P(SweepLimits, TheLargestOutlierRateRejectsNothing)
{
  // Without any deviation, the range is of 0 times infinity.
  Surface cloud = plane(3000, 0.1, random_);
  expectNothingRejected(cloud, NeighborhoodSize::ofNearest(6));
  expectNothingRejected(cloud, NeighborhoodSize::ofRadius(0.01));
  for (float& value : cloud.normals)
    value = static_cast<float>(random_.uniform(-1, 1));
  expectNothingRejected(cloud, NeighborhoodSize::ofNearest(6));
  expectNothingRejected(cloud, NeighborhoodSize::ofRadius(0.01));
}

TEST_P(SweepLimits, ARadiusWhoseSquareIsZeroFindsNothing)
{
  const Surface cloud = plane(100, 0.1, random_);
  const NeighborhoodSweep sweep(cloud.points());
  EXPECT_EQ(std::vector<std::uint32_t>(cloud.size(), 0),
            sweptCounts(sweep, NeighborhoodSize::ofRadius(1e-300)));
}

TEST_P(SweepLimits, TheLargestCoordinatesFindThoseInTheSamePlace)
{
  constexpr float large = 3e38f;
  std::vector<float> xyz;
  std::vector<std::uint32_t> expected;
  for (std::uint32_t place = 0; place < 27; ++place) {
    const std::uint32_t others = place % 5;
    for (std::uint32_t i = 0; i <= others; ++i) {
      for (const std::uint32_t digit : {place % 3, place / 3 % 3, place / 9})
        xyz.push_back(large * (static_cast<float>(digit) - 1.0f));
      expected.push_back(others);
    }
  }
  const NeighborhoodSweep sweep({xyz.data(), 3, expected.size()});
  for (const double radius : {1e-3, 1.0, 1e10, 1e30}) {
    EXPECT_EQ(expected, sweptCounts(sweep, NeighborhoodSize::ofRadius(radius)))
        << radius;
  }
}

TEST_P(SweepLimits, AFarPointReachesAllOthers)
{
  // More cells away than cells are numbered.
  constexpr std::uint32_t others = 2000;
  for (const float far : {1e8f, -1e9f, 1e12f, -1e12f}) {
    std::vector<float> xyz(3 * others);
    for (float& coordinate : xyz)
      coordinate = static_cast<float>(random_.uniform(0, 1));
    xyz.insert(xyz.end(), {0.0f, far, far});
    std::vector<float> radii(others, 0.02f);
    radii.push_back(2.0f * std::abs(far));
    const NeighborhoodSweep sweep({xyz.data(), 3, others + 1});
    EXPECT_EQ(others,
              sweptCounts(sweep, NeighborhoodSize::ofRadii(radii.data())).back())
        << far;
  }
}

TEST_P(SweepLimits, OnlyNeighborsBesideALineMakeASurface)
{
  constexpr double radius = 0.012, beside = 0.006;
  Surface cloud;
  const auto at = [](int i) { return 0.002 * i; };
  for (int i = 0; i < 64; ++i)
    cloud.add({{at(i), 0, 0}, {0, 0, 1}});
  cloud.add({{at(20), beside, 0}, {0, 0, 1}});
  const NeighborhoodSweep sweep(cloud.points());
  const auto inad =
      sweptINAD(sweep, NeighborhoodSize::ofRadius(radius), cloud.trueNormals(), 0.0);
  for (int i = 0; i < 64; ++i) {
    const bool is_surface = std::hypot(at(i) - at(20), beside) < radius;
    EXPECT_EQ(is_surface, !std::isnan(inad[static_cast<std::size_t>(2 * i)])) << i;
  }
}

TEST_P(SweepLimits, AnEquallyFarPointThatIsNotANeighborChangesNothing)
{
  // The 10th of the nearest is as far as can be below a power of 4, of which units are
  // a fraction.
  const float edge2 = std::nextafter(0.25f, 0.0f), x = std::nextafter(0.5f, 0.0f);
  float y = 1e-4f;
  while (x * x + y * y < edge2)
    y = std::nextafter(y, 1.0f);
  ASSERT_EQ(edge2, x * x + y * y);
  Surface cloud;
  cloud.add({{0, 0, 0}, {0, 0, 1}});
  for (int i = 0; i < 8; ++i) {
    const double of[] = {random_.uniform(-0.3, 0.3), random_.uniform(-0.3, 0.3)};
    cloud.add({{of[0], of[1], random_.uniform(-0.1, 0.1)}, {0, 0, 1}});
  }
  cloud.add({{x, y, 0}, {0, 0, 1}});
  const auto normalOfFirst = [&] {
    const NeighborhoodSweep sweep(cloud.points());
    auto normals = sweptNormals(sweep, NeighborhoodSize::ofNearest(10));
    normals.resize(4);
    return normals;
  };
  const auto alone = normalOfFirst();
  cloud.add({{-x, -y, 0}, {0, 0, 1}});
  EXPECT_EQ(alone, normalOfFirst());
}

TEST_P(SweepLimits, OfNoQueriesAllResultsAreFinite)
{
  const Surface cloud = plane(100, 0.1, random_);
  const std::int32_t none = 0;
  NeighborhoodSweep sweep(cloud.points());
  sweep.setQueryIndices(&none, 0);
  const auto size = NeighborhoodSize::ofRadius(0.05);
  float unused[4] = {};
  EXPECT_TRUE(sweep.computeNormals(size, unused, unused, 4));
  EXPECT_TRUE(sweep.computeINAD(size, cloud.trueNormals(), 2.0, unused));
}

INSTANTIATE_TEST_SUITE_P(Targets,
                         SweepLimits,
                         testing::ValuesIn(kernelTargets()),
                         TargetName());

} // namespace
