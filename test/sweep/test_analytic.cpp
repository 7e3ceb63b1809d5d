// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// INAD on spheres and cylinders, where means follow from the surface alone.

#include "support/differences.h"
#include "support/kernel_targets.h"
#include "support/shapes.h"
#include "support/sweep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

// Means that follow from the surface alone.
//
// Around a point of a sphere of radius R, the points at the polar angle t from it are
// at the distance 2 R sin(t/2), have normals at the angle t, and lie on a ring of
// length 2 pi R sin(t). So the angles in a ball of radius r have the density sin(t),
// for 2 R sin(t/2) < r.
//
// Around a point of a cylinder, the points turned by t and z further along the axis are
// at the distance sqrt((2 R sin(t/2))^2 + z^2) and have normals at the angle |t|. At
// each t the ball holds a length of 2 sqrt(r^2 - (2 R sin(t/2))^2) along z: that is the
// density of the angles.
//
// Rejection leaves the part of the density within c sigma of mu.
namespace {

using namespace pcl;
using namespace pcl::test;

constexpr double body_radius = 0.1;
constexpr double radius = 0.3 * body_radius;

using Density = std::function<double(double)>;

double
chord(double angle)
{
  return 2 * body_radius * std::sin(angle / 2);
}

double
densityOnSphere(double angle)
{
  return std::sin(angle);
}

double
densityOnCylinder(double angle)
{
  return std::sqrt(std::max(0.0, radius * radius - chord(angle) * chord(angle)));
}

struct Moments {
  double mean;
  double deviation;
};

Moments
momentsOf(const Density& density, double low, double high)
{
  constexpr int steps = 200000;
  double mass = 0, first = 0, second = 0;
  for (int i = 0; i < steps; ++i) {
    const double angle = low + (high - low) * (i + 0.5) / steps;
    const double weight = density(angle);
    mass += weight;
    first += weight * angle;
    second += weight * angle * angle;
  }
  const double mean = first / mass;
  return {mean, std::sqrt(second / mass - mean * mean)};
}

double
expectedMean(const Density& density, double outlier_rate)
{
  const double largest = 2 * std::asin(radius / body_radius / 2);
  const Moments all = momentsOf(density, 0, largest);
  if (outlier_rate == 0)
    return all.mean;
  const double width = outlier_rate * all.deviation;
  return momentsOf(density,
                   std::max(0.0, all.mean - width),
                   std::min(largest, all.mean + width))
      .mean;
}

double
largestOf(const std::vector<float>& inad)
{
  return *std::max_element(inad.begin(), inad.end());
}

class Analytic : public testing::TestWithParam<std::string> {
protected:
  /** \brief The mean of mu over some points of a surface, which must have enough
   * neighbors. */
  double
  meanOfMu(const Surface& cloud,
           const std::function<bool(const Eigen::Vector3d&)>& is_asked,
           double outlier_rate) const
  {
    std::vector<std::int32_t> asked;
    for (std::size_t i = 0; i < cloud.size(); ++i)
      if (is_asked(cloud.position(i)))
        asked.push_back(static_cast<std::int32_t>(i));
    NeighborhoodSweep sweep(cloud.points());
    sweep.setQueryIndices(asked.data(), asked.size());
    const auto size = NeighborhoodSize::ofRadius(radius);
    const auto counts = sweptCounts(sweep, size);
    EXPECT_GE(*std::min_element(counts.begin(), counts.end()), 100U);
    const auto inad = sweptINAD(sweep, size, cloud.trueNormals(), outlier_rate);
    double mean = 0;
    for (std::size_t i = 0; i < inad.size(); i += 2)
      mean += inad[i] / static_cast<double>(asked.size());
    return mean;
  }

  ForcedTarget target_{GetParam()};
  Random random_{12};
};

TEST_P(Analytic, MeanOnSphere)
{
  const Surface cloud = sphere(8000, body_radius, random_);
  for (const double rate : {0.0, 2.0}) {
    const double expected = expectedMean(densityOnSphere, rate);
    const auto everywhere = [](const Eigen::Vector3d&) { return true; };
    EXPECT_NEAR(expected, meanOfMu(cloud, everywhere, rate), 0.02 * expected) << rate;
  }
}

TEST_P(Analytic, MeanOnCylinder)
{
  const double height = 0.3;
  const Surface cloud = cylinder(12000, body_radius, height, random_);
  const auto awayFromEnds = [=](const Eigen::Vector3d& p) {
    return p.z() > radius && p.z() < height - radius;
  };
  for (const double rate : {0.0, 2.0}) {
    const double expected = expectedMean(densityOnCylinder, rate);
    EXPECT_NEAR(expected, meanOfMu(cloud, awayFromEnds, rate), 0.02 * expected) << rate;
  }
}

TEST_P(Analytic, GivenNormalsOfAPlaneGiveZero)
{
  Surface cloud = plane(4000, 0.2, random_);
  cloud.move(tiltedPose());
  const NeighborhoodSweep sweep(cloud.points());
  for (const auto& size :
       {NeighborhoodSize::ofRadius(0.02), NeighborhoodSize::ofNearest(30)}) {
    const auto inad = sweptINAD(sweep, size, cloud.trueNormals());
    EXPECT_EQ(std::vector<float>(2 * cloud.size(), 0.0f), inad);
  }
}

TEST_P(Analytic, EstimatedNormalsOfAPlaneGiveNearlyZero)
{
  Surface cloud = plane(4000, 0.2, random_);
  const auto expectNearlyZero = [](const Surface& flat) {
    const NeighborhoodSweep sweep(flat.points());
    const auto size = NeighborhoodSize::ofRadius(0.02);
    const auto normals = sweptNormals(sweep, size);
    const auto inad = sweptINAD(sweep, size, {normals.data(), 4, flat.size()});
    EXPECT_LE(largestOf(inad), 1e-4);
    EXPECT_EQ(
        2 * flat.size(),
        static_cast<std::size_t>(std::count_if(
            inad.begin(), inad.end(), [](float value) { return value >= 0.0f; })));
  };
  expectNearlyZero(cloud);
  cloud.move(tiltedPose());
  expectNearlyZero(cloud);
}

/** \brief The mu bin, of ten, that holds the most points. */
std::size_t
peakBin(const Surface& cloud, double ball)
{
  const NeighborhoodSweep sweep(cloud.points());
  const auto size = NeighborhoodSize::ofRadius(ball);
  const auto normals = sweptNormals(sweep, size);
  const auto inad = sweptINAD(sweep, size, {normals.data(), 4, cloud.size()});
  std::vector<int> bins(10);
  for (std::size_t i = 0; i < inad.size(); i += 2)
    ++bins[static_cast<std::size_t>(inad[i] * 20 / pi)];
  return static_cast<std::size_t>(std::max_element(bins.begin(), bins.end()) -
                                  bins.begin());
}

TEST_P(Analytic, PeakOfACylinderMovesUpWithTheRadiusAndThatOfAPlaneStays)
{
  const Surface tube = cylinder(8000, body_radius, 0.5, random_);
  const Surface flat = plane(4000, 0.4, random_);
  std::vector<std::size_t> peaks;
  for (const double ratio : {0.25, 0.55, 0.9}) {
    peaks.push_back(peakBin(tube, ratio * body_radius));
    EXPECT_EQ(0U, peakBin(flat, ratio * body_radius));
  }
  EXPECT_LT(peaks[0], peaks[1]);
  EXPECT_LT(peaks[1], peaks[2]);
}

INSTANTIATE_TEST_SUITE_P(Targets,
                         Analytic,
                         testing::ValuesIn(kernelTargets()),
                         TargetName());

} // namespace
