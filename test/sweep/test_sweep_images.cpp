// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// k nearest points in depth images, whose density falls by a factor of 1000.

#include "support/heap_count.h"
#include "support/kernel_targets.h"
#include "support/reference.h"
#include "support/shapes.h"
#include "support/sweep.h"

#include <gtest/gtest.h>

// k nearest points in images: the size of the cells comes from a few points' distances,
// which in an image may all be of one column.
namespace {

using namespace pcl;
using namespace pcl::test;

constexpr int width = 160, height = 120;

/** \brief What a camera sees of a wall that goes from 0.4 to 4 m: the density falls by
 * a factor of 1000. The first columns have no depth. */
Surface
slantedWall(int columns_without_depth)
{
  constexpr double focal_length = 131;
  constexpr double nearest = 0.4, furthest = 4;
  Random random(14);
  Surface image;
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      const double share = (u + 0.5) / width;
      const double z = 1 / (1 / nearest + share * (1 / furthest - 1 / nearest)) +
                       0.001 * random.normal();
      const Eigen::Vector3d ray(
          (u - width / 2.0) / focal_length, (v - height / 2.0) / focal_length, 1);
      const double depth =
          u < columns_without_depth ? std::numeric_limits<double>::quiet_NaN() : z;
      image.add({depth * ray, {0, 0, 1}});
    }
  }
  return image;
}

class SweepImages : public testing::TestWithParam<std::string> {
protected:
  ForcedTarget target_{GetParam()};
};

TEST_P(SweepImages, NearestPoints)
{
  const Surface image = slantedWall(3);
  std::vector<float> distances(image.size());
  for (const std::size_t k : {10U, 100U}) {
    NeighborhoodSweep(image.points()).computeDistanceToNearest(k, distances.data());
    for (std::size_t i = 0; i < image.size(); i += 331) {
      const float* query = image.points()[i];
      if (std::isnan(query[0])) {
        EXPECT_TRUE(std::isnan(distances[i]));
        continue;
      }
      const Found found = neighborsNearest(image.points(), query, k);
      EXPECT_EQ(std::sqrt(squaredDistance(image.points()[found.back()], query)),
                distances[i]);
    }
  }
}

/** \brief With cells that are much too large, all points would be candidates of each,
 * and a buffer would have to hold them. */
TEST_P(SweepImages, CellsFitWhereTheFirstColumnsHaveNoDepth)
{
  std::vector<float> distances(std::size_t{width} * height);
  const auto bytesOf = [&](const Surface& image) {
    return peakBytesOf([&] {
      NeighborhoodSweep sweep(image.points());
      sweep.setNumberOfThreads(1);
      sweep.computeDistanceToNearest(10, distances.data());
    });
  };
  const std::ptrdiff_t whole = bytesOf(slantedWall(0));
  for (const int columns : {1, 3}) {
    SCOPED_TRACE(columns);
    EXPECT_LT(bytesOf(slantedWall(columns)), whole + 200000);
  }
  // An index, the sampled distances, and buffers.
  EXPECT_LT(whole, 56 * width * height + 1000000);
}

INSTANTIATE_TEST_SUITE_P(Targets,
                         SweepImages,
                         testing::ValuesIn(kernelTargets()),
                         TargetName());

} // namespace
