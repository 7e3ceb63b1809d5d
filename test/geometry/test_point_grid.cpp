// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Points in cells, and those near a place, beside all points.

#include "geometry/cells_around.h"
#include "geometry/point_choice.h"
#include "geometry/point_grid.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>

namespace {

using namespace pcl;
using namespace pcl::test;
using namespace pcl::segmentation;
using Eigen::Vector3f;

std::set<std::uint32_t>
allWithin(const XYZView& points, const Vector3f& center, float radius)
{
  std::set<std::uint32_t> near;
  for (std::uint32_t i = 0; i < points.size; ++i)
    if ((positionOf(points, i) - center).squaredNorm() < radius * radius)
      near.insert(i);
  return near;
}

void
expectBruteForce(const XYZView& points, float cell, float radius)
{
  const PointGrid grid(points, cell);
  for (std::size_t q = 0; q < points.size; q += 37) {
    const Vector3f center = positionOf(points, q) + Vector3f::Constant(0.3f * radius);
    if (!center.allFinite())
      continue;
    std::set<std::uint32_t> found, in_ranges;
    std::size_t visits = 0;
    grid.forEachWithin(center, radius, [&](std::uint32_t i, float squared) {
      EXPECT_EQ((positionOf(points, i) - center).squaredNorm(), squared);
      found.insert(i);
      ++visits;
    });
    grid.forEachRangeWithin(
        center, radius, [&](std::uint32_t begin, std::uint32_t end) {
          ASSERT_LT(begin, end);
          for (std::uint32_t k = begin; k < end; ++k) {
            const std::uint32_t i = grid.order()[k];
            EXPECT_TRUE(in_ranges.insert(i).second);
            EXPECT_LT((positionOf(points, i) - center).lpNorm<Eigen::Infinity>(),
                      radius + 1.001f * cell)
                << "of a cell that is not near";
          }
        });
    EXPECT_EQ(found.size(), visits);
    EXPECT_EQ(allWithin(points, center, radius), found);
    EXPECT_TRUE(
        std::includes(in_ranges.begin(), in_ranges.end(), found.begin(), found.end()));
  }
}

TEST(PointGrid, FindsWhatBruteForceFinds)
{
  Random random(41);
  const Surface surface = plane(2000, 1.0, random);
  for (const float cell : {0.02f, 0.1f, 3.0f})
    for (const float radius : {0.03f, 0.1f, 0.5f})
      expectBruteForce(surface.points(), cell, radius);
}

TEST(PointGrid, FarOutliersAndPointsThatAreNotFinite)
{
  Random random(42);
  Surface surface = plane(2000, 1.0, random);
  surface.add({{1e6, -2e6, 3e5}, {0, 0, 1}});
  surface.add({{std::numeric_limits<double>::quiet_NaN(), 0, 0}, {0, 0, 1}});
  expectBruteForce(surface.points(), 0.05f, 0.1f);
}

TEST(PointGrid, PointsAsFarAsFloatsReach)
{
  Random random(45);
  Surface surface = plane(2000, 1.0, random);
  surface.add({{1e9, 2e19, -1e19}, {0, 0, 1}});
  surface.add({{-1e18, 0.5, 1e9}, {0, 0, 1}});
  expectBruteForce(surface.points(), 0.05f, 0.1f);
}

/** How many points the ranges around those of a surface have. */
std::size_t
pointsInRanges(const XYZView& points, std::size_t surface, float cell, float radius)
{
  const PointGrid grid(points, cell);
  std::size_t count = 0;
  for (std::size_t q = 0; q < surface; ++q)
    grid.forEachRangeWithin(
        positionOf(points, q), radius, [&](std::uint32_t begin, std::uint32_t end) {
          count += end - begin;
        });
  return count;
}

TEST(PointGrid, FarPointsCostTheOthersNothing)
{
  Random random(46);
  for (const double far : {1e6, 1e9, 1e15}) {
    Surface surface = plane(5000, 1.0, random);
    const std::size_t size = surface.size();
    const std::size_t alone = pointsInRanges(surface.points(), size, 0.05f, 0.05f);
    surface.add({{0.5, -far, 2e5}, {0, 0, 1}});
    surface.add({{far, 0.5, 0}, {0, 0, 1}});
    // Cells begin elsewhere: a few points more or less are in them.
    EXPECT_LT(pointsInRanges(surface.points(), size, 0.05f, 0.05f), alone * 5 / 4)
        << far;
  }
}

TEST(PointGrid, NothingIsVisitedBetweenFarPoints)
{
  Random random(48);
  Surface surface = plane(3000, 1.0, random);
  surface.add({{1e9, -3e8, 2e4}, {0, 0, 1}});
  const PointGrid grid(surface.points(), 0.05f);
  for (const Vector3f& center : {Vector3f(-1e5f, 0.5f, 0.0f),
                                 Vector3f(1e5f, 0.5f, 0.0f),
                                 Vector3f(0.5f, -1e5f, 0.0f),
                                 Vector3f(0.5f, 0.5f, 1e5f),
                                 Vector3f(2e9f, 0.5f, 0.0f)})
    grid.forEachRangeWithin(center, 0.1f, [&](std::uint32_t begin, std::uint32_t end) {
      ADD_FAILURE() << end - begin << " points at " << center.transpose();
    });
}

TEST(PointGrid, PartsVisitInTheOrderOfTheWholeCloudWithFarPoints)
{
  Random random(47);
  Surface surface = plane(3000, 1.0, random), part = surface;
  surface.add({{1e9, -3e8, 2e4}, {0, 0, 1}});
  surface.append(plane(3000, 4.0, random));
  const PointGrid whole(surface.points(), 0.05f);
  const PointGrid own(part.points(), 0.05f);
  for (std::size_t q = 0; q < part.size(); q += 11) {
    std::vector<std::uint32_t> of_whole, of_part;
    const auto collect = [&](std::vector<std::uint32_t>& visited) {
      return [&](std::uint32_t i, float) {
        if (i < part.size())
          visited.push_back(i);
      };
    };
    const Vector3f center = positionOf(part.points(), q);
    whole.forEachWithin(center, 0.12f, collect(of_whole));
    own.forEachWithin(center, 0.12f, collect(of_part));
    EXPECT_GT(of_part.size(), 5U);
    EXPECT_EQ(of_whole, of_part);
  }
}

TEST(PointGrid, WithoutFinitePoints)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float xyz[] = {nan, 0, 0};
  const PointGrid grid({xyz, 3, 1}, 0.1f);
  grid.forEachWithin(Vector3f::Zero(), 1.0f, [](std::uint32_t, float) {
    ADD_FAILURE() << "no point is there";
  });
  EXPECT_TRUE(grid.order().empty());
}

