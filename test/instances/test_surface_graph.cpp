// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Nodes of surfaces, the smooth pieces that they are linked to, and limits.

#include "common/disjoint_sets.h"
#include "instances/label_growth.h"
#include "small_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace {

using namespace pcl;
using namespace pcl::test;
using namespace pcl::segmentation;
using PointLabels = pcl::segmentation::Labels;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

std::vector<SurfaceNode>
nodesIn(const detail::InstanceInput& input, const std::vector<char>& members)
{
  return surfaceNodes(input, PointGrid(input.points, 1.5f), members);
}

PointLabels
piecesOf(const Surface& surface)
{
  const detail::InstanceInput input = inputOf(surface);
  return smoothPieces(
      input, PointGrid(input.points, 1.5f), std::vector<char>(surface.size(), 1));
}

std::size_t
count(const PointLabels& labels, std::int32_t label)
{
  return static_cast<std::size_t>(std::count(labels.begin(), labels.end(), label));
}

TEST(DisjointSets, TheRootIsTheSmallest)
{
  DisjointSets sets(6);
  sets.unite(5, 3);
  sets.unite(4, 1);
  EXPECT_EQ(3U, sets.find(5));
  EXPECT_EQ(1U, sets.find(4));
  EXPECT_EQ(0U, sets.find(0));
  sets.unite(5, 4);
  for (const std::uint32_t i : {1U, 3U, 4U, 5U})
    EXPECT_EQ(1U, sets.find(i));
  EXPECT_EQ(2U, sets.find(2));
}

TEST(SurfaceNodes, OneInEachCellOnTheMeansOfMembers)
{
  const Surface flat = floorPatch(0.1, 0.1, 0.1, 24, 24); // 8 x 8 cells of 1.5
  const detail::InstanceInput input = inputOf(flat);
  const auto nodes = nodesIn(input, std::vector<char>(flat.size(), 1));
  ASSERT_EQ(64U, nodes.size());
  for (const SurfaceNode& node : nodes) {
    EXPECT_NEAR(node.position.z(), 0.1f, 1e-6f);
    EXPECT_NEAR(node.normal.z(), 1.0f, 1e-6f);
    EXPECT_EQ(1.0f, node.spacing);
    EXPECT_LT(node.noise, 1e-3f);
  }
}

TEST(SurfaceNodes, LeaveOutWhatIsNoMemberAndWhatIsAlone)
{
  const Surface flat = floorPatch(0.1, 0.1, 0.1, 24, 24);
  const detail::InstanceInput input = inputOf(flat);
  std::vector<char> members(flat.size(), 0);
  for (std::size_t i = 0; i < flat.size(); ++i)
    members[i] = flat.xyz[3 * i] < 6.0f;
  const auto nodes = nodesIn(input, members);
  ASSERT_EQ(32U, nodes.size());
  for (const SurfaceNode& node : nodes)
    EXPECT_LT(node.position.x(), 6.0f);
  std::fill(members.begin(), members.end(), 0);
  std::fill_n(members.begin(), 4, 1);
  EXPECT_TRUE(nodesIn(input, members).empty());
}

TEST(SurfaceNodes, MeasureTheNoise)
{
  Surface rough = floorPatch(0.1, 0.1, 0.1, 24, 24);
  for (std::size_t i = 0; i < rough.size(); ++i)
    rough.xyz[3 * i + 2] += (i + i / 24) % 2 == 0 ? 0.2f : -0.2f;
  for (const SurfaceNode& node :
       nodesIn(inputOf(rough), std::vector<char>(rough.size(), 1)))
    EXPECT_NEAR(node.noise, 0.2f, 0.01f);
}

TEST(SurfaceGraph, LimitsFollowTheNoise)
{
  detail::InstanceInput input;
  EXPECT_EQ(1.0f, medianSpacing(input));
  input.spacings = {nan, 3.0f, 1.0f, 2.0f, nan};
  EXPECT_EQ(2.0f, medianSpacing(input));
  input.noise = 0.2; // a Kinect's
  EXPECT_FLOAT_EQ(0.8f, offsetLimit(input));
  EXPECT_FLOAT_EQ(0.4f, stepLimit(input));
}

TEST(SurfaceGraph, OneSurfaceIsOnePiece)
{
  Random random(21);
  for (const Surface& surface :
       {floorPatch(0, 0, 0, 40, 40), cylinder(4000, 10.0, 16.0, random)}) {
    const PointLabels pieces = piecesOf(surface);
    EXPECT_EQ(surface.size(), count(pieces, 0));
  }
}

TEST(SurfaceGraph, AStepAndARightAngleSeparate)
{
  const Surface low = floorPatch(0, 0, 0, 40, 40);
  for (const Surface& other :
       {floorPatch(-15.5, 0, 1, 30, 40), wallPatch(0, half, false, 40, 30)}) {
    const PointLabels pieces = piecesOf(together(low, other));
    const auto middle = pieces.begin() + 1600;
    EXPECT_EQ(2, 1 + *std::max_element(pieces.begin(), pieces.end()));
    EXPECT_GE(std::count(pieces.begin(), middle, 0), 1500);
    EXPECT_EQ(0, std::count(pieces.begin(), middle, 1));
    EXPECT_GE(std::count(middle, pieces.end(), 1), 1100);
  }
}

TEST(SurfaceGraph, LabelsAreSortedBySizeAndThenByPosition)
{
  const Surface points = floorPatch(0, 0, 0, 7, 1);
  const detail::InstanceInput input = inputOf(points);
  PointLabels labels{5, 5, 2, -1, 0, 2, 2};
  sortLabels(input, 2, labels);
  EXPECT_EQ((PointLabels{1, 1, 0, -1, -1, 0, 0}), labels);
  labels = {4, 1, 1, 4, 9, -1, 9};
  sortLabels(input, 1, labels);
  EXPECT_EQ((PointLabels{0, 1, 1, 0, 2, -1, 2}), labels);
}

} // namespace
