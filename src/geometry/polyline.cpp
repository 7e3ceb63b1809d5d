// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Lines through points: simplification and length.

#include "geometry/polyline.h"

#include <algorithm>
#include <utility>

namespace pcl::segmentation {
namespace {

using Eigen::Vector3f;

float
distanceToSegment(const Vector3f& point, const Vector3f& begin, const Vector3f& end)
{
  const Vector3f along = end - begin;
  const float squared = along.squaredNorm();
  const float t = squared > 0.0f ? (point - begin).dot(along) / squared : 0.0f;
  return (point - begin - std::clamp(t, 0.0f, 1.0f) * along).norm();
}

} // namespace

std::vector<Vector3f>
simplified(const std::vector<Vector3f>& line, float tolerance)
{
  std::vector<char> stays(line.size(), 0);
  std::vector<std::pair<std::size_t, std::size_t>> parts;
  if (!line.empty()) {
    stays.front() = stays.back() = 1;
    parts.emplace_back(0, line.size() - 1);
  }
  while (!parts.empty()) {
    const auto [first, last] = parts.back();
    parts.pop_back();
    std::size_t farthest = first;
    float most = tolerance;
    for (std::size_t i = first + 1; i < last; ++i) {
      const float distance = distanceToSegment(line[i], line[first], line[last]);
      if (distance > most) {
        most = distance;
        farthest = i;
      }
    }
    if (farthest != first) {
      stays[farthest] = 1;
      parts.emplace_back(first, farthest);
      parts.emplace_back(farthest, last);
    }
  }
  std::vector<Vector3f> result;
  for (std::size_t i = 0; i < line.size(); ++i)
    if (stays[i])
      result.push_back(line[i]);
  return result;
}

float
lengthOf(const std::vector<Vector3f>& line)
{
  float length = 0.0f;
  for (std::size_t i = 1; i < line.size(); ++i)
    length += (line[i] - line[i - 1]).norm();
  return length;
}

} // namespace pcl::segmentation