TEST(PointChoice, SortsByPositionAsComparisonsDo)
{
  // Of either sign, with many of one x, and zeros of both.
  const std::vector<float> some{-2.5f, -1.0f, -0.0f, 0.0f, 1e-30f, 0.75f, 1.0f, 3e5f};
  std::vector<float> positions;
  for (std::size_t i = 0; i < 600; ++i)
    positions.push_back(some[(i * i + i / 3) % some.size()]);
  const XYZView points{positions.data(), 3, positions.size() / 3};
  std::vector<std::uint32_t> expected(points.size), sorted;
  std::iota(expected.begin(), expected.end(), 0U);
  sorted = expected;
  std::stable_sort(
      expected.begin(), expected.end(), [&](std::uint32_t a, std::uint32_t b) {
        return isBefore(points, a, b);
      });
  sortByPosition(points, sorted);
  for (std::size_t k = 0; k < sorted.size(); ++k) // of equal points any is first
    for (std::size_t axis = 0; axis < 3; ++axis)
      ASSERT_EQ(points[expected[k]][axis], points[sorted[k]][axis]) << k;
}

TEST(CentralPoints, AreNearestToTheMiddlesOfCells)
{
  const float xyz[] = {1.5f,
                       0.5f,
                       0.5f, // the second cell
                       0.1f,
                       0.5f,
                       0.5f,
                       0.25f,
                       0.5f,
                       0.5f, // as near as the next one
                       0.75f,
                       0.5f,
                       0.5f,
                       -0.1f,
                       0.5f,
                       0.5f, // the cell before
                       0.5f,
                       0.5f,
                       0.5f}; // no candidate
  const XYZView points{xyz, 3, 6};
  using Indices = std::vector<std::uint32_t>;
  EXPECT_EQ((Indices{4, 2, 0}), centralPoints(points, {0, 1, 2, 4}, 1.0f));
  EXPECT_EQ((Indices{5}), centralPoints(points, {3, 5, 2}, 1.0f));
  EXPECT_EQ((Indices{3}), centralPoints(points, {3, 2}, 1.0f)) << "the first one";
  Indices order{0, 1, 2, 3, 4, 5};
  sortByPosition(points, order);
  EXPECT_EQ((Indices{4, 1, 2, 5, 3, 0}), order);
}

TEST(CellsAround, HoldWhatIsRoundedAwayFromThem)
{
  CellsAround cells(0.99999994f); // of whose reciprocal more is rounded than of others
  cells.add({-1e-10f, 0.0f, 0.0f});
  EXPECT_TRUE(cells.mayHold({0.99999988f, 0.0f, 0.0f}));
  CellsAround small(0.001); // far away, where numbers of cells are rounded
  small.add({1000.0f, 0.0f, 0.0f});
  EXPECT_TRUE(small.mayHold({std::nextafter(1000.001f, 0.0f), 0.0f, 0.0f}));
}

TEST(CellsAround, HoldAllThatIsNear)
{
  Random random(11);
  // Near the origin, off it, where cells are few steps of a float, and beyond.
  for (const double origin : {0.0, -1000.0, 3e5, 1e9}) {
    SCOPED_TRACE(origin);
    constexpr float size = 0.1f;
    CellsAround cells(size);
    std::vector<Vector3f> places;
    const auto anywhere = [&](double width) -> Vector3f {
      return Eigen::Vector3d(origin + random.uniform(0.0, width),
                             random.uniform(0.0, width),
                             random.uniform(-width, 0.0))
          .cast<float>();
    };
    for (int i = 0; i < 50; ++i) {
      places.emplace_back(anywhere(10.0));
      cells.add(places.back());
    }
    std::size_t held = 0;
    for (int i = 0; i < 20000; ++i) {
      const Vector3f point = anywhere(10.0);
      const bool is_near =
          std::any_of(places.begin(), places.end(), [&](const Vector3f& place) {
            return (place - point).norm() < size;
          });
      EXPECT_TRUE(!is_near || cells.mayHold(point));
      held += cells.mayHold(point) ? 1 : 0;
    }
    if (origin < 1e5) { // 50 times 27 cells of a million, and as many share slots
      EXPECT_LT(held, 2U * 2U * 20000U * 50U * 27U / 1000000U);
    }
    for (const Vector3f& place : places)
      EXPECT_TRUE(cells.mayHold(place));
  }
}

} // namespace
