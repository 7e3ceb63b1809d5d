// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Distances to the k-th nearest points, exactly as brute force finds them.

#include "support/kernel_targets.h"
#include "support/reference.h"
#include "support/shapes.h"
#include "sweep/block_sweep.h"

#include <pcl/features/neighborhood_sweep.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

// Distances to the k-th nearest points, which tell which points are neighbors, exactly
// as brute force finds them.
namespace {

using namespace pcl;
using namespace pcl::test;

class SweepNearest : public testing::TestWithParam<std::string> {
protected:
  static void
  expectExactDistances(const Surface& cloud, std::initializer_list<std::size_t> ks)
  {
    const XYZView points = cloud.points();
    std::vector<float> distances(cloud.size());
    for (const std::size_t k : ks) {
      NeighborhoodSweep(points).computeDistanceToNearest(k, distances.data());
      for (std::size_t i = 0; i < cloud.size(); ++i) {
        const std::uint32_t last = neighborsNearest(points, points[i], k).back();
        ASSERT_EQ(std::sqrt(squaredDistance(points[last], points[i])), distances[i])
            << k << " nearest of " << i;
      }
    }
  }

  ForcedTarget target_{GetParam()};
  Random random_{2};
};

TEST_P(SweepNearest, OfNoisySurfaces)
{
  Surface scene = mixedScene(3000, random_);
  scene.addNoise(0.0005, random_);
  expectExactDistances(scene, {1, 12, 40, 100, 400});
}

// Queries look first where the query before them found its k-th: here that may be far
// off, and either way.
TEST_P(SweepNearest, WhereTheDensityJumps)
{
  Surface cloud = plane(2000, 0.1, random_);
  for (const double side : {0.004, 0.008}) {
    Surface patch = plane(400, side, random_);
    patch.move(Eigen::Isometry3d(Eigen::Translation3d(0.05, 10 * side, 0)));
    cloud.append(patch);
  }
  expectExactDistances(cloud, {20, 60, 150, 399, 400});
}

TEST_P(SweepNearest, OfManyAtOnePlace)
{
  Surface cloud = plane(500, 0.05, random_);
  for (int i = 0; i < 300; ++i)
    cloud.append(grid(2, 0.015625));
  expectExactDistances(cloud, {50, 300, 301, 700});
}

TEST_P(SweepNearest, AStrayDoesNotMakeTheNextLookFar)
{
  constexpr double edge = 0.02; // to the 25th nearest
  Surface cloud = plane(20000, 1.0, random_);
  cloud.add({{0.5, 0.5, -100.0}, {0, 0, 1}}); // before the others in their order
  const kernels::RowIndex index =
      kernels::buildRowIndex(cloud.points(), nullptr, cloud.size(), edge, 1);
  const kernels::BlockSweep sweep{index, index, NeighborhoodSize::ofNearest(20)};
  std::size_t blocks = 0, most = 0;
  sweep.forEachBlock(1, [&](const kernels::SweepBlock& block, const std::uint32_t*) {
    std::size_t points = 0;
    for (std::size_t r = 0; r < block.run_count; ++r)
      points += block.cluster_begin[block.runs[r].end] -
                block.cluster_begin[block.runs[r].begin];
    if (blocks++ > 0)
      most = std::max(most, points);
    else
      EXPECT_EQ(cloud.size(), points) << "around the stray";
  });
  EXPECT_GT(blocks, cloud.size() / kernels::block_size);
  EXPECT_LT(most, cloud.size() / 8);
}

INSTANTIATE_TEST_SUITE_P(Targets,
                         SweepNearest,
                         testing::ValuesIn(kernelTargets()),
                         TargetName());

} // namespace
