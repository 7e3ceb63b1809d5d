// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Holes in a disc of points, wherever they are.

#include "evaluation/covered_disc.h"

#include <gtest/gtest.h>

#include <cmath>

using pcl::app::isCovered;

namespace {

using Eigen::Vector2d;
using Places = std::vector<Vector2d>;

constexpr double radius = 0.01;

/** \brief Points of a square grid with 1.5 radii around, but for a hole. */
Places
gridPlaces(int steps_per_radius, const Vector2d& hole, double hole_radius)
{
  const double step = radius / steps_per_radius;
  const int reach = steps_per_radius * 3 / 2;
  Places places;
  for (int row = -reach; row <= reach; ++row)
    for (int column = -reach; column <= reach; ++column) {
      const Vector2d place(step * column, step * row);
      if (place.norm() <= 1.5 * radius && (place - hole).norm() >= hole_radius)
        places.push_back(place);
    }
  return places;
}

TEST(CoveredDisc, HolesOfMoreThanTwoSpacingsAreSeenWhereverTheyAre)
{
  // A place that is looked at is within 0.7 steps of the middle of each hole.
  for (const int steps : {10, 30, 60})
    for (const double share : {0.0, 0.3, 0.7, 0.95})
      for (int turn = 0; turn < 4; ++turn) {
        const double angle = 0.1 + M_PI / 2.0 * turn;
        const Vector2d hole =
            share * radius * Vector2d(std::cos(angle), std::sin(angle));
        const double step = radius / steps;
        EXPECT_TRUE(isCovered(gridPlaces(steps, hole, 1.2 * step), radius))
            << steps << ' ' << share << ' ' << turn;
        EXPECT_FALSE(isCovered(gridPlaces(steps, hole, 3.0 * step), radius))
            << steps << ' ' << share << ' ' << turn;
      }
}

TEST(CoveredDisc, WhatIsBesideTheDiscDoesNotMatter)
{
  const Vector2d beside(1.25 * radius, 0.0);
  EXPECT_TRUE(isCovered(gridPlaces(40, beside, 0.2 * radius), radius));
  EXPECT_FALSE(isCovered(gridPlaces(40, beside, 0.35 * radius), radius));
}

TEST(CoveredDisc, FewPointsOrOnePlaceCoverNothing)
{
  EXPECT_FALSE(isCovered({}, radius));
  EXPECT_FALSE(isCovered(Places(19, Vector2d::Zero()), radius));
  EXPECT_FALSE(isCovered(Places(1000, Vector2d::Zero()), radius));
}

} // namespace
