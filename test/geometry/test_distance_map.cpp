// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Distances in an image beside those to all marked pixels, one by one.

#include "geometry/distance_map.h"
#include "support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace {

using pcl::segmentation::distancesTo;
using pcl::test::Random;

float
distanceOneByOne(const std::vector<char>& marks, int side, int at)
{
  int squared = std::numeric_limits<int>::max();
  for (int other = 0; other < side * side; ++other)
    if (marks[static_cast<std::size_t>(other)] != 0) {
      const int across = other % side - at % side, down = other / side - at / side;
      squared = std::min(squared, across * across + down * down);
    }
  return std::sqrt(static_cast<float>(squared));
}

TEST(DistanceMap, IsThatToTheNearestMark)
{
  Random random(31);
  for (const double share : {0.001, 0.01, 0.1, 0.9})
    for (const int side : {1, 2, 7, 40}) {
      std::vector<char> marks(static_cast<std::size_t>(side * side), 0);
      for (char& mark : marks)
        mark = random.uniform(0.0, 1.0) < share;
      marks[marks.size() / 3] = 1;
      const std::vector<float> distances = distancesTo(marks, side);
      for (int at = 0; at < side * side; ++at)
        ASSERT_EQ(distances[static_cast<std::size_t>(at)],
                  distanceOneByOne(marks, side, at))
            << side << " wide, " << share << " marked, pixel " << at;
    }
}

TEST(DistanceMap, WithoutMarksAllIsFar)
{
  for (const float distance : distancesTo(std::vector<char>(25, 0), 5))
    EXPECT_GT(distance, 1e5f);
}

} // namespace
