// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Neighborhoods whose smallest variance is in more than one direction.

#include "support/kernel_targets.h"
#include "support/shapes.h"
#include "support/sweep.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace {

using namespace pcl;
using namespace pcl::test;

class MultipleRoots : public testing::TestWithParam<std::string> {
private:
  const ForcedTarget target_{GetParam()};
};

Surface
lattice(int nx, int ny, int nz, float step)
{
  Surface points;
  for (int x = 0; x < nx; ++x) {
    for (int y = 0; y < ny; ++y) {
      for (int z = 0; z < nz; ++z)
        for (const int i : {x, y, z})
          points.xyz.push_back(step * static_cast<float>(i));
    }
  }
  return points;
}

struct Spread {
  std::size_t points;
  double curvature;
  Eigen::Matrix3d covariance; ///< of trace 1
};

Spread
spreadAround(const Surface& points, std::size_t query, double radius)
{
  const auto at = [&](std::size_t i) {
    return Eigen::Map<const Eigen::Vector3f>(points.points()[i]).cast<double>();
  };
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
  double count = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d offset = at(i) - at(query);
    if (offset.norm() < radius) {
      sum += offset;
      products += offset * offset.transpose();
      ++count;
    }
  }
  Eigen::Matrix3d covariance =
      products / count - sum / count * (sum / count).transpose();
  covariance /= covariance.trace();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance,
                                                              Eigen::EigenvaluesOnly);
  return {static_cast<std::size_t>(count), solver.eigenvalues()[0], covariance};
}

void
expectNormals(const Surface& points, double radius)
{
  const auto found = sweptNormals(NeighborhoodSweep(points.points()),
                                  NeighborhoodSize::ofRadius(radius));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Spread spread = spreadAround(points, i, radius);
    if (spread.points <= NeighborhoodSweep::min_neighbors) {
      ASSERT_TRUE(std::isnan(found[4 * i + 3])) << i;
      continue;
    }
    const auto normal = Eigen::Map<const Eigen::Vector3f>(&found[4 * i]).cast<double>();
    ASSERT_NEAR(found[4 * i + 3], spread.curvature, 1e-5) << i;
    // Which of the directions of the least variance it is, is open.
    ASSERT_NEAR(normal.dot(spread.covariance * normal), spread.curvature, 1e-5) << i;
  }
}

TEST_P(MultipleRoots, OfNinePoints)
{
  Surface points;
  points.xyz = {0, 0, 0, 1, 0, 1, 1, 0, -1, -1, 0, 1, -1, 0, -1};
  points.xyz.insert(points.xyz.end(), {0, 1, 1, 0, 1, -1, 0, -1, 1, 0, -1, -1});
  const auto found =
      sweptNormals(NeighborhoodSweep(points.points()), NeighborhoodSize::ofRadius(2.0));
  EXPECT_NEAR(found[3], 0.25, 1e-6);
  expectNormals(points, 2.0);
}

TEST_P(MultipleRoots, OfLattices)
{
  for (const float step : {0.1f, 0.013f, 1.0f}) {
    for (const double steps : {1.2, 1.5, 1.8, 2.3}) {
      SCOPED_TRACE(std::to_string(step) + " m, radius of steps " +
                   std::to_string(steps));
      expectNormals(lattice(8, 8, 8, step), steps * step);
      expectNormals(lattice(3, 3, 60, step), steps * step);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Targets,
                         MultipleRoots,
                         testing::ValuesIn(kernelTargets()),
                         TargetName());

} // namespace
