// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The sweep against the scalar reference, over shapes, densities and levels of noise.

#include "support/differences.h"
#include "support/kernel_targets.h"
#include "support/reference.h"
#include "support/shapes.h"
#include "support/sweep.h"

#include <gtest/gtest.h>

#include <functional>
#include <tuple>

namespace {

using namespace pcl;
using namespace pcl::test;

constexpr double radius = 0.02;
constexpr double outlier_rate = 2.0;

struct Shape {
  const char* name;
  std::function<Surface(std::size_t, Random&)> sample;
};

template <int degrees>
Surface
dihedralOf(std::size_t count, Random& random)
{
  return dihedral(count, degrees, 0.1, random);
}

const std::vector<Shape>&
shapes()
{
  static const std::vector<Shape> all{
      {"Plane", [](std::size_t n, Random& r) { return plane(n, 0.1, r); }},
      {"Sphere", [](std::size_t n, Random& r) { return sphere(n, 0.04, r); }},
      {"Cylinder", [](std::size_t n, Random& r) { return cylinder(n, 0.03, 0.1, r); }},
      {"Dihedral30", dihedralOf<30>},
      {"Dihedral60", dihedralOf<60>},
      {"Dihedral90", dihedralOf<90>},
      {"Dihedral120", dihedralOf<120>},
      {"Dihedral150", dihedralOf<150>},
      {"Cone", [](std::size_t n, Random& r) { return cone(n, 0.1, r); }},
      {"RandomCloud", [](std::size_t n, Random& r) { return randomCloud(n, 0.1, r); }}};
  return all;
}

std::vector<Surface>
cloudsOf(const Shape& shape)
{
  std::vector<Surface> clouds;
  Random random(1);
  for (const std::size_t count : {200U, 500U, 1500U}) {
    for (const double noise : {0.0, 0.0003, 0.0012}) {
      Surface cloud = shape.sample(count, random);
      cloud.move(tiltedPose());
      cloud.addNoise(noise, random);
      clouds.push_back(cloud);
    }
  }
  return clouds;
}

std::vector<Found>
foundIn(const Surface& cloud)
{
  std::vector<Found> found;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    found.push_back(neighborsWithin(cloud.points(), cloud.points()[i], radius));
  return found;
}

class SweepExact : public testing::TestWithParam<std::tuple<std::string, std::size_t>> {
protected:
  ForcedTarget target_{std::get<0>(GetParam())};
  std::vector<Surface> clouds_ = cloudsOf(shapes()[std::get<1>(GetParam())]);
  NeighborhoodSize size_ = NeighborhoodSize::ofRadius(radius);
};

TEST_P(SweepExact, CountsAreEqual)
{
  for (const Surface& cloud : clouds_) {
    const auto counts = sweptCounts(NeighborhoodSweep(cloud.points()), size_);
    const std::vector<Found> found = foundIn(cloud);
    for (std::size_t i = 0; i < cloud.size(); ++i)
      ASSERT_EQ(found[i].size() - 1, counts[i]) << i << " of " << cloud.size();
  }
}

TEST_P(SweepExact, NormalsAreTheEigenvectors)
{
  Differences angles, curvatures;
  for (const Surface& cloud : clouds_) {
    const auto normals = sweptNormals(NeighborhoodSweep(cloud.points()), size_);
    const std::vector<Found> found = foundIn(cloud);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const ReferenceNormal expected = referenceNormal(cloud.points(), found[i]);
      const Eigen::Vector3d normal = vectorAt({normals.data(), 4, cloud.size()}, i);
      curvatures.add(expected.curvature, normals[4 * i + 3]);
      // The direction means nothing where two eigenvalues are nearly equal.
      if (!(expected.gap < 0.01)) {
        angles.add(
            std::isnan(expected.gap) ? unknown : 0,
            acuteAngle(expected.normal.array().isNaN().any() ? normal : expected.normal,
                       normal));
        ASSERT_TRUE(normal.array().isNaN().any() || std::abs(normal.norm() - 1) < 1e-6);
      }
    }
  }
  EXPECT_GT(angles.known(), 3000U);
  EXPECT_GE(angles.within(1e-5), 0.99);
  EXPECT_GE(angles.within(1e-4), 0.9999);
  EXPECT_GE(curvatures.within(1e-6), 0.9999);
}

Differences
inadDifferences(const Surface& cloud,
                const std::vector<Found>& found,
                const std::vector<float>& normals,
                double rate)
{
  const XYZView view{normals.data(), 4, cloud.size()};
  const NeighborhoodSweep sweep(cloud.points());
  const auto result = sweptINAD(sweep, NeighborhoodSize::ofRadius(radius), view, rate);
  Differences differences;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const ReferenceINAD expected =
        referenceINAD(view, vectorAt(view, i), without(found[i], i), rate);
    differences.add(expected.mu, result[2 * i]);
    differences.add(expected.sigma, result[2 * i + 1]);
  }
  return differences;
}

TEST_P(SweepExact, INADIsWithinRounding)
{
  Differences all;
  for (const Surface& cloud : clouds_) {
    const std::vector<Found> found = foundIn(cloud);
    const auto normals = sweptNormals(NeighborhoodSweep(cloud.points()), size_);
    for (const double rate : {outlier_rate, 0.0})
      all.add(inadDifferences(cloud, found, normals, rate));
  }
  EXPECT_GT(all.known(), 15000U);
  EXPECT_GE(all.within(1e-5), 0.999);
  EXPECT_GE(all.within(2e-6), 0.99);
}

INSTANTIATE_TEST_SUITE_P(Shapes,
                         SweepExact,
                         testing::Combine(testing::ValuesIn(kernelTargets()),
                                          testing::Range(std::size_t{0},
                                                         shapes().size())),
                         [](const auto& test) {
                           return std::get<0>(test.param) +
                                  shapes()[std::get<1>(test.param)].name;
                         });

} // namespace
