// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The steps and bumps of a depth camera are no edges.

#include "detection_scenes.h"

#include <pcl/segmentation/shape_field_estimation.h>

#include <gtest/gtest.h>

#include <cmath>

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
  return cloud;
}

ShapeField
fieldOf(const Cloud::ConstPtr& cloud, double resolution = 0.0)
{
  ShapeFieldEstimation<PointXYZ> estimation;
  estimation.setInputCloud(cloud);
  estimation.setResolution(resolution);
  estimation.setEdgesOnly(true);
  ShapeField field;
  EXPECT_TRUE(estimation.compute(field));
  return field;
}

TEST(SensorSteps, AreLookedAtFromFartherAway)
{
  const auto cloud = steppedRidge(0.0005, 0.002);
  const ShapeField field = fieldOf(cloud);
  EXPECT_GT(field.resolution, 0.0005);
  EXPECT_LT(field.resolution, 0.004);
  std::size_t edges = 0, near = 0, on_ridge = 0, found = 0;
  for (std::size_t i = 0; i < cloud->size(); ++i) {
    const double x = std::abs((*cloud)[i].x);
    const bool is_edge = field.edge_likelihood[i] > 0.5f;
    edges += is_edge ? 1 : 0;
    near += is_edge && x < 0.008 ? 1 : 0;
    on_ridge += x < 0.001 ? 1 : 0;
    found += is_edge && x < 0.001 ? 1 : 0;
  }
  EXPECT_GT(static_cast<double>(near), 0.98 * static_cast<double>(edges));
  EXPECT_GT(static_cast<double>(found), 0.98 * static_cast<double>(on_ridge));
}

TEST(SensorSteps, MakeTheBitsOfTheResolutionThatIsChosen)
{
  const auto cloud = steppedRidge(0.0005, 0.002);
  const ShapeField chosen = fieldOf(cloud);
  const ShapeField given = fieldOf(cloud, chosen.resolution);
  EXPECT_EQ(chosen.resolution, given.resolution);
  EXPECT_TRUE(sameBits(chosen.edge_likelihood, given.edge_likelihood));
  EXPECT_EQ(0.0, fieldOf(steppedRidge(0.002, 1e-6)).resolution);
}

/** A plane with waves, noise that neighbors share, and with some bumps of two spacings.
 */
Cloud::Ptr
bumpyPlane()
{
  constexpr int count = 200, bumps = 150;
  constexpr double spacing = 0.002, wave = 0.1,
                   height = 2.0; // the last two in spacings
  Random random(72);
  std::vector<Eigen::Vector3d> points; // in spacings
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < count; ++j)
      points.emplace_back(i + random.uniform(-0.2, 0.2),
                          j + random.uniform(-0.2, 0.2),
                          wave * std::sin(i * pi / 6.0) * std::sin(j * pi / 6.0));
  for (int bump = 0; bump < bumps; ++bump) {
    const double x = random.uniform(0, count), y = random.uniform(0, count);
    for (Eigen::Vector3d& p : points)
      p.z() +=
          height * std::exp(-0.5 * (std::pow(p.x() - x, 2) + std::pow(p.y() - y, 2)));
  }
  const auto cloud = make_shared<Cloud>();
  for (const Eigen::Vector3d& p : points) {
    const Eigen::Vector3f q = (spacing * p).cast<float>();
    cloud->emplace_back(q.x(), q.y(), 0.6f + q.z());
  }
  return cloud;
}

TEST(SensorSteps, BumpsDoNotPersist)
{
  const ShapeField field = fieldOf(bumpyPlane());
  EXPECT_EQ(0.0, field.resolution);
  std::size_t edges = 0;
  for (const float likelihood : field.edge_likelihood)
    edges += likelihood > 0.5f ? 1 : 0;
  // 0.0086 are edges at the level of the points alone.
  EXPECT_LT(static_cast<double>(edges), 0.002 * static_cast<double>(field.points.size));
}

} // namespace
