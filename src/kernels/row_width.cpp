/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "row_width.h"

#include "finite.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace pcl::kernels {
namespace {

/** \brief A finite point at this position, or the first one after it. In an image, the
 * same column of many rows may have no depth. */
const float*
finitePointFrom(const XYZView& points, std::size_t position)
{
  while (!isFinite(points[position])) {
    position = (position + 1) % points.size;
  }
  return points[position];
}

/** \brief The k-th smallest of the distances from a point to each `stride`-th point
 * elsewhere; infinity if there are fewer. */
float
distanceToNearest(const XYZView& surface,
                  const float* from,
                  std::size_t stride,
                  std::size_t k,
                  std::vector<float>& squares)
{
  squares.clear();
  for (std::size_t i = 0; i < surface.size; i += stride) {
    const float* to = surface[i];
    const float dx = to[0] - from[0], dy = to[1] - from[1], dz = to[2] - from[2];
    const float d2 = (dx * dx + dy * dy) + dz * dz;
    if (d2 > 0.0f && std::isfinite(d2)) {
      squares.push_back(d2);
    }
  }
  if (squares.size() < k) {
    return std::numeric_limits<float>::infinity();
  }
  if (16 * k < squares.size()) {
    std::vector<float> least(k);
    std::partial_sort_copy(squares.begin(), squares.end(), least.begin(), least.end());
    return std::sqrt(least.back());
  }
  const auto kth = squares.begin() + static_cast<std::ptrdiff_t>(k - 1);
  std::nth_element(squares.begin(), kth, squares.end());
  return std::sqrt(*kth);
}

/** \brief About the distance to the k-th nearest point, where most points are: the
 * median over a few points, from some of the others (on a surface, a share of the
 * points within d is what all are within d sqrt(share)). One point at least is finite.
 */
double
typicalDistance(const XYZView& surface, std::size_t k)
{
  constexpr std::size_t samples = 15;
  constexpr std::size_t most_others = 4096;
  const std::size_t stride = (surface.size + most_others - 1) / most_others;
  const std::size_t nearest = (k + stride - 1) / stride;
  std::vector<float> typical, squares;
  for (std::size_t s = 0; s < samples; ++s) {
    // Spread by the golden ratio, not evenly: that might be along one column of an
    // image.
    const double share =
        std::fmod(0.6180339887498949 * (static_cast<double>(s) + 0.5), 1.0);
    const auto position =
        static_cast<std::size_t>(share * static_cast<double>(surface.size));
    const float* from = finitePointFrom(surface, std::min(position, surface.size - 1));
    const float distance = distanceToNearest(surface, from, stride, nearest, squares);
    if (std::isfinite(distance)) {
      typical.push_back(distance);
    }
  }
  if (typical.empty()) {
    return 0.0;
  }
  std::sort(typical.begin(), typical.end());
  const double share = static_cast<double>(k) / static_cast<double>(nearest * stride);
  return typical[typical.size() / 2] * std::sqrt(share);
}

/** \brief The largest distance between finite coordinates of few points, or 1. */
double
extentOf(const XYZView& points)
{
  float least = std::numeric_limits<float>::max();
  float most = std::numeric_limits<float>::lowest();
  for (std::size_t i = 0; i < points.size; ++i) {
    for (int axis = 0; isFinite(points[i]) && axis < 3; ++axis) {
      least = std::min(least, points[i][axis]);
      most = std::max(most, points[i][axis]);
    }
  }
  const double extent = static_cast<double>(most) - least;
  return extent > 0.0 ? extent : 1.0;
}

double
medianOf(const float* values, std::size_t size)
{
  std::vector<float> sorted(values, values + size);
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(size / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  return *middle;
}

} // namespace

double
rowWidth(const NeighborhoodSize& size, const XYZView& surface, std::size_t queries)
{
  constexpr std::size_t least_points = 64;
  constexpr double radii_a_row = 0.7;
  const double dense = typicalDistance(surface, std::max(size.k, least_points));
  if (size.k > 0) {
    return dense > 0.0 ? dense : extentOf(surface);
  }
  const double radius = size.radii ? medianOf(size.radii, queries) : size.radius;
  return std::max(radii_a_row * radius, std::min(dense, 16.0 * radius));
}

} // namespace pcl::kernels
