// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The reasons for which points have no value.

#include <pcl/segmentation/unknown_points.h>

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <vector>

namespace {

using namespace pcl;

UnknownPoints
reasons(const std::vector<float>& points, double radius)
{
  const std::vector<float> values(points.size() / 3,
                                  std::numeric_limits<float>::quiet_NaN());
  return unknownPoints(
      {points.data(), 3, values.size()}, values, NeighborhoodSize::ofRadius(radius), 1);
}

/** A row of points. */
std::vector<float>
row(float origin, float step)
{
  std::vector<float> points;
  for (int i = 0; i < 100; ++i)
    points.insert(points.end(), {origin + step * static_cast<float>(i), 0.0f, 0.0f});
  return points;
}

TEST(UnknownPoints, TooFewNeighborsNameRadiusAndSpacing)
{
  const UnknownPoints found = reasons(row(0.0f, 4.0f), 0.025);
  EXPECT_EQ(100U, found.unknown);
  EXPECT_EQ(100U, found.few_neighbors);
  EXPECT_FLOAT_EQ(4.0f, found.spacing);
  EXPECT_FLOAT_EQ(0.025f, found.radius);
}

TEST(UnknownPoints, NeighborsOnALine)
{
  const UnknownPoints found = reasons(row(0.0f, 0.25f), 1.1);
  EXPECT_EQ(98U, found.on_a_line);
  EXPECT_EQ(2U, found.few_neighbors); // the ends
}

TEST(UnknownPoints, PointsAtOnePlace)
{
  const UnknownPoints found = reasons(std::vector<float>(300, 1.0f), 1.0);
  EXPECT_EQ(100U, found.at_one_place);
  EXPECT_EQ(0.0f, found.spacing);
}

TEST(UnknownPoints, CoordinatesTooLargeForFloat)
{
  const UnknownPoints found = reasons(row(5000000.0f, 0.5f), 10.0);
  EXPECT_EQ(100U, found.rounded);
  EXPECT_EQ(0.5f, found.float_spacing);
}

TEST(UnknownPoints, AnotherNumberOfValuesIsRefused)
{
  const std::vector<float> points(6, 0.0f);
  EXPECT_THROW(
      unknownPoints({points.data(), 3, 2}, {0.0f}, NeighborhoodSize::ofRadius(1.0), 1),
      std::invalid_argument);
}

} // namespace
