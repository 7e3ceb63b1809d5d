// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Where noise grows with the spacing, what is near is looked at more closely.

#include "detection_scenes.h"
#include "field_of.h"
#include "measured_numbers.h"

#include <pcl/segmentation/shape_instance_segmentation.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace {

using namespace pcl;
using namespace pcl::test;

constexpr double focal_length = 575.0; // pixels
constexpr int half_width = 110, half_height = 110;
constexpr double kinect_step = 0.00287; // of 1 / depth, 1 / meters

/** Two walls meet in a corner; they fill a part of an image. */
struct Corner {
  double distance = 1.0; ///< meters
  int column = 0;        ///< in which they meet
};

double
depthAt(const Corner& corner, int column)
{
  const double x = (column - corner.column) / focal_length;
  return std::min(corner.distance / (1.0 - 0.6 * x), corner.distance / (1.0 + 1.2 * x));
}

/** One beside the other. \param[in] step of the disparities, a fifth of which are in
 * the next one */
Cloud::Ptr
image(const std::vector<Corner>& corners, double step)
{
  Random random(72);
  const auto cloud = make_shared<Cloud>();
  for (const Corner& corner : corners)
    for (int row = -half_height; row < half_height; ++row)
      for (int i = -half_width; i < half_width; ++i) {
        const int column = corner.column + i;
        const double disparity =
            step * std::round(1.0 / (depthAt(corner, column) * step) +
                              random.uniform(-0.2, 0.2));
        const double z = 1.0 / disparity;
        cloud->emplace_back(static_cast<float>(column / focal_length * z),
                            static_cast<float>(row / focal_length * z),
                            static_cast<float>(z));
      }
  return cloud;
}

/** The walls of a room, and a box that is three times as near. */
Cloud::Ptr
nearAndFar(double step = kinect_step)
{
  return image({{1.1, -2 * half_width}, {3.5, 0}, {3.5, 2 * half_width}}, step);
}

struct Edges {
  double right = 0.0; ///< the share of those that are near where walls meet
  double found = 0.0; ///< the share of points where walls meet that are edges
};

/** \param[in] near where edges may be, meters \param[in] on where points should be */
Edges
edgesOf(const ShapeField& field, const Corner& corner, double near, double on)
{
  double edges = 0.0, right = 0.0, crease = 0.0, found = 0.0;
  for (std::size_t i = 0; i < field.points.size; ++i) {
    const float* const p = field.points[i];
    const double column = p[0] / p[2] * focal_length;
    if (std::abs(column - corner.column) >= half_width)
      continue;
    const double x = std::abs(column - corner.column) / focal_length * p[2];
    const bool is_edge = field.edge_likelihood[i] > 0.5f;
    edges += is_edge ? 1.0 : 0.0;
    right += is_edge && x < near ? 1.0 : 0.0;
    crease += x < on ? 1.0 : 0.0;
    found += is_edge && x < on ? 1.0 : 0.0;
  }
  return {right / edges, found / crease};
}

ShapeField
oneResolution(const Cloud::Ptr& cloud)
{
  ShapeFieldEstimation<PointXYZ> estimation;
  estimation.setEdgesOnly(true);
  estimation.setOneResolution(true);
  EXPECT_TRUE(estimation.getOneResolution());
  return fieldOf(cloud, estimation);
}

TEST(ResolutionZones, ShowWhatIsNearMoreClosely)
{
  const auto cloud = nearAndFar();
  const ShapeField field = edgeFieldOf(cloud);
  EXPECT_LT(field.finest_resolution, 0.003);
  EXPECT_GT(field.resolution, 0.0061); // the distance between far points
  const Edges near = edgesOf(field, {1.1, -2 * half_width}, 0.015, 0.003);
  EXPECT_GT(near.right, 0.95);
  EXPECT_GT(near.found, 0.95);
  for (const int column : {0, 2 * half_width}) {
    const Edges far = edgesOf(field, {3.5, column}, 0.15, 0.01);
    EXPECT_GT(far.right, 0.95) << column;
    EXPECT_GT(far.found, 0.9) << column;
  }
  const ShapeField other = oneResolution(cloud);
  EXPECT_EQ(other.finest_resolution, other.resolution);
  EXPECT_LE(field.resolution, other.resolution);
  EXPECT_LT(edgesOf(other, {1.1, -2 * half_width}, 0.015, 0.003).right, near.right);
}

