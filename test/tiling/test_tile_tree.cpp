// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Cells of density, and the tiles that space is cut into.

#include "memory_source.h"
#include "tiling/plan.h"
#include "tiling/tile_tree.h"

#include <gtest/gtest.h>

#include <map>

namespace {

using namespace pcl::tiling;
using namespace pcl_shape_test;

std::array<float, 3>
floatsOf(const Position& p)
{
  return {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
}

DensityCells
cellsOf(const std::vector<Position>& points)
{
  DensityCells cells;
  for (const Position& p : points)
    cells.add(floatsOf(p).data(), 1);
  return cells;
}

std::map<std::size_t, std::uint64_t>
countsOf(const TileTree& tree, const std::vector<Position>& points)
{
  std::map<std::size_t, std::uint64_t> counts;
  for (const Position& p : points)
    ++counts[tree.tileOf(floatsOf(p).data())];
  return counts;
}

TEST(TileTree, TilesHaveFewPoints)
{
  const auto points = unevenPoints(20000, 1);
  const TileTree tree(cellsOf(points), 700, 0.0);
  const auto counts = countsOf(tree, points);
  EXPECT_EQ(counts.size(), tree.size());
  EXPECT_LT(tree.size(), 70U); // halves of halves: more than 350 points each
  for (const auto& [tile, count] : counts)
    EXPECT_LE(count, 700U);
}

TEST(TileTree, TilesAreShort)
{
  const auto points = unevenPoints(5000, 2);
  const TileTree tree(cellsOf(points), 1000000, 7.0);
  std::map<std::size_t, std::pair<Position, Position>> boxes;
  for (const Position& p : points) {
    auto& [low, high] =
        boxes.emplace(tree.tileOf(floatsOf(p).data()), std::pair(p, p)).first->second;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], p[axis]);
      high[axis] = std::max(high[axis], p[axis]);
    }
  }
  for (const auto& [tile, box] : boxes)
    for (std::size_t axis = 0; axis < 3; ++axis)
      EXPECT_LE(box.second[axis] - box.first[axis], 7.0);
  EXPECT_GT(boxes.size(), 200U);
}

TEST(TileTree, DoesNotDependOnTheOrderOfPoints)
{
  auto points = unevenPoints(700000, 3); // more than there may be cells
  const DensityCells before = cellsOf(points);
  const TileTree tree(before, 50000, 0.0);
  std::shuffle(points.begin(), points.end(), std::mt19937(4));
  const DensityCells after = cellsOf(points);
  EXPECT_EQ(before.grid().exponent, after.grid().exponent);
  const std::vector<Cell> cells = before.counts().sorted(),
                          same = after.counts().sorted();
  ASSERT_EQ(cells.size(), same.size());
  for (std::size_t i = 0; i < cells.size(); ++i)
    ASSERT_TRUE(cells[i].key == same[i].key && cells[i].count == same[i].count);
  EXPECT_EQ(before.typicalDistance(), after.typicalDistance());
  // Nor on how they are counted: parts of the cloud, and then these together.
  DensityCells together;
  const auto few = points.begin() + 5000, many = points.begin() + 300000;
  for (const auto& [begin, end] : {std::pair(many, points.end()),
                                   std::pair(points.begin(), few),
                                   std::pair(few, many)}) {
    const DensityCells part = cellsOf({begin, end});
    together.add(part.grid(), part.counts().sorted());
  }
  EXPECT_EQ(before.grid().exponent, together.grid().exponent);
  const std::vector<Cell> added = together.counts().sorted();
  ASSERT_EQ(cells.size(), added.size());
  for (std::size_t i = 0; i < cells.size(); ++i)
    ASSERT_TRUE(cells[i].key == added[i].key && cells[i].count == added[i].count);
  const TileTree again(after, 50000, 0.0);
  for (const Position& p : points)
    ASSERT_EQ(tree.tileOf(floatsOf(p).data()), again.tileOf(floatsOf(p).data()));
}

