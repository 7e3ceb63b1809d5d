// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Kinds of edges on a cube and on a sheet.

#include "segmentation/detection_scenes.h"
#include "support/errors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace pcl;
using namespace pcl::test;

TEST(EdgeTypes, CornersAreWhereCreasesMeet)
{
  Random random(81);
  const Surface cube = sampled(30000, random, onCube);
  ShapeEdgeDetection<PointXYZ> detection;
  detection.setInputCloud(toCloud<PointXYZ>(cube));
  Edges edges;
  detection.detect(edges);
  ASSERT_EQ(cube.size(), edges.types.size());
  ASSERT_GT(edges.creases.size(), 100U);
  std::size_t corners = 0, far_corners = 0, boundary = 0;
  for (std::size_t i = 0; i < cube.size(); ++i) {
    const Eigen::Array3d p = cube.position(i).array();
    const double to_corner = (p - p.round()).matrix().norm();
    corners += edges.types[i] == EdgeType::Corner ? 1 : 0;
    far_corners += edges.types[i] == EdgeType::Corner && to_corner > 0.1 ? 1 : 0;
    boundary += edges.types[i] == EdgeType::OpenBoundary ? 1 : 0;
  }
  EXPECT_GT(corners, 8U * 5U);
  EXPECT_LT(far_corners, corners / 10);
  EXPECT_LT(boundary, cube.size() / 100);
  std::size_t right_angles = 0;
  for (const CreasePoint& crease : edges.creases)
    right_angles += std::abs(crease.angle - pi / 2) < 0.1 ? 1 : 0;
  EXPECT_GT(static_cast<double>(right_angles),
            0.9 * static_cast<double>(edges.creases.size()));
}

TEST(EdgeTypes, TheRimOfASheetIsAnOpenBoundary)
{
  Random random(82);
  const Surface sheet = plane(10000, 1.0, random);
  ShapeEdgeDetection<PointXYZ> detection;
  detection.setInputCloud(toCloud<PointXYZ>(sheet));
  Edges edges;
  detection.detect(edges);
  std::size_t rim = 0, on_rim = 0, inside = 0, on_inside = 0;
  for (std::size_t i = 0; i < sheet.size(); ++i) {
    const Eigen::Vector3d p = sheet.position(i);
    const double to_rim =
        std::min(std::min(p.x(), 1.0 - p.x()), std::min(p.y(), 1.0 - p.y()));
    ASSERT_NE(EdgeType::Crease, edges.types[i]);
    const bool is_boundary = edges.types[i] == EdgeType::OpenBoundary;
    rim += to_rim < 0.002 ? 1 : 0; // a tenth of the spacing
    on_rim += to_rim < 0.002 && is_boundary ? 1 : 0;
    inside += to_rim > 0.03 ? 1 : 0;
    on_inside += to_rim > 0.03 && is_boundary ? 1 : 0;
  }
  EXPECT_GT(static_cast<double>(on_rim), 0.95 * static_cast<double>(rim));
  EXPECT_LT(static_cast<double>(on_inside), 0.01 * static_cast<double>(inside));
}

TEST(EdgeTypes, NeedTheDefaultMode)
{
  ShapeEdgeDetection<PointXYZ> detection;
  detection.setInputCloud(toCloud<PointXYZ>(grid(10, 0.004)));
  detection.setMode(ShapeEdgeDetection<PointXYZ>::PAPER);
  Edges edges;
  expectParts(errorsOf([&] { detection.detect(edges); }),
              {"ShapeEdgeDetection", "kinds of edges", "DEFAULT"});
  EXPECT_TRUE(edges.types.empty());
}

} // namespace
