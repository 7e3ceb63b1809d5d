// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// How far edge points are from creases.

#include "edges/edge_detection.h"
#include "geometry/point_grid.h"
#include "segmentation/detection_scenes.h"
#include "segmentation/field_of.h"

#include <gtest/gtest.h>

namespace {

using namespace pcl;
using namespace pcl::test;

/** The edge points, and those without a crease within so many bands of their own
 * spacing. */
struct EdgePoints {
  int all = 0, far = 0;
};

EdgePoints
edgePointsOf(const ShapeField& field, float bands)
{
  const float band = bands * segmentation::edgeBand(field.noise_level);
  const segmentation::PointGrid creases(segmentation::positionsOf(field.creases),
                                        0.01f);
  const auto any = [](std::uint32_t, const Eigen::Vector3f&) { return true; };
  EdgePoints points;
  for (std::size_t i = 0; i < field.points.size; ++i)
    if (field.edge_likelihood[i] > 0.5f) {
      const Eigen::Map<const Eigen::Vector3f> place(field.points[i]);
      ++points.all;
      points.far += creases.anyWithin(place, band * field.spacings[i], any) ? 0 : 1;
    }
  return points;
}

// Strays in the shadow of an object are sparse, the table beside them is not.
TEST(EdgeBands, ReachAsFarAsThePointsInThemAreDense)
{
  const auto cloud = cloudOf(cameraScene(805, scene::Noise::Structured));
  const EdgePoints points = edgePointsOf(edgeFieldOf(cloud), 2.1f);
  EXPECT_GT(points.all, 1000);
  EXPECT_EQ(0, points.far);
}

} // namespace
