// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Tests of points in the order of their cells, against the sort of the standard
// library.

#include "geometry/cell_order.h"
#include "support/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

namespace pcl::segmentation {
namespace {

using test::Random;

using Pairs = std::vector<std::pair<Cell, std::uint32_t>>;

Pairs
pairsOf(const std::vector<CellPoint>& points)
{
  Pairs pairs;
  for (const CellPoint& p : points)
    pairs.emplace_back(p.cell, p.point);
  return pairs;
}

/** Points at random in cells from one number to another along each axis. */
std::vector<CellPoint>
pointsInCells(std::size_t count, const Cell& low, const Cell& high)
{
  Random random(7);
  std::vector<CellPoint> points;
  for (std::uint32_t i = 0; i < count; ++i) {
    CellPoint p{low, i};
    for (std::size_t axis = 0; axis < 3; ++axis)
      p.cell[axis] = static_cast<std::int32_t>(
          std::llround(random.uniform(low[axis], high[axis])));
    points.push_back(p);
  }
  return points;
}

void
expectSorted(std::vector<CellPoint> points)
{
  std::vector<CellPoint> expected = points;
  std::stable_sort(
      expected.begin(), expected.end(), [](const CellPoint& a, const CellPoint& b) {
        return a.cell < b.cell;
      });
  std::vector<CellPoint> by_threads = points;
  sortByCell(points, 1);
  sortByCell(by_threads, 3);
  EXPECT_EQ(pairsOf(points), pairsOf(expected));
  EXPECT_EQ(pairsOf(by_threads), pairsOf(expected));
  std::vector<std::size_t> begins;
  for (std::size_t i = 0; i < expected.size(); ++i)
    if (i == 0 || expected[i].cell != expected[i - 1].cell)
      begins.push_back(i);
  begins.push_back(expected.size());
  EXPECT_EQ(beginsOfCells(points), begins);
}

constexpr std::int32_t min = std::numeric_limits<std::int32_t>::min();
constexpr std::int32_t max = std::numeric_limits<std::int32_t>::max();

TEST(CellOrder, FloorIsThatOfTheStandardLibrary)
{
  for (const double value : {-1.0,
                             std::nextafter(-1.0, 0.0),
                             -0.5,
                             -0.0,
                             0.0,
                             0.5,
                             std::nextafter(1.0, 0.0),
                             1.0,
                             0x1p30,
                             -0x1p30}) {
    EXPECT_EQ(std::floor(value), floorOf(value));
    EXPECT_EQ(std::floor(static_cast<float>(value)),
              floorOf(static_cast<float>(value)));
  }
}

TEST(CellOrder, OfNoPoint)
{
  std::vector<CellPoint> none;
  sortByCell(none, 1);
  EXPECT_TRUE(none.empty());
}

TEST(CellOrder, KeepsTheOrderOfPointsInOneCell)
{
  expectSorted(pointsInCells(1000, {-3, 5, 0}, {-3, 5, 0}));
}

TEST(CellOrder, OfFewCells)
{
  expectSorted(pointsInCells(20000, {-5, 0, 3}, {4, 9, 12}));
}

TEST(CellOrder, OfManyCells)
{
  expectSorted(pointsInCells(200000, {-900, -900, -900}, {900, 900, 900}));
}

TEST(CellOrder, OfAllCellsAlongOneAxis)
{
  expectSorted(pointsInCells(5000, {min, 0, 0}, {max, 0, 0}));
  expectSorted(pointsInCells(5000, {0, 0, min}, {0, 3, max}));
}

TEST(CellOrder, OfNumbersThatFillOneWord)
{
  expectSorted(pointsInCells(5000, {min, 0, min}, {max, 0, max}));
}

TEST(CellOrder, OfNumbersThatNeedMoreThanOneWord)
{
  expectSorted(pointsInCells(5000, {min, min, min}, {max, max, max}));
}

} // namespace
} // namespace pcl::segmentation
