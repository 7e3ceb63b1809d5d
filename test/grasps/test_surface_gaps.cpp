// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Holes, slots and gaps of generated plates: which are seen, and that none is made up.

#include "grasps/surface_gaps.h"
#include "support/random.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

// Lengths in mean distances between points: each stands for an area of 1.
namespace {

using Eigen::Vector2f;
using pcl::segmentation::Gap;
using pcl::segmentation::gapsWithin;
using pcl::test::Random;
using Places = std::vector<Vector2f>;
using IsMissing = std::function<bool(const Vector2f&)>;

constexpr float spacing = 2.0f; // the 12th neighbor of a point is 2 distances away
constexpr float turn = 6.2831853f;

enum class Sampling { Grid, Tilted, Jittered, Holey, AtRandom };

/** \brief A disc of points around the middle, turned and shifted at random. */
Places
plate(Sampling sampling, float radius, Random& random, const IsMissing& isMissing)
{
  const auto within = [&](double low, double high) {
    return static_cast<float>(random.uniform(low, high));
  };
  const Eigen::Rotation2D<float> rotation(within(0.0, turn));
  const Vector2f shift(within(0.0, 1.0), within(0.0, 1.0));
  Places places;
  const auto add = [&](const Vector2f& place) {
    if (place.norm() < radius && !isMissing(place))
      places.push_back(place);
  };
  const int half = static_cast<int>(1.5f * radius) + 2;
  if (sampling == Sampling::AtRandom) {
    const int count = static_cast<int>(4.0f * radius * radius);
    for (int i = 0; i < count; ++i)
      add({within(-radius, radius), within(-radius, radius)});
    return places;
  }
  for (int row = -half; row <= half; ++row)
    for (int column = -half; column <= half; ++column) {
      Vector2f place(static_cast<float>(column), static_cast<float>(row));
      if (sampling == Sampling::Tilted) // by 60 degrees
        place = {place.x() * 0.7071f, place.y() * 1.4142f};
      if (sampling == Sampling::Jittered)
        place += 0.25f * Vector2f(static_cast<float>(random.normal()),
                                  static_cast<float>(random.normal()));
      if (sampling != Sampling::Holey || random.uniform() > 0.1)
        add(rotation * (place + shift));
    }
  return places;
}

bool
leaks(const Places& places, float radius)
{
  const std::vector<Gap> gaps = gapsWithin(radius, places, spacing);
  return std::any_of(gaps.begin(), gaps.end(), [&](const Gap& gap) {
    return gap.distance() < radius;
  });
}

bool
nothingIsMissing(const Vector2f& /*place*/)
{
  return false;
}

/** \brief The smallest hole that is always seen. */
float
smallestHole(Sampling sampling)
{
  switch (sampling) {
  case Sampling::Grid:
  case Sampling::Tilted:
    return 3.1f;
  case Sampling::Jittered:
  case Sampling::Holey:
    return 4.1f;
  case Sampling::AtRandom:
    break;
  }
  return 5.0f;
}

constexpr float points_beyond = 7.0f;

class Gaps : public testing::TestWithParam<Sampling> {};

TEST_P(Gaps, AreNotMadeUp)
{
  Random random(931);
  int leaking = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const float radius = trial % 3 == 0 ? 18.0f : 9.0f;
    leaking += leaks(
        plate(GetParam(), radius + points_beyond, random, nothingIsMissing), radius);
  }
  EXPECT_LE(leaking, 3); // a tenth of them may have one in a hundred: see gapsWithin()
}

TEST_P(Gaps, AreSeenAsHoles)
{
  Random random(932);
  for (const float radius : {9.0f, 18.0f})
    for (int trial = 0; trial < 30; ++trial) {
      const auto away = static_cast<float>(random.uniform(0.0, 0.9)) * radius;
      const Vector2f middle(away, 0.0f);
      const float hole = 0.5f * smallestHole(GetParam());
      const auto isMissing = [&](const Vector2f& p) {
        return (p - middle).norm() < hole;
      };
      EXPECT_TRUE(
          leaks(plate(GetParam(), radius + points_beyond, random, isMissing), radius))
          << away;
    }
}

TEST_P(Gaps, AreSeenAsSlots)
{
  Random random(933);
  for (const float radius : {9.0f, 18.0f})
    for (int trial = 0; trial < 30; ++trial) {
      const auto away = static_cast<float>(random.uniform(-0.5, 0.5)) * radius;
      const auto isMissing = [&](const Vector2f& p) {
        return std::abs(p.x() - away) < 1.55f && std::abs(p.y()) < 9.0f;
      };
      EXPECT_TRUE(
          leaks(plate(GetParam(), radius + points_beyond, random, isMissing), radius))
          << away;
    }
}

TEST_P(Gaps, AreSeenBetweenTwoPlates)
{
  Random random(934);
  for (const float radius : {9.0f, 18.0f})
    for (int trial = 0; trial < 30; ++trial) {
      const auto away = static_cast<float>(random.uniform(-0.7, 0.7)) * radius;
      const auto isMissing = [&](const Vector2f& p) {
        return std::abs(p.x() - away) < 1.55f;
      };
      EXPECT_TRUE(
          leaks(plate(GetParam(), radius + points_beyond, random, isMissing), radius))
          << away;
    }
}

TEST_P(Gaps, OutsideDoNotMatter)
{
  Random random(935);
  for (int trial = 0; trial < 30; ++trial) {
    const float radius = 12.0f;
    const auto isMissing = [&](const Vector2f& p) {
      return (p - Vector2f(radius + 4.5f, 0.0f)).norm() < 2.5f;
    };
    EXPECT_FALSE(
        leaks(plate(GetParam(), radius + points_beyond, random, isMissing), radius));
  }
}

INSTANTIATE_TEST_SUITE_P(Samplings,
                         Gaps,
                         testing::Values(Sampling::Grid,
                                         Sampling::Tilted,
                                         Sampling::Jittered,
                                         Sampling::Holey,
                                         Sampling::AtRandom));

TEST(Gaps, TellWhereTheRimIs)
{
  Random random(936);
  const Vector2f middle(6.0f, 0.0f);
  const Places places = plate(Sampling::Grid, 22.0f, random, [&](const Vector2f& p) {
    return (p - middle).norm() < 3.0f;
  });
  float nearest = 1e9f;
  for (const Gap& gap : gapsWithin(15.0f, places, spacing))
    nearest = std::min(nearest, gap.distance());
  EXPECT_NEAR(nearest, 3.0f, 1.0f);
}

TEST(Gaps, NeedPoints)
{
  EXPECT_TRUE(gapsWithin(5.0f, {}, spacing).empty());
  EXPECT_TRUE(gapsWithin(5.0f, {{0.0f, 0.0f}, {1.0f, 0.0f}}, spacing).empty());
}

} // namespace