TEST(ResolutionZones, AreTheSameInAnyOrderAndForAnyThreads)
{
  const auto cloud = nearAndFar();
  const auto reversed = make_shared<Cloud>(*cloud);
  std::reverse(reversed->begin(), reversed->end());
  const ShapeField field = fieldOf(cloud, 1);
  ASSERT_LT(field.finest_resolution, field.resolution);
  ShapeField other = fieldOf(reversed, 2);
  EXPECT_EQ(field.finest_resolution, other.finest_resolution);
  EXPECT_EQ(field.resolution, other.resolution);
  for (std::vector<float>* values :
       {&other.edge_likelihood, &other.spacings, &other.likelihoods.at(0)})
    std::reverse(values->begin(), values->end());
  EXPECT_TRUE(sameBits(field.edge_likelihood, other.edge_likelihood));
  EXPECT_TRUE(sameBits(field.spacings, other.spacings));
  EXPECT_TRUE(sameBits(field.likelihoods.at(0), other.likelihoods.at(0)));
}

TEST(ResolutionZones, HaveSpacingsOfTheirOwn)
{
  const ShapeField field = edgeFieldOf(nearAndFar());
  std::vector<float> near, far;
  for (std::size_t i = 0; i < field.points.size; ++i)
    (field.points[i][2] < 2.0f ? near : far).push_back(field.spacings[i]);
  std::sort(near.begin(), near.end());
  std::sort(far.begin(), far.end());
  EXPECT_LT(4.0f * near[near.size() / 2], far[far.size() / 2]);
}

TEST(ResolutionZones, AreNoneWithoutNoise)
{
  const ShapeField field = edgeFieldOf(nearAndFar(1e-7));
  EXPECT_EQ(0.0, field.resolution);
  EXPECT_EQ(0.0, field.finest_resolution);
}

TEST(ResolutionZones, AreNoneInPartsOfClouds)
{
  const auto cloud = nearAndFar();
  const ShapeField field = edgeFieldOf(cloud, measuredNumbers(*cloud));
  EXPECT_EQ(0.0, field.resolution);
  EXPECT_FALSE(field.base);
}

TEST(ResolutionZones, AreTheSameWithUnknownPoints)
{
  const auto cloud = nearAndFar();
  const ShapeField field = edgeFieldOf(cloud);
  ASSERT_LT(field.finest_resolution, field.resolution);
  const std::size_t points = cloud->size();
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  cloud->insert(cloud->end(), 2 * points, PointXYZ(nan, nan, nan));
  cloud->is_dense = false;
  std::vector<float> likelihood = edgeFieldOf(cloud).edge_likelihood;
  likelihood.resize(points);
  EXPECT_TRUE(sameBits(field.edge_likelihood, likelihood));
}

TEST(ResolutionZones, AreNoneAtOneDistance)
{
  const ShapeField field = edgeFieldOf(image({{3.5, 0}}, kinect_step));
  EXPECT_GT(field.resolution, 0.0);
  EXPECT_EQ(field.resolution, field.finest_resolution);
}

TEST(ResolutionZones, AreNoFinerThanWhatIsSet)
{
  constexpr double set = 0.005;
  EXPECT_GE(edgeFieldOf(nearAndFar(), set).finest_resolution, set);
}

TEST(ResolutionZones, InstancesHaveThePointsOfBoth)
{
  const auto cloud = nearAndFar();
  ShapeInstanceSegmentation<PointXYZ> segmentation;
  segmentation.setInputCloud(cloud);
  segmentation.setClass("planar");
  std::vector<ShapeInstance> instances;
  ASSERT_TRUE(segmentation.segment(instances));
  std::size_t near = 0, far = 0;
  for (const ShapeInstance& instance : instances)
    for (const index_t i : instance.indices)
      ++((*cloud)[static_cast<std::size_t>(i)].z < 2.0f ? near : far);
  const std::size_t of_a_corner = 4 * half_width * half_height;
  EXPECT_GT(near, of_a_corner * 8 / 10);
  EXPECT_GT(far, 2 * of_a_corner * 8 / 10);
}

} // namespace
