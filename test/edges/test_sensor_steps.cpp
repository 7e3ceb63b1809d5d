// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The steps and bumps of a depth camera are no edges.

#include "segmentation/bumpy_plane.h"
#include "segmentation/detection_scenes.h"
#include "segmentation/field_of.h"

#include <pcl/segmentation/means_of_parts.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

using namespace pcl;
using namespace pcl::test;

constexpr double crease_angle = pi / 2.0;

/** A ridge along y, seen from above, 0.16 m wide; its depth has steps of so many
 * meters. */
Cloud::Ptr
steppedRidge(double spacing, double step)
{
  constexpr double half = 0.08, distance = 0.6;
  Random random(71);
  const auto count = static_cast<int>(2.0 * half / spacing);
  const auto cloud = make_shared<Cloud>();
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < count; ++j) {
      const double x = spacing * (i + random.uniform(-0.3, 0.3)) - half;
      const double y = spacing * (j + random.uniform(-0.3, 0.3)) - half;
      const double z = distance + std::tan(0.5 * (pi - crease_angle)) * std::abs(x);
      cloud->emplace_back(static_cast<float>(x),
                          static_cast<float>(y),
                          static_cast<float>(step * std::round(z / step)));
    }
  for (int stray = 0; stray < 50; ++stray) // whose voxels have no others around
    cloud->emplace_back(static_cast<float>(random.uniform(-half, half)),
                        static_cast<float>(random.uniform(-half, half)),
                        static_cast<float>(distance + random.uniform(0.1, 0.2)));
  return cloud;
}

/** \param[in] near from the crease at x = 0, where edges may be, meters \param[in] on
 * it, where points should be edges \param[in] share of these */
void
expectEdgesAlongY(const ShapeField& field, double near, double on, double share)
{
  std::size_t edges = 0, right = 0, crease = 0, found = 0;
  for (std::size_t i = 0; i < field.points.size; ++i) {
    const double x = std::abs(field.points[i][0]);
    const bool is_edge = field.edge_likelihood[i] > 0.5f;
    edges += is_edge ? 1 : 0;
    right += is_edge && x < near ? 1 : 0;
    crease += x < on ? 1 : 0;
    found += is_edge && x < on ? 1 : 0;
  }
  EXPECT_GT(static_cast<double>(right), 0.98 * static_cast<double>(edges));
  EXPECT_GT(static_cast<double>(found), share * static_cast<double>(crease));
}

TEST(SensorSteps, AreLookedAtFromFartherAway)
{
  const auto cloud = steppedRidge(0.0005, 0.002);
  const ShapeField field = edgeFieldOf(cloud);
  EXPECT_GT(field.resolution, 0.0005);
  EXPECT_LT(field.resolution, 0.004);
  expectEdgesAlongY(field, 0.008, 0.001, 0.98);
}

/** Where two walls meet, 3.5 m before a depth camera. Its depths come in the steps of a
 * Kinect's disparities, 35 mm and six pixels wide here, a fifth of them in the next
 * one.
 */
Cloud::Ptr
corner(double disparity_step)
{
  constexpr double focal_length = 575.0, distance = 3.5; // pixels, meters
  constexpr int half = 110;                              // pixels
  Random random(72);
  const auto cloud = make_shared<Cloud>();
  for (int row = -half; row < half; ++row)
    for (int column = -half; column < half; ++column) {
      const double x = column / focal_length, y = row / focal_length;
      const double left = distance / (1.0 - 0.6 * x),
                   right = distance / (1.0 + 1.2 * x);
      const double jitter = random.uniform(-0.2, 0.2);
      const double disparity =
          disparity_step *
          std::round(1.0 / (std::min(left, right) * disparity_step) + jitter);
      const double z = 1.0 / disparity;
      cloud->emplace_back(
          static_cast<float>(x * z), static_cast<float>(y * z), static_cast<float>(z));
    }
  return cloud;
}

TEST(SensorSteps, AreSeenIfTheyAreWiderThanNeighborhoods)
{
  const auto cloud = corner(0.00287);
  const ShapeField field = edgeFieldOf(cloud);
  EXPECT_GT(field.resolution, 0.0061); // the distance between points
  expectEdgesAlongY(field, 0.15, 0.01, 0.9);
}

TEST(SensorSteps, ThatAreWideAreSeenInAnyOrder)
{
  const auto cloud = corner(0.00287);
  const auto reversed = make_shared<Cloud>(*cloud);
  std::reverse(reversed->begin(), reversed->end());
  const ShapeField field = edgeFieldOf(cloud), other = edgeFieldOf(reversed);
  EXPECT_EQ(field.resolution, other.resolution);
  std::vector<float> likelihood = other.edge_likelihood;
  std::reverse(likelihood.begin(), likelihood.end());
  EXPECT_TRUE(sameBits(field.edge_likelihood, likelihood));
}

