// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Points and normals that are not finite, and arguments out of range.

#include "support/kernel_targets.h"
#include "support/shapes.h"
#include "support/sweep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace {

using namespace pcl;
using namespace pcl::test;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

struct Computed {
  bool normals_finite;
  bool inad_finite;
  std::vector<float> normals;
  std::vector<float> inad;
};

Computed
compute(const Surface& cloud, const NeighborhoodSize& size)
{
  const NeighborhoodSweep sweep(cloud.points());
  Computed result{{}, {}, std::vector<float>(4 * cloud.size()), {}};
  result.inad.resize(2 * cloud.size());
  float* const curvatures = result.normals.empty() ? nullptr : &result.normals[3];
  result.normals_finite =
      sweep.computeNormals(size, result.normals.data(), curvatures, 4);
  result.inad_finite =
      sweep.computeINAD(size, cloud.trueNormals(), 2.0, result.inad.data());
  return result;
}

class SweepBadInput : public testing::TestWithParam<std::string> {
protected:
  SweepBadInput() { plane_ = plane(1000, 0.1, random_); }

  void
  expectUnknown(const Surface& cloud, const NeighborhoodSize& size) const
  {
    const Computed result = compute(cloud, size);
    const auto isNaN = [](float value) { return std::isnan(value); };
    EXPECT_FALSE(result.normals_finite);
    EXPECT_FALSE(result.inad_finite);
    EXPECT_TRUE(std::all_of(result.normals.begin(), result.normals.end(), isNaN));
    EXPECT_TRUE(std::all_of(result.inad.begin(), result.inad.end(), isNaN));
  }

  ForcedTarget target_{GetParam()};
  Random random_{11};
  Surface plane_;
  NeighborhoodSize size_ = NeighborhoodSize::ofRadius(0.02);
};

/** \brief Bad points among good ones change nothing for the good ones. */
TEST_P(SweepBadInput, BadPointsAreAsIfTheyWereNotThere)
{
  const float extremes[][3] = {{nan, 0, 0},
                               {0, infinity, 0},
                               {0, 0, -infinity},
                               {1e6f, 1e6f, -1e6f},
                               {1e30f, -1e30f, 1e30f},
                               {3e38f, 0, 0}};
  Surface mixed;
  std::vector<std::size_t> good;
  for (std::size_t i = 0; i < plane_.size(); ++i) {
    good.push_back(mixed.size());
    mixed.add({plane_.position(i), plane_.normal(i)});
    const float* bad = extremes[i % 6];
    mixed.xyz.insert(mixed.xyz.end(), bad, bad + 3);
    mixed.normals.insert(mixed.normals.end(), {0, 0, 1});
  }
  const Computed clean = compute(plane_, size_), dirty = compute(mixed, size_);
  EXPECT_TRUE(clean.inad_finite);
  EXPECT_FALSE(dirty.inad_finite);
  EXPECT_FALSE(dirty.normals_finite);
  for (std::size_t i = 0; i < plane_.size(); ++i) {
    ASSERT_EQ(clean.inad[2 * i], dirty.inad[2 * good[i]]);
    ASSERT_EQ(clean.normals[4 * i], dirty.normals[4 * good[i]]);
  }
}

/** \brief Neighbors that are all at one place, but not where the query is. */
TEST_P(SweepBadInput, HeapsBesideAQueryAreUnknown)
{
  // A mean that is rounded would leave a variance here.
  const float place[] = {0.856247663f, 0.993506908f, -0.78467226f};
  const float query[] = {0.633670211f, -0.0947113633f, 0.18874526f};
  for (std::size_t count = 5; count < 125; ++count) {
    Surface heap;
    for (std::size_t i = 0; i < count; ++i)
      heap.xyz.insert(heap.xyz.end(), place, place + 3);
    NeighborhoodSweep sweep(heap.points());
    sweep.setQueries({query, 3, 1});
    for (const auto& size :
         {NeighborhoodSize::ofRadius(4.0), NeighborhoodSize::ofNearest(count)}) {
      std::vector<float> normal(4, 0.0f);
      EXPECT_FALSE(sweep.computeNormals(size, normal.data(), &normal[3], 4));
      EXPECT_TRUE(std::isnan(normal[0]) && std::isnan(normal[3])) << count;
    }
  }
}

TEST_P(SweepBadInput, FarOutliersAreUnknown)
{
  Surface cloud = plane_;
  for (const double far : {1e6, 1e30, -1e30})
    cloud.add({{far, far, far}, {0, 0, 1}});
  const Computed result = compute(cloud, size_);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    ASSERT_EQ(i >= plane_.size(), std::isnan(result.inad[2 * i])) << i;
    ASSERT_EQ(i >= plane_.size(), std::isnan(result.normals[4 * i])) << i;
  }
}

