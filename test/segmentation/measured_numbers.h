// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The numbers of a cloud of finite places, measured as if it were one part.

#pragma once

#include <pcl/features/cloud_numbers.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/features/impl/neighborhoods.hpp>

#include <algorithm>
#include <limits>
#include <vector>

namespace pcl::test {

inline CloudNumbers
measuredNumbers(const PointCloud<PointXYZ>& cloud)
{
  const PartOfCloud all(detail::xyzOf(cloud), std::vector<bool>(cloud.size(), true), 1);
  std::vector<float> distances =
      all.measureDistances(std::numeric_limits<double>::infinity());
  const auto middle =
      distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  CloudNumbers numbers;
  numbers.distance = static_cast<double>(*middle);
  numbers.spacing = spacingAt(*middle, numbers.distance);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [low, high] = std::minmax_element(
        cloud.begin(), cloud.end(), [axis](const PointXYZ& a, const PointXYZ& b) {
          return a.data[axis] < b.data[axis];
        });
    numbers.low[axis] = low->data[axis];
    numbers.high[axis] = high->data[axis];
  }
  setNoise(all.measureNoise(numbers, cloud.size()), numbers);
  return numbers;
}

} // namespace pcl::test
