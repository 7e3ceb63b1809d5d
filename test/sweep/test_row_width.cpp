// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// How wide rows are: of several densities, sizes and images.

#include "sweep/index/row_width.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

// The width of rows makes no difference to results, but 100 times to the time that they
// take.
namespace {

using pcl::NeighborhoodSize;
using pcl::XYZView;
using pcl::kernels::rowWidth;

constexpr double spacing = 0.002;
constexpr int width = 200, height = 150;

/** \brief A grid of points in a plane; the first columns are missing. */
std::vector<float>
gridImage(int missing_columns)
{
  std::vector<float> xyz;
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      const float nan = std::numeric_limits<float>::quiet_NaN();
      const bool is_missing = u < missing_columns;
      xyz.push_back(is_missing ? nan : static_cast<float>(u * spacing));
      xyz.push_back(is_missing ? nan : static_cast<float>(v * spacing));
      xyz.push_back(is_missing ? nan : 1.0f);
    }
  }
  return xyz;
}

double
widthFor(const NeighborhoodSize& size, const std::vector<float>& xyz)
{
  const XYZView view{xyz.data(), 3, xyz.size() / 3};
  return rowWidth(size, view, view.size);
}

/** \brief The distance within which a grid has n points. */
double
distanceToNearest(double n)
{
  return spacing * std::sqrt(n / M_PI);
}

TEST(RowWidth, IsTheDistanceToTheNearestPoints)
{
  const auto grid = gridImage(0);
  for (const double k : {64.0, 100.0, 500.0}) {
    const double found =
        widthFor(NeighborhoodSize::ofNearest(static_cast<std::size_t>(k)), grid);
    EXPECT_NEAR(found, distanceToNearest(k), 0.35 * distanceToNearest(k)) << k;
  }
}

/** \brief Drivers write 0,0,0 for rays that met nothing. */
TEST(RowWidth, CountsAPlaceOnce)
{
  auto grid = gridImage(0);
  const double without = widthFor(NeighborhoodSize::ofNearest(64), grid);
  std::mt19937 random(1);
  for (std::size_t i = 0; i < grid.size(); i += 3)
    if (random() % 4 != 0)
      std::fill_n(grid.begin() + static_cast<std::ptrdiff_t>(i), 3, 0.0f);
  const double with = widthFor(NeighborhoodSize::ofNearest(64), grid);
  EXPECT_GT(with, without);
  EXPECT_LT(with, 3.0 * without); // points four times as sparse are twice as far apart
}

TEST(RowWidth, IsForAClusterOfPointsAtLeast)
{
  const auto grid = gridImage(0);
  const double dense = widthFor(NeighborhoodSize::ofNearest(64), grid);
  EXPECT_EQ(widthFor(NeighborhoodSize::ofNearest(1), grid), dense);
  EXPECT_EQ(widthFor(NeighborhoodSize::ofRadius(1.5 * spacing), grid), dense);
}

TEST(RowWidth, GrowsWithTheRadius)
{
  const auto grid = gridImage(0);
  EXPECT_DOUBLE_EQ(widthFor(NeighborhoodSize::ofRadius(0.1), grid), 0.07);
  const std::vector<float> radii(grid.size() / 3, 0.125f);
  EXPECT_DOUBLE_EQ(widthFor(NeighborhoodSize::ofRadii(radii.data()), grid), 0.0875);
}

TEST(RowWidth, DoesNotTakeMissingDepthForDensity)
{
  // Every sample would be in the first column of some image: its row starts there.
  for (const int missing : {1, 3, 50}) {
    const double found = widthFor(NeighborhoodSize::ofNearest(64), gridImage(missing));
    EXPECT_NEAR(found, distanceToNearest(64), 0.5 * distanceToNearest(64)) << missing;
  }
}

TEST(RowWidth, OfPointsAtOnePlace)
{
  const std::vector<float> heap(300, 1.0f);
  EXPECT_EQ(widthFor(NeighborhoodSize::ofNearest(10), heap), 1.0);
  EXPECT_DOUBLE_EQ(widthFor(NeighborhoodSize::ofRadius(0.5), heap), 0.35);
}

} // namespace
