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
  setNoise(all.measureNoise(numbers, cloud.size()), numbers);
  return numbers;
}

} // namespace pcl::test