TEST_P(SweepBadInput, NearestPointsOfFarOutliersDoNotHang)
{
  Surface cloud = plane_;
  for (const double far : {1e6, 1e30, -1e30})
    cloud.add({{far, far, far}, {0, 0, 1}});
  const Computed result = compute(cloud, NeighborhoodSize::ofNearest(12));
  EXPECT_FALSE(std::isnan(result.inad[0]));
}

TEST_P(SweepBadInput, FewerThanFiveNeighbors)
{
  for (std::size_t count = 1; count <= 5; ++count)
    expectUnknown(plane(count, 0.01, random_), size_);
  const Computed six = compute(plane(6, 0.01, random_), size_);
  EXPECT_TRUE(six.normals_finite);
  EXPECT_TRUE(six.inad_finite);
}

TEST_P(SweepBadInput, FewerThanFiveOfTheNearest)
{
  expectUnknown(plane_, NeighborhoodSize::ofNearest(5));
  EXPECT_TRUE(compute(plane_, NeighborhoodSize::ofNearest(6)).inad_finite);
}

TEST_P(SweepBadInput, CoincidentPoints)
{
  Surface cloud;
  for (int i = 0; i < 40; ++i)
    cloud.add({{0.1, 0.2, 0.3}, {0, 0, 1}});
  expectUnknown(cloud, size_);
  expectUnknown(cloud, NeighborhoodSize::ofNearest(20));
}

TEST_P(SweepBadInput, CollinearPoints)
{
  Surface along, across;
  for (int i = 0; i < 40; ++i) {
    along.add({{0.1 * random_.uniform(), 0, 0}, {0, 0, 1}});
    across.add({random_.uniform() * Eigen::Vector3d(0.03, -0.02, 0.05), {0, 0, 1}});
  }
  expectUnknown(along, NeighborhoodSize::ofRadius(1));
  expectUnknown(across, NeighborhoodSize::ofRadius(1));
}

TEST_P(SweepBadInput, BadNormalsAreNotCounted)
{
  Surface cloud = plane_;
  cloud.normals[0] = nan;
  std::fill_n(&cloud.normals[3 * 7], 3, 0.0f);
  const Computed result = compute(cloud, size_);
  EXPECT_FALSE(result.inad_finite);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    ASSERT_EQ(i == 0 || i == 7, std::isnan(result.inad[2 * i])) << i;
}

TEST_P(SweepBadInput, NoPointAtAll)
{
  const Surface nothing;
  EXPECT_TRUE(compute(nothing, size_).inad.empty());
}

TEST_P(SweepBadInput, BadSizesAreRefused)
{
  for (const double radius : {0.0, -0.01, double{nan}, double{infinity}}) {
    EXPECT_THROW(compute(plane_, NeighborhoodSize::ofRadius(radius)),
                 std::invalid_argument)
        << radius;
  }
  EXPECT_THROW(compute(plane_, NeighborhoodSize::ofNearest(0)), std::invalid_argument);
  EXPECT_THROW(compute(plane_, NeighborhoodSize::ofNearest(plane_.size() + 1)),
               std::invalid_argument);
  EXPECT_THROW(compute(plane_, {0.01, nullptr, 5}), std::invalid_argument);
  std::vector<float> radii(plane_.size(), 0.02f);
  radii[3] = nan;
  EXPECT_THROW(compute(plane_, NeighborhoodSize::ofRadii(radii.data())),
               std::invalid_argument);
}

TEST_P(SweepBadInput, BadNormalsAndOutlierRatesAreRefused)
{
  const NeighborhoodSweep sweep(plane_.points());
  XYZView fewer = plane_.trueNormals();
  --fewer.size;
  EXPECT_THROW(sweptINAD(sweep, size_, fewer), std::invalid_argument);
  for (const double rate : {-1.0, double{nan}, double{infinity}}) {
    EXPECT_THROW(sweptINAD(sweep, size_, plane_.trueNormals(), rate),
                 std::invalid_argument)
        << rate;
  }
}

TEST_P(SweepBadInput, NoIndexIsNoQuery)
{
  NeighborhoodSweep sweep(plane_.points());
  sweep.setQueryIndices(nullptr, 0);
  EXPECT_EQ(sweep.size(), 0U);
  EXPECT_TRUE(sweptINAD(sweep, size_, plane_.trueNormals()).empty());
}

INSTANTIATE_TEST_SUITE_P(Targets,
                         SweepBadInput,
                         testing::ValuesIn(kernelTargets()),
                         TargetName());

} // namespace
