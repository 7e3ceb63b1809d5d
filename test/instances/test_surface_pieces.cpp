// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Pieces that are one primitive or several, and how they are cut.

#include "instances/pieces/piece_splitting.h"
#include "small_surfaces.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

namespace {

using namespace pcl;
using namespace pcl::test;
using namespace pcl::segmentation;
using PointLabels = pcl::segmentation::Labels;

TEST(SurfacePiece, OnePrimitiveDescribesPlaneCylinderAndSphere)
{
  Random random(22);
  const auto isOne = [](const Surface& surface) {
    const SurfacePiece piece(nodesOf(surface), 0.0f);
    return piece.isOne(piece.allNodes());
  };
  EXPECT_TRUE(isOne(floorPatch(0, 0, 0, 12, 12, 1.5)));
  EXPECT_TRUE(isOne(sphere(200, 6.0, random)));
  EXPECT_TRUE(isOne(cylinder(200, 6.0, 16.0, random)));
  EXPECT_TRUE(isOne(cone(300, 20.0, random)));
  EXPECT_FALSE(isOne(together(floorPatch(1.5, 0, 0, 12, 12, 1.5),
                              wallPatch(0, 1.5, false, 12, 12, 1.5))));
}

TEST(SurfacePiece, ARightAngleIsTwoPlanes)
{
  const SurfacePiece piece(nodesOf(together(floorPatch(1.5, 0, 0, 12, 12, 1.5),
                                            wallPatch(0, 1.5, true, 12, 10, 1.5))),
                           0.0f);
  EXPECT_EQ(26U, piece.min_size); // a tenth of 264
  const std::vector<SurfacePart> parts = piece.parts();
  ASSERT_EQ(2U, parts.size());
  EXPECT_EQ(range(0, 144), parts[0].nodes);
  EXPECT_EQ(range(144, 264), parts[1].nodes);
  for (const SurfacePart& part : parts) {
    EXPECT_FALSE(isCurved(part));
    EXPECT_LT(piece.residualOf(part.surface, part.nodes), 1e-3f);
  }
}

TEST(SurfacePiece, DistancesAreInSpacingsAndOnlyWhereNormalsAgree)
{
  auto nodes = nodesOf(floorPatch(3, 3, 3, 6, 6, 3.0));
  for (SurfaceNode& node : nodes)
    node.spacing = 2.0f;
  const SurfacePiece piece(nodes, 0.0f);
  const ShapePrimitive below{PrimitiveType::Plane, {0, 0, 1, 0.5f}, 0};
  EXPECT_FLOAT_EQ(0.5f, piece.distanceTo(below, 0)); // 0 is the first node's place
  EXPECT_FLOAT_EQ(0.5f, piece.residualOf(below, piece.allNodes()));
  const ShapePrimitive beside{PrimitiveType::Plane, {1, 0, 0, 0}, 0};
  EXPECT_EQ(std::numeric_limits<float>::infinity(), piece.distanceTo(beside, 0));
}

TEST(SurfacePiece, PartsAreConnected)
{
  const SurfacePiece piece(nodesOf(together(floorPatch(0, 0, 0, 10, 10, 1.5),
                                            floorPatch(30, 0, 0, 10, 8, 1.5))),
                           0.0f);
  const std::vector<SurfacePart> parts = piece.parts();
  ASSERT_EQ(2U, parts.size());
  EXPECT_EQ(range(0, 100), parts[0].nodes);
  EXPECT_EQ(range(100, 180), parts[1].nodes);
}

TEST(SurfaceSplit, CutsWhatIsNotOneSurface)
{
  const Surface angle = together(floorPatch(1.5, 0, 0, 12, 12, 1.5),
                                 wallPatch(0, 1.5, false, 12, 12, 1.5));
  const detail::InstanceInput input = inputOf(angle);
  PointLabels labels(angle.size(), 0);
  labels[0] = -1;
  const PointLabels cut = splitSurfaces(input, nodesOf(angle), labels);
  EXPECT_EQ(-1, cut[0]);
  const std::set<std::int32_t> flat(cut.begin() + 1, cut.begin() + 144);
  const std::set<std::int32_t> upright(cut.begin() + 144, cut.end());
  EXPECT_EQ(1U, flat.size());
  EXPECT_EQ(1U, upright.size());
  EXPECT_NE(flat, upright);
}

TEST(SurfaceSplit, KeepsWhatIsOne)
{
  Random random(23);
  const Surface can = cylinder(200, 6.0, 16.0, random);
  const PointLabels labels(can.size(), 7);
  EXPECT_EQ(labels, splitSurfaces(inputOf(can), nodesOf(can), labels));
}

} // namespace
