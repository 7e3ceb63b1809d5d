// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// INAD from a list of neighbors.

#include "pcl_inad.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace {

MeanAndDeviation
momentsOf(const std::vector<float>& angles)
{
  float sum = 0.0f;
  for (const float a : angles)
    sum += a;
  const float mean = sum / static_cast<float>(angles.size());
  float squares = 0.0f;
  for (const float a : angles)
    squares += (a - mean) * (a - mean);
  return {mean, std::sqrt(squares / static_cast<float>(angles.size()))};
}

} // namespace

MeanAndDeviation
inadAt(const Normals& normals, const pcl::Indices& found, pcl::index_t point)
{
  std::vector<float> angles;
  angles.reserve(found.size());
  const Eigen::Vector3f own = normals[point].getNormalVector3fMap();
  for (const pcl::index_t j : found) {
    const float cosine = std::abs(own.dot(normals[j].getNormalVector3fMap()));
    if (j != point && std::isfinite(cosine))
      angles.push_back(std::acos(std::min(cosine, 1.0f)));
  }
  constexpr std::size_t least = 5;
  if (!std::isfinite(own.x()) || angles.size() < least) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    return {nan, nan};
  }
  const MeanAndDeviation all = momentsOf(angles);
  const auto limit = static_cast<float>(outlier_rate) * all.deviation * (1.0f + 1e-5f);
  const auto rejected = std::remove_if(angles.begin(), angles.end(), [&](float a) {
    return std::abs(a - all.mean) > limit;
  });
  angles.erase(rejected, angles.end());
  return angles.empty() ? all : momentsOf(angles);
}
