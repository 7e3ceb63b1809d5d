// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Equal points count once: each gets what its place gets without repeats.

#include "field_of.h"
#include "segmentation/field_places.h"
#include "support/bits.h"

#include <pcl/features/distinct_points.h>
#include <pcl/features/impl/neighborhoods.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace {

using namespace pcl;
using namespace pcl::test;

using Cloud = PointCloud<PointXYZ>;

/** A floor and a wall, points about 1 cm apart. */
Cloud::Ptr
corner()
{
  const auto cloud = pcl::make_shared<Cloud>();
  for (int i = 0; i < 40; ++i)
    for (int j = 0; j < 40; ++j) {
      const float u = 0.01f * static_cast<float>(i) + 1e-4f * static_cast<float>(j % 7);
      const float v = 0.01f * static_cast<float>(j) + 1e-4f * static_cast<float>(i % 5);
      cloud->push_back(PointXYZ(1.0f + u, 1.0f + v, 1.0f));
      cloud->push_back(PointXYZ(1.0f, 1.0f + v, 1.01f + u));
    }
  return cloud;
}

TEST(CoincidentPoints, NoRepeatsGiveNoPlaces)
{
  EXPECT_FALSE(distinctPoints(detail::xyzOf(*corner())).hasRepeats());
  EXPECT_FALSE(fieldOf(corner()).base);
}

TEST(CoincidentPoints, ZerosOfEitherSignAreEqualAndUnknownPointsAreNot)
{
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<float> points{
      0, 1, 2, nan, 0, 0, -0.0f, 1, 2, nan, 0, 0, 0, 1, 3, 0, 1, 2};
  const DistinctPoints distinct = distinctPoints({points.data(), 3, 6});
  EXPECT_EQ((std::vector<std::int32_t>{0, 1, 3, 4}), distinct.first);
  EXPECT_EQ((std::vector<std::int32_t>{0, 1, 0, 2, 3, 0}), distinct.place);
}

TEST(CoincidentPoints, InfinitePointsHavePlacesOfTheirOwnSideBySideAndApart)
{
  constexpr float far = std::numeric_limits<float>::infinity();
  const std::vector<float> points{far, 0, 0, far, 0, 0, 1, 2, 3, far, 0, 0};
  const DistinctPoints distinct = distinctPoints({points.data(), 3, 4});
  EXPECT_FALSE(distinct.hasRepeats());
}

/** A base has places of its own: only if these are the points' they are taken. */
TEST(CoincidentPoints, PlacesOfABaseAreThoseOfThePoints)
{
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  using Positions = std::vector<float>;
  using Places = std::vector<std::int32_t>;
  const Positions points{1, 0, 0, 2, 0, 0, 1, 0,   0, nan, 0,
                         0, 3, 0, 0, 3, 0, 0, nan, 0, 0};
  const auto distinctOf = [](const Positions& of_field,
                             const Positions& of_base,
                             const Places& base_points) {
    ShapeField field, base;
    field.points = {of_field.data(), 3, of_field.size() / 3};
    base.points = {of_base.data(), 3, of_base.size() / 3 - 1}; // without the last
    field.base = pcl::make_shared<const ShapeField>(base);
    field.base_points = base_points;
    return detail::distinctPoints(field);
  };
  const auto expectPlaces = [&](const Positions& of_base, const Places& base_points) {
    const DistinctPoints distinct = distinctOf(points, of_base, base_points);
    EXPECT_EQ((Places{0, 1, 3, 4, 6}), distinct.first);
    EXPECT_EQ((Places{0, 1, 0, 2, 3, 3, 4}), distinct.place);
  };
  const Positions same{1, 0, 0, 2, 0, 0, nan, 0, 0, 3, 0, 0, nan, 0, 0, 3, 0, 0};
  expectPlaces(same, {0, 1, 0, 2, 3, 3, 4}); // those of the base; below they are wrong
  expectPlaces(same, {});
  expectPlaces(same, {0, 1, 0, 2, 3, -1, 4}); // a point has no place
  expectPlaces(same, {0, 1, 0, 2, 3, 5, 4});  // a place is not in the base
  expectPlaces(same, {0, 1, 0, 2, 3, 1, 4});  // it is that of another point
  expectPlaces(same, {0, 1, 0, 2, 3, 2, 4});  // it is not finite
  const Positions fewer{1, 0, 0, 2, 0, 0, 3, 0, 0, nan, 0, 0, 0, 0, 0};
  expectPlaces(fewer, {0, 1, 0, 1, 2, 2, 3}); // a known one of an unknown point
  const Positions turned{2, 0, 0, 1, 0, 0, nan, 0, 0, 3, 0, 0, nan, 0, 0, 0, 0, 0};
  expectPlaces(turned, {1, 0, 1, 2, 3, 3, 4});
  const Positions more{9, 0, 0, 1, 0,   0, 2, 0, 0, nan, 0,
                       0, 3, 0, 0, nan, 0, 0, 0, 0, 0};
  expectPlaces(more, {1, 2, 1, 3, 4, 4, 5}); // no point is at the first
  const Positions apart{1, 0, 0, 2, 0, 0, 0, 0, 0};
  EXPECT_FALSE(distinctOf({1, 0, 0, 2, 0, 0}, apart, {0, 1}).hasRepeats());
}

