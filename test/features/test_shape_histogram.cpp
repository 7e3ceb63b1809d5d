// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Counting pairs of mu and sigma, likelihoods and densities.

#include "support/errors.h"

#include <pcl/exceptions.h>
#include <pcl/features/shape_histogram.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace {

using namespace pcl;
using namespace pcl::test;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

/** \brief 10 x 5 bins over 1 x 0.5 rad: a bin is 0.1 x 0.1 rad. */
ShapeHistogram
small()
{
  return ShapeHistogram(10, 5, 1.0, 0.5);
}

TEST(ShapeHistogram, DefaultsAreThePapers)
{
  const ShapeHistogram histogram;
  EXPECT_EQ(10U, histogram.muBins());
  EXPECT_EQ(10U, histogram.sigmaBins());
  EXPECT_DOUBLE_EQ(std::acos(0.0), histogram.muRange());
  EXPECT_DOUBLE_EQ(std::acos(0.0), histogram.sigmaRange());
  EXPECT_EQ(0U, histogram.total());
}

TEST(ShapeHistogram, PairsGoIntoTheirBins)
{
  ShapeHistogram histogram = small();
  histogram.add(INAD{0.0f, 0.0f});
  histogram.add(INAD{0.09f, 0.09f});
  histogram.add(INAD{0.55f, 0.21f});
  EXPECT_EQ(2U, histogram.count(0, 0));
  EXPECT_EQ(1U, histogram.count(5, 2));
  EXPECT_EQ(3U, histogram.total());
  EXPECT_EQ(2U, histogram.peak());
  EXPECT_EQ(0U, histogram.outside());
}

TEST(ShapeHistogram, LowerBoundsBelongToABinAndUpperOnesDoNot)
{
  ShapeHistogram histogram(4, 4, 1.0, 1.0);
  histogram.add(INAD{0.25f, 0.5f});
  EXPECT_EQ(1U, histogram.count(1, 2));
  histogram.add(INAD{1.0f, 0.0f});
  histogram.add(INAD{0.0f, 1.0f});
  histogram.add(INAD{-0.1f, 0.0f});
  histogram.add(INAD{infinity, 0.0f});
  EXPECT_EQ(1U, histogram.total());
  EXPECT_EQ(4U, histogram.outside());
}

TEST(ShapeHistogram, UnknownPairsAreNotCounted)
{
  ShapeHistogram histogram = small();
  PointCloud<INAD> cloud;
  cloud.push_back({nan, 0.1f});
  cloud.push_back({0.1f, nan});
  cloud.push_back({0.15f, 0.25f});
  histogram.add(cloud);
  EXPECT_EQ(1U, histogram.total());
  EXPECT_EQ(0U, histogram.outside());
  EXPECT_EQ(1U, histogram.count(1, 2));
}

TEST(ShapeHistogram, LikelihoodIsNormalisedByThePeak)
{
  ShapeHistogram histogram = small();
  histogram.add(2, 1, 8);
  histogram.add(3, 1, 2);
  EXPECT_EQ(1.0f, histogram.likelihood({0.25f, 0.15f}));
  EXPECT_EQ(0.25f, histogram.likelihood({0.35f, 0.15f}));
  EXPECT_EQ(0.0f, histogram.likelihood({0.45f, 0.15f}));
  EXPECT_EQ(0.0f, histogram.likelihood({1.0f, 0.15f}));
  EXPECT_EQ(0.0f, histogram.likelihood({0.25f, 0.5f}));
  EXPECT_TRUE(std::isnan(histogram.likelihood({nan, 0.1f})));
  EXPECT_TRUE(std::isnan(histogram.likelihood({0.1f, nan})));
  EXPECT_EQ(0.0f, small().likelihood({0.25f, 0.15f}));
}

/** \brief Pairs in all bins, beyond them, and unknown ones. */
pcl::PointCloud<pcl::INAD>
allKindsOfPairs(std::size_t count)
{
  pcl::PointCloud<pcl::INAD> cloud;
  for (std::size_t i = 0; i < count; ++i) {
    cloud.push_back(
        {0.07f * static_cast<float>(i % 17), 0.05f * static_cast<float>(i % 11)});
  }
  cloud.push_back({nan, 0.1f});
  cloud.push_back({0.1f, nan});
  cloud.push_back({-0.1f, 0.1f});
  return cloud;
}

void
expectEqual(const ShapeHistogram& expected, const ShapeHistogram& histogram)
{
  EXPECT_EQ(expected.outside(), histogram.outside());
  EXPECT_EQ(expected.total(), histogram.total());
  EXPECT_EQ(expected.peak(), histogram.peak());
  for (std::size_t i = 0; i < histogram.muBins(); ++i)
    for (std::size_t j = 0; j < histogram.sigmaBins(); ++j)
      EXPECT_EQ(expected.count(i, j), histogram.count(i, j)) << i << ", " << j;
}