TEST(SensorSteps, AreNotSeenOnWallsWithoutThem)
{
  EXPECT_EQ(0.0, edgeFieldOf(corner(1e-7)).resolution);
}

/** Both sides of a tilted plate. */
Cloud::Ptr
plate(double spacing, double thickness)
{
  constexpr int half = 75;
  Random random(73);
  const auto cloud = make_shared<Cloud>();
  for (const double side : {0.0, thickness})
    for (int i = -half; i < half; ++i)
      for (int j = -half; j < half; ++j) {
        const double x = spacing * (i + random.uniform(-0.3, 0.3));
        const double y = spacing * (j + random.uniform(-0.3, 0.3));
        cloud->emplace_back(static_cast<float>(x),
                            static_cast<float>(y),
                            static_cast<float>(1.0 + 0.3 * x + 0.2 * y + side));
      }
  return cloud;
}

TEST(SensorSteps, AreNotTheSidesOfThinPlates)
{
  constexpr double spacing = 0.001;
  for (const double thickness : {3.0, 4.0, 5.0, 6.0})
    EXPECT_EQ(0.0, edgeFieldOf(plate(spacing, thickness * spacing)).resolution)
        << thickness;
}

TEST(SensorSteps, MakeTheBitsOfTheResolutionThatIsChosen)
{
  const auto cloud = steppedRidge(0.0005, 0.002);
  const ShapeField chosen = edgeFieldOf(cloud);
  ASSERT_GT(chosen.resolution, 0.0);
  const ShapeField given = edgeFieldOf(cloud, chosen.resolution);
  EXPECT_EQ(chosen.resolution, given.resolution);
  EXPECT_TRUE(sameBits(chosen.edge_likelihood, given.edge_likelihood));
  EXPECT_EQ(0.0, edgeFieldOf(steppedRidge(0.002, 1e-6)).resolution);
}

TEST(SensorSteps, AreSeenThroughATooFineResolution)
{
  const auto cloud = steppedRidge(0.0005, 0.002);
  const double fine = 0.5 * edgeFieldOf(cloud).resolution;
  EXPECT_GT(edgeFieldOf(cloud, fine).resolution, fine);
}

TEST(SensorSteps, StayWithNormalsOfOnesOwn)
{
  const auto cloud = steppedRidge(0.0005, 0.002);
  const auto normals =
      make_shared<PointCloud<Normal>>(cloud->size(), 1, Normal(0, 0, -1));
  ShapeFieldEstimation<PointXYZ> estimation;
  estimation.setInputCloud(cloud);
  estimation.setInputNormals(normals);
  estimation.setEdgesOnly(true);
  ShapeField field;
  EXPECT_TRUE(estimation.compute(field));
  EXPECT_EQ(0.0, field.resolution);
}

TEST(SensorSteps, AreNoSurfaceWhereMeansFillAVolume)
{
  CloudNumbers steps;
  steps.spacing = 0.002f;
  steps.noise_level = 0.3;
  steps.noise_correlation = 1.0;
  constexpr std::uint64_t many = 100000, few = 10000;
  EXPECT_EQ(0.0016, coarserResolution(steps, many, 0.0));
  EXPECT_EQ(0.0016, coarserResolution(steps, many, 0.001));
  EXPECT_EQ(0.0, coarserResolution(steps, many, 0.0015)); // hardly coarser
  EXPECT_EQ(0.0, coarserResolution(steps, few, 0.0));
  CloudNumbers others = steps;
  others.noise_correlation = 0.9;
  EXPECT_EQ(0.0, coarserResolution(others, many, 0.0));
  others = steps;
  others.noise_level = 0.29;
  EXPECT_EQ(0.0, coarserResolution(others, many, 0.0));
  others = steps;
  others.spacing = 0.0f;
  EXPECT_EQ(0.0, coarserResolution(others, many, 0.0));
}

TEST(SensorSteps, BumpsDoNotPersist)
{
  const ShapeField field = edgeFieldOf(bumpyPlane(2.0));
  EXPECT_EQ(0.0, field.resolution);
  std::size_t edges = 0;
  for (const float likelihood : field.edge_likelihood)
    edges += likelihood > 0.5f ? 1 : 0;
  // 0.0086 are edges at the level of the points alone.
  EXPECT_LT(static_cast<double>(edges), 0.002 * static_cast<double>(field.points.size));
}

} // namespace
