// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Clouds of every small size: whole and partial vectors of each instruction set.

#include "support/differences.h"
#include "support/kernel_targets.h"
#include "support/reference.h"
#include "support/shapes.h"
#include "support/sweep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

// Clouds of every small size, all of which is every point's neighborhood: whole and
// partial vectors of each instruction set. The cloud is compared with the reference.
namespace {

using namespace pcl;
using namespace pcl::test;

constexpr std::size_t largest_small_size = 67;
constexpr std::size_t large_size = 2000;

using Find = std::function<Found(std::size_t)>;

class SweepSizes : public testing::TestWithParam<std::string> {
protected:
  void
  compare(const Surface& cloud, const NeighborhoodSize& size, const Find& find)
  {
    SCOPED_TRACE(cloud.size());
    const NeighborhoodSweep sweep(cloud.points());
    const XYZView true_normals = cloud.trueNormals();
    const auto counts = sweptCounts(sweep, size);
    const auto normals = sweptNormals(sweep, size);
    const auto inad = sweptINAD(sweep, size, true_normals);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const Found found = find(i), others = without(found, i);
      ASSERT_EQ(others.size(), counts[i]) << "point " << i;
      const ReferenceNormal normal = referenceNormal(cloud.points(), found);
      const Eigen::Vector3d result = vectorAt({normals.data(), 4, cloud.size()}, i);
      ASSERT_EQ(std::isnan(normal.curvature), std::isnan(result.x())) << "point " << i;
      curvatures_.add(normal.curvature, normals[4 * i + 3]);
      // The direction means nothing where two eigenvalues are nearly equal.
      if (normal.gap >= 0.01)
        angles_.add(0, acuteAngle(normal.normal, result));
      const ReferenceINAD expected =
          referenceINAD(true_normals, vectorAt(true_normals, i), others, 2.0);
      inad_.add(expected.mu, inad[2 * i]);
      inad_.add(expected.sigma, inad[2 * i + 1]);
    }
  }

  void
  compareWithin(const Surface& cloud, double radius)
  {
    const XYZView points = cloud.points();
    compare(cloud, NeighborhoodSize::ofRadius(radius), [&](std::size_t i) {
      return neighborsWithin(points, points[i], radius);
    });
  }

  void
  compareNearest(const Surface& cloud, std::size_t k)
  {
    SCOPED_TRACE(k);
    const XYZView points = cloud.points();
    compare(cloud, NeighborhoodSize::ofNearest(k), [&](std::size_t i) {
      return neighborsNearest(points, points[i], k);
    });
    std::vector<float> distances(cloud.size());
    NeighborhoodSweep(points).computeDistanceToNearest(k, distances.data());
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const std::uint32_t last = neighborsNearest(points, points[i], k).back();
      ASSERT_EQ(std::sqrt(squaredDistance(points[last], points[i])), distances[i]);
    }
  }

  /** \param[in] sample makes a cloud of that many points, 0.08 m across */
  void
  compareAllSizes(const std::function<Surface(std::size_t)>& sample)
  {
    for (std::size_t count = 0; count <= largest_small_size; ++count) {
      const Surface cloud = sample(count);
      compareWithin(cloud, 0.2);
      compareWithin(cloud, 0.03);
      for (const std::size_t k : {count, (count + 1) / 2})
        if (k > 0)
          compareNearest(cloud, k);
    }
    const Surface cloud = sample(large_size);
    compareWithin(cloud, 0.015);
    compareNearest(cloud, 33);
    expectWithinRounding();
  }

  void
  expectWithinRounding() const
  {
    EXPECT_GT(angles_.known(), 8000U);
    EXPECT_GE(angles_.within(1e-4), 0.999);
    EXPECT_GE(curvatures_.within(1e-6), 0.999);
    EXPECT_GT(inad_.known(), 20000U);
    EXPECT_GE(inad_.within(1e-5), 0.999);
  }

  ForcedTarget target_{GetParam()};
  Random random_{13};
  Differences angles_, curvatures_, inad_;
};

TEST_P(SweepSizes, Plane)
{
  compareAllSizes([&](std::size_t count) {
    Surface cloud = plane(count, 0.08, random_);
    cloud.move(tiltedPose());
    return cloud;
  });
}

TEST_P(SweepSizes, Sphere)
{
  compareAllSizes([&](std::size_t count) { return sphere(count, 0.04, random_); });
}

TEST_P(SweepSizes, RandomCloudWithRandomNormals)
{
  compareAllSizes([&](std::size_t count) {
    Surface cloud = randomCloud(count, 0.08, random_);
    for (float& value : cloud.normals)
      value = static_cast<float>(random_.uniform(-1, 1));
    return cloud;
  });
}

TEST_P(SweepSizes, RadiusFarBeyondTheCloud)
{
  Surface cloud = plane(300, 0.08, random_);
  cloud.move(tiltedPose());
  for (const double radius : {1e1, 1e2, 1e4, 1e6, 1e12, 1e30})
    compareWithin(cloud, radius);
  EXPECT_EQ(angles_.known(), 6 * cloud.size());
  EXPECT_EQ(angles_.within(1e-4), 1.0);
  EXPECT_EQ(curvatures_.within(1e-6), 1.0);
}

INSTANTIATE_TEST_SUITE_P(Targets,
                         SweepSizes,
                         testing::ValuesIn(kernelTargets()),
                         TargetName());

} // namespace