TEST(Survey, SectionsHaveFewCellsAndTilesFewPointsAllTheSame)
{
  const auto points = unevenPoints(400000, 6);
  Survey all;
  for (const auto& [begin, end] : {std::pair(0, 150000), std::pair(150000, 400000)}) {
    Survey section = Survey::ofSection();
    section.add(points.data() + begin, static_cast<std::size_t>(end - begin), {});
    EXPECT_GT(section.cells.counts().size(), DensityCells::default_max_cells / 64);
    EXPECT_LE(section.cells.counts().size(), DensityCells::default_max_cells / 8);
    all.add(section.toBytes());
  }
  EXPECT_EQ(all.finite, points.size());
  const Plan plan = planOf(all, {}, 20000, 0.0);
  for (const auto& [tile, count] : countsOf(plan.tree, points)) {
    EXPECT_LE(count, 20000U);
    EXPECT_EQ(count, plan.points[tile]);
  }
}

TEST(Survey, RefusesBytesOfAnotherLength)
{
  const auto points = unevenPoints(100, 6);
  Survey section = Survey::ofSection();
  section.add(points.data(), points.size(), {});
  const std::vector<std::uint8_t> bytes = section.toBytes();
  Survey all;
  for (const std::size_t size :
       {bytes.size() + 1, 2 * bytes.size(), bytes.size() - 1, std::size_t{7}}) {
    std::vector<std::uint8_t> other = bytes;
    other.resize(size);
    EXPECT_THROW(all.add(other), TilingError) << size;
  }
  EXPECT_EQ(all.finite, 0U);
}

TEST(TileTree, SmallestCellsAreTheSameFromWhateverSizeTheyGrow)
{
  const auto points = unevenPoints(100000, 8);
  std::vector<float> floats;
  for (const Position& p : points)
    for (const float coordinate : floatsOf(p))
      floats.push_back(coordinate);
  constexpr std::size_t max_cells = 1000;
  DensityCells expected(max_cells);
  expected.add(floats.data(), points.size());
  ASSERT_TRUE(expected.areSmallest());
  const std::vector<Cell> cells = expected.counts().sorted();
  const int exponent = expected.grid().exponent;
  for (const int first : {exponent - 9, exponent - 2, exponent - 1}) {
    DensityCells grown(max_cells, first);
    grown.add(floats.data(), points.size());
    EXPECT_TRUE(grown.areSmallest());
    ASSERT_EQ(exponent, grown.grid().exponent);
    const std::vector<Cell> same = grown.counts().sorted();
    ASSERT_EQ(cells.size(), same.size());
    for (std::size_t i = 0; i < cells.size(); ++i)
      ASSERT_TRUE(cells[i].key == same[i].key && cells[i].count == same[i].count);
  }
  for (const int first : {exponent, exponent + 1}) {
    DensityCells coarse(max_cells, first);
    coarse.add(floats.data(), points.size());
    EXPECT_FALSE(coarse.areSmallest()) << first - exponent;
  }
}

TEST(TileTree, KnowsTheDistanceBetweenNeighbors)
{
  std::vector<Position> plane;
  std::mt19937 engine(5);
  const auto random = [&] {
    return 20.0 * static_cast<double>(engine()) / 4294967296.0;
  };
  for (int i = 0; i < 40000; ++i)
    plane.push_back({random(), random(), 1.3});
  // 100 a square meter: twelve are in a circle of 0.195 m.
  EXPECT_NEAR(cellsOf(plane).typicalDistance(), 0.195, 0.06);
}

TEST(TileTree, OnePlaceAndFarPoints)
{
  std::vector<Position> points(5000, Position{1.0, 2.0, 3.0});
  const TileTree one(cellsOf(points), 100, 0.1);
  EXPECT_EQ(one.size(), 1U);
  points.push_back({1e30, -1e30, 0.0});
  points.push_back({-1e38, 0.0, 1e38});
  const TileTree tree(cellsOf(points), 100, 0.0);
  EXPECT_EQ(tree.size(), 3U);
  EXPECT_EQ(countsOf(tree, points).size(), 3U);
}

} // namespace
