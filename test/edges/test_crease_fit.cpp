// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Two planes fitted to a neighborhood, and what they say against a smooth surface.

#include "edges/crease_fit.h"
#include "support/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace {

using namespace pcl::segmentation;
using Eigen::Vector3f;
using pcl::test::Random;

constexpr float half_turn = 3.14159265f;

/** Heights over a disc with a radius of 2, as of a function; normals by differences. */
Patch
patchOf(const std::function<float(float, float)>& height, double noise = 0.0)
{
  Random random(7);
  Patch patch;
  while (patch.points.size() < 40) {
    const auto x = static_cast<float>(4.0 * random.uniform() - 2.0);
    const auto y = static_cast<float>(4.0 * random.uniform() - 2.0);
    if (std::hypot(x, y) > 2.0f)
      continue;
    constexpr float step = 0.05f;
    const float dx = (height(x + step, y) - height(x - step, y)) / (2.0f * step);
    const float dy = (height(x, y + step) - height(x, y - step)) / (2.0f * step);
    patch.points.emplace_back(
        x, y, height(x, y) + static_cast<float>(noise * random.normal()));
    patch.normals.push_back(Vector3f(-dx, -dy, 1.0f).normalized());
  }
  return patch;
}

float
roof(float x, float)
{
  return -std::abs(x - 0.3f); // a right angle
}

TEST(CreaseFit, FindsTheCreaseOfARoof)
{
  const auto crease = fitCrease(patchOf(roof));
  ASSERT_TRUE(crease.has_value());
  EXPECT_NEAR(crease->foot.x(), 0.3f, 1e-3f);
  EXPECT_NEAR(std::abs(crease->direction.y()), 1.0f, 1e-3f);
  EXPECT_NEAR(crease->angle, half_turn / 2, 1e-3f);
  EXPECT_NEAR(crease->turn, half_turn / 2, 1e-3f);
}

TEST(CreaseFit, AWedgeExplainsARoofAndAQuadricACylinder)
{
  const Patch wedge = patchOf(roof), noisy_wedge = patchOf(roof, 0.1);
  EXPECT_GT(wedgeOverQuadric(wedge, fitCrease(wedge).value()), 20.0f);
  EXPECT_GT(wedgeOverQuadric(noisy_wedge, fitCrease(noisy_wedge).value()), 10.0f);
  // Its radius is 2.5: it turns by 106 degrees within the patch.
  const Patch cylinder =
      patchOf([](float x, float) { return std::sqrt(6.25f - x * x) - 2.5f; });
  EXPECT_LT(wedgeOverQuadric(cylinder, fitCrease(cylinder).value()), -5.0f);
}

TEST(CreaseFit, PlanesThatCrossAreNoWedge)
{
  // As a fit finds them in two sheets: each plane has points on both sides of the line.
  Patch crossing = patchOf([](float x, float) { return 0.5f * x; });
  for (std::size_t i = 0; i < crossing.points.size(); i += 2) {
    crossing.points[i].z() = -crossing.points[i].z();
    crossing.normals[i].x() = -crossing.normals[i].x();
  }
  const auto crease = fitCrease(crossing);
  ASSERT_TRUE(crease.has_value());
  EXPECT_GT(wedgeDeviation(crossing, *crease), 0.25f);
  EXPECT_LT(wedgeOverQuadric(crossing, *crease), 2.0f);
  const Patch noisy_wedge = patchOf(roof, 0.1);
  EXPECT_LT(wedgeDeviation(noisy_wedge, fitCrease(noisy_wedge).value()), 0.1f);
}

TEST(CreaseFit, NeedsPointsOfTwoPlanes)
{
  EXPECT_FALSE(fitCrease(Patch{}).has_value());
  EXPECT_FALSE(fitCrease(patchOf([](float, float) { return 0.0f; })).has_value());
}

} // namespace