/** Cells of space are where they are, and none of the numbers of the cloud changes. */
TEST(CoincidentPoints, StraysAndFillersChangeNoOtherPoint)
{
  const Cloud::Ptr alone = corner();
  const ShapeField expected = fieldOf(alone);
  ASSERT_FALSE(expected.creases.empty());
  ASSERT_FALSE(expected.likelihoods.empty());
  for (const PointXYZ& stray :
       {PointXYZ(0, 0, 0), PointXYZ(50, -30, -20), PointXYZ(1e9f, -1e8f, 1e5f)})
    for (const std::size_t times : {1U, 2000U}) {
      SCOPED_TRACE(testing::Message() << stray << ", " << times << " times");
      const auto cloud = pcl::make_shared<Cloud>(*alone);
      cloud->insert(cloud->end(), times, stray);
      const ShapeField field = fieldOf(cloud);
      const auto others = [&](std::vector<float> values) {
        values.resize(alone->size());
        return values;
      };
      EXPECT_EQ(expected.creases.size(), field.creases.size());
      EXPECT_EQ(expected.noise, field.noise);
      EXPECT_EQ(expected.noise_level, field.noise_level);
      EXPECT_TRUE(sameBits(expected.spacings, others(field.spacings)));
      EXPECT_TRUE(sameBits(expected.edge_likelihood, others(field.edge_likelihood)));
      ASSERT_EQ(expected.likelihoods.size(), field.likelihoods.size());
      for (std::size_t c = 0; c < field.likelihoods.size(); ++c)
        EXPECT_TRUE(sameBits(expected.likelihoods[c], others(field.likelihoods[c])));
    }
}

TEST(CoincidentPoints, EachPointGetsWhatItsPlaceGets)
{
  constexpr std::size_t times = 13;
  const Cloud::Ptr once = corner();
  const auto often = pcl::make_shared<Cloud>();
  for (std::size_t t = 0; t < times; ++t)
    *often += *once;
  const ShapeField expected = fieldOf(once), field = fieldOf(often);
  ASSERT_TRUE(field.base);
  EXPECT_EQ(once->size(), field.base->points.size);
  EXPECT_EQ(expected.noise, field.noise);
  EXPECT_EQ(expected.noise_level, field.noise_level);
  EXPECT_EQ(expected.creases.size(), field.creases.size());
  ASSERT_FALSE(expected.creases.empty());
  ASSERT_EQ(expected.likelihoods.size(), field.likelihoods.size());
  const auto repeated = [&](const std::vector<float>& values) {
    std::vector<float> result;
    for (std::size_t t = 0; t < times; ++t)
      result.insert(result.end(), values.begin(), values.end());
    return result;
  };
  EXPECT_TRUE(sameBits(repeated(expected.spacings), field.spacings));
  EXPECT_TRUE(sameBits(repeated(expected.edge_likelihood), field.edge_likelihood));
  for (std::size_t c = 0; c < field.likelihoods.size(); ++c)
    EXPECT_TRUE(sameBits(repeated(expected.likelihoods[c]), field.likelihoods[c]));
}

TEST(CoincidentPoints, ManyAtOnePlaceAreUnknownAndChangeNothing)
{
  constexpr std::size_t fillers = 50000;
  const Cloud::Ptr cloud = corner();
  const std::size_t points = cloud->size();
  cloud->push_back(PointXYZ(0.0f, 0.0f, 0.0f));
  const ShapeField expected = fieldOf(cloud);
  cloud->resize(static_cast<index_t>(points + fillers), PointXYZ(0.0f, 0.0f, -0.0f));
  const ShapeField field = fieldOf(cloud);
  ASSERT_TRUE(field.base);
  EXPECT_EQ(points + 1, field.base->points.size);
  std::vector<float> first = field.edge_likelihood;
  first.resize(points + 1);
  EXPECT_TRUE(sameBits(expected.edge_likelihood, first));
  EXPECT_TRUE(
      std::all_of(field.edge_likelihood.begin() + static_cast<std::ptrdiff_t>(points),
                  field.edge_likelihood.end(),
                  [](float likelihood) { return std::isnan(likelihood); }));
}

} // namespace
