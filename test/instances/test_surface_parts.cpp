// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Parts of a piece: nodes assigned to them, and parts joined again.

#include "instances/pieces/piece_splitting.h"
#include "small_surfaces.h"

#include <gtest/gtest.h>

namespace {

using namespace pcl;
using namespace pcl::test;
using namespace pcl::segmentation;

ShapePrimitive
levelAt(float height)
{
  return {PrimitiveType::Plane, {0, 0, 1, -height}, 0};
}

/** \brief Nodes in a row, one apart, each around its six nearest. */
SurfacePiece
chain(const std::vector<float>& heights)
{
  Surface row = floorPatch(0, 0, 0, static_cast<int>(heights.size()), 1, 1.0);
  for (std::size_t i = 0; i < heights.size(); ++i)
    row.xyz[3 * i + 2] = heights[i];
  return SurfacePiece(nodesOf(row), 0.0f);
}

std::vector<float>
stepped(std::size_t low, std::size_t high, float height)
{
  std::vector<float> heights(low, 0.0f);
  heights.resize(low + high, height);
  return heights;
}

TEST(PartAssignment, NodesGoToTheNearestSurfaceAround)
{
  const SurfacePiece piece = chain(stepped(20, 18, 0.4f));
  std::vector<SurfacePart> parts{{levelAt(0.0f), range(0, 22)},
                                 {levelAt(0.4f), range(22, 38)}};
  assignNodes(piece, parts);
  ASSERT_EQ(2U, parts.size());
  EXPECT_EQ(range(0, 20), parts[0].nodes);
  EXPECT_EQ(range(20, 38), parts[1].nodes);
}

TEST(PartAssignment, ANodeInDoubtGoesWithThoseAround)
{
  std::vector<float> heights = stepped(20, 20, 0.4f);
  heights[18] = 0.14f; // 0.14 from the first surface, 0.13 from the second
  const SurfacePiece piece = chain(heights);
  std::vector<SurfacePart> parts{{levelAt(0.0f), range(0, 18)},
                                 {levelAt(0.27f), range(18, 40)}};
  parts[0].nodes.push_back(19);
  parts[1].nodes.erase(parts[1].nodes.begin() + 1);
  assignNodes(piece, parts);
  ASSERT_EQ(2U, parts.size());
  EXPECT_EQ(range(0, 20), parts[0].nodes);
  EXPECT_EQ(range(20, 40), parts[1].nodes);
}

TEST(PartAssignment, NodesOnNoSurfaceGoNowhere)
{
  std::vector<float> heights = stepped(20, 20, 1.0f);
  heights[5] = 0.5f;
  const SurfacePiece piece = chain(heights);
  std::vector<SurfacePart> parts{{levelAt(0.0f), range(0, 20)},
                                 {levelAt(1.0f), range(20, 40)}};
  assignNodes(piece, parts);
  ASSERT_EQ(2U, parts.size());
  EXPECT_EQ(range(20, 40), parts[0].nodes) << "the larger one is first";
  EXPECT_EQ(19U, parts[1].nodes.size());
}

TEST(PartAssignment, PartsThatAreNeedlessGo)
{
  const SurfacePiece piece = chain(stepped(20, 11, 1.0f));
  std::vector<SurfacePart> parts{{levelAt(0.0f), range(0, 20)},
                                 {levelAt(1.0f), range(20, 31)}};
  assignNodes(piece, parts);
  ASSERT_EQ(1U, parts.size()) << "fewer than 12 nodes";
  EXPECT_EQ(range(0, 20), parts[0].nodes);

  const SurfacePiece level = chain(stepped(20, 20, 0.1f));
  parts = {{levelAt(0.0f), range(0, 20)}, {levelAt(0.1f), range(20, 40)}};
  assignNodes(level, parts);
  ASSERT_EQ(1U, parts.size()) << "on the surface of the other";
  EXPECT_EQ(range(0, 40), parts[0].nodes);
}

/** \brief The groups that parts become whose nodes are those of two surfaces. */
std::vector<NodeIndices>
joined(const Surface& first,
       const ShapePrimitive& on_first,
       const Surface& second,
       const ShapePrimitive& on_second)
{
  const auto middle = static_cast<std::uint32_t>(first.size());
  const SurfacePiece piece(nodesOf(together(first, second)), 0.0f);
  const auto end = static_cast<std::uint32_t>(piece.nodes.size());
  return joinParts(piece,
                   {{on_first, range(0, middle)}, {on_second, range(middle, end)}});
}

TEST(PartBorders, OnePlaneInTwoPartsIsOne)
{
  const auto groups = joined(floorPatch(0, 0, 0, 10, 10, 1.5),
                             levelAt(0.0f),
                             floorPatch(15, 0, 0, 10, 10, 1.5),
                             levelAt(0.0f));
  ASSERT_EQ(1U, groups.size());
  EXPECT_EQ(range(0, 200), groups[0]);
}

TEST(PartBorders, WidePartsThatABridgeJoinsStay)
{
  const Surface bridge = floorPatch(30, 10.5, 0, 1, 6, 1.5);
  const Surface other = together(bridge, floorPatch(31.6, 0, 0, 20, 20, 1.5));
  EXPECT_EQ(
      2U,
      joined(floorPatch(0, 0, 0, 20, 20, 1.5), levelAt(0.0f), other, levelAt(0.0f))
          .size());
}

TEST(PartBorders, WidePartsThatOnePairOfNodesJoinsStay)
{
  Surface other = floorPatch(31.6, 0, 0, 20, 20, 1.5); // just out of reach
  const auto nearest = [&](std::size_t i) {
    return other.position(i).x() < 32 && other.position(i).y() == 15;
  };
  std::size_t moved = 0;
  for (std::size_t i = 0; i < other.size(); ++i)
    if (nearest(i)) {
      other.xyz[3 * i] = 31.4f;
      ++moved;
    }
  ASSERT_EQ(1U, moved);
  EXPECT_EQ(
      2U,
      joined(floorPatch(0, 0, 0, 20, 20, 1.5), levelAt(0.0f), other, levelAt(0.0f))
          .size());
}

TEST(PartBorders, AStripGoesOnThroughItsShortSide)
{
  EXPECT_EQ(1U,
            joined(floorPatch(0, 0, 0, 40, 5, 1.5),
                   levelAt(0.0f),
                   floorPatch(60, 0, 0, 40, 5, 1.5),
                   levelAt(0.0f))
                .size());
}

TEST(PartBorders, AStepAndARightAngleStay)
{
  EXPECT_EQ(2U,
            joined(floorPatch(0, 0, 0, 10, 10, 1.5),
                   levelAt(0.0f),
                   floorPatch(15, 0, 0.5, 10, 10, 1.5),
                   levelAt(0.5f))
                .size());
  EXPECT_EQ(2U,
            joined(floorPatch(0, 0, 0, 10, 10, 1.5),
                   levelAt(0.0f),
                   wallPatch(0, 1.5, true, 10, 10, 1.5),
                   {PrimitiveType::Plane, {1, 0, 0, 0}, 0})
                .size());
}

TEST(PartBorders, PartsOfACylinderAreOne)
{
  Surface can;
  for (int row = 0; row < 10; ++row)
    for (int column = 0; column < 40; ++column) {
      const double turn = pi * column / 39 + 0.01;
      const Eigen::Vector3d n(std::cos(turn), std::sin(turn), 0.0);
      can.add({18.0 * (n - Eigen::Vector3d::UnitX()) + Eigen::Vector3d(0, 0, 1.5 * row),
               n});
    }
  const auto nodes = nodesOf(can);
  NodeIndices left, right;
  for (std::uint32_t k = 0; k < nodes.size(); ++k)
    (k % 40 < 20 ? left : right).push_back(k);
  const SurfacePiece piece(nodes, 0.0f);
  const Eigen::Vector3f to_first = nodes[0].position;
  const ShapePrimitive surface{PrimitiveType::Cylinder,
                               {-18.0f - to_first.x(), -to_first.y(), 0, 0, 0, 1, 18},
                               0};
  ShapePrimitive wider = surface; // worse by a seventh of the gap's limit
  wider.coefficients[6] += 0.02f;
  EXPECT_EQ(1U, joinParts(piece, {{surface, left}, {wider, right}}).size());
}

TEST(PartBorders, ASmallPartJoinsItsNeighbor)
{
  const auto groups = joined(floorPatch(0, 0, 0, 10, 10, 1.5),
                             levelAt(0.0f),
                             floorPatch(15, 0, 0.5, 1, 10, 1.5),
                             levelAt(0.5f));
  ASSERT_EQ(1U, groups.size());
  EXPECT_EQ(range(0, 110), groups[0]);
}

} // namespace