TEST(ShapeHistogram, ACloudIsCountedAsItsPairsAre)
{
  // Too few pairs for several threads, and enough.
  for (const std::size_t count : {0u, 5u, 1000u, 20000u}) {
    const auto cloud = allKindsOfPairs(count);
    ShapeHistogram one_by_one = small();
    one_by_one.add(2, 1, 3);
    for (const pcl::INAD& pair : cloud)
      one_by_one.add(pair);
    EXPECT_LE(count / 10, one_by_one.outside());
    for (const unsigned threads : {1u, 2u, 3u, 0u}) {
      SCOPED_TRACE(std::to_string(count) + " pairs, threads " +
                   std::to_string(threads));
      ShapeHistogram at_once = small();
      at_once.add(2, 1, 3);
      at_once.add(cloud, threads);
      expectEqual(one_by_one, at_once);
    }
  }
}

TEST(ShapeHistogram, BackProjectionIsTheLikelihoodOfEachPair)
{
  // Fewer pairs than bins, more, and more than a thread takes at once.
  for (const std::size_t count : {0u, 3u, 1000u, 20000u}) {
    const auto cloud = allKindsOfPairs(count);
    for (const ShapeHistogram& empty : {small(), ShapeHistogram()}) {
      ShapeHistogram histogram = empty;
      for (int fill = 0; fill < 2; ++fill) {
        for (const unsigned threads : {1u, 2u, 0u}) {
          const std::vector<float> found = histogram.backProject(cloud, threads);
          ASSERT_EQ(cloud.size(), found.size());
          for (std::size_t i = 0; i < cloud.size(); ++i) {
            const float expected = histogram.likelihood(cloud[i]);
            EXPECT_TRUE(found[i] == expected ||
                        (std::isnan(found[i]) && std::isnan(expected)))
                << i << " of " << count << ": " << found[i] << ", not " << expected;
          }
        }
        histogram.add(cloud);
      }
    }
  }
}

TEST(ShapeHistogram, DensityIntegratesToOne)
{
  ShapeHistogram histogram = small();
  histogram.add(2, 1, 8);
  histogram.add(9, 4, 2);
  EXPECT_NEAR(0.8 / 0.01, histogram.density({0.25f, 0.15f}), 1e-9);
  double mass = 0;
  for (int i = 0; i < 10; ++i) {
    for (int j = 0; j < 5; ++j) {
      const auto middle = [](int bin) {
        return 0.1f * (static_cast<float>(bin) + 0.5f);
      };
      mass += 0.01 * histogram.density({middle(i), middle(j)});
    }
  }
  EXPECT_NEAR(1.0, mass, 1e-12);
  EXPECT_EQ(0.0, histogram.density({2.0f, 0.1f}));
  EXPECT_EQ(0.0, small().density({0.25f, 0.15f}));
  EXPECT_TRUE(std::isnan(histogram.density({nan, 0.1f})));
}

TEST(ShapeHistogram, MergeAddsCounts)
{
  ShapeHistogram a = small(), b = small();
  a.add(2, 1, 8);
  b.add(2, 1, 3);
  b.add(0, 0, 20);
  b.add(INAD{2.0f, 0.1f});
  a.merge(b);
  EXPECT_EQ(11U, a.count(2, 1));
  EXPECT_EQ(20U, a.peak());
  EXPECT_EQ(31U, a.total());
  EXPECT_EQ(1U, a.outside());
}

TEST(ShapeHistogram, OtherBinsCannotBeMerged)
{
  ShapeHistogram histogram = small();
  for (const ShapeHistogram& other : {ShapeHistogram(9, 5, 1.0, 0.5),
                                      ShapeHistogram(10, 4, 1.0, 0.5),
                                      ShapeHistogram(10, 5, 1.1, 0.5),
                                      ShapeHistogram(10, 5, 1.0, 0.6)}) {
    EXPECT_FALSE(histogram.sameBins(other));
    expectParts(exceptionOf<BadArgumentException>([&] { histogram.merge(other); }),
                {"10 x 5", "cannot be merged"});
  }
  EXPECT_TRUE(histogram.sameBins(small()));
}

TEST(ShapeHistogram, BadBinsAreRefused)
{
  const auto textOf = [](std::size_t mu, std::size_t sigma, double a, double b) {
    return exceptionOf<BadArgumentException>([=] { ShapeHistogram(mu, sigma, a, b); });
  };
  expectParts(textOf(0, 5, 1, 1), {"mu_bins is 0", "1 to 4096"});
  expectParts(textOf(5, 4097, 1, 1), {"sigma_bins is 4097", "1 to 4096"});
  expectParts(textOf(5, 5, 0, 1), {"mu_range is 0", "positive and finite"});
  expectParts(textOf(5, 5, 1, -1), {"sigma_range is -1", "positive and finite"});
  expectParts(textOf(5, 5, nan, 1), {"mu_range is nan", "positive and finite"});
  expectParts(textOf(5, 5, 1, infinity), {"sigma_range is inf", "positive and finite"});
}

TEST(ShapeHistogram, BadCountsAreRefused)
{
  ShapeHistogram histogram = small();
  expectParts(exceptionOf<BadArgumentException>([&] { histogram.add(10, 0, 1); }),
              {"bin (10, 0)", "10 x 5"});
  histogram.add(0, 0, std::numeric_limits<std::uint64_t>::max() - 1);
  expectParts(exceptionOf<BadArgumentException>([&] { histogram.add(1, 1, 2); }),
              {"count 2", "bin (1, 1)", "below 2^64"});
  EXPECT_EQ(0U, histogram.count(1, 1));
}

} // namespace
