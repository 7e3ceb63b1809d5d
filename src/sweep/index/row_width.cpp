// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// How wide rows of cells should be: estimated from the density of a few points.

#include "sweep/index/row_width.h"

#include "common/finite.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace pcl::kernels {
namespace {

/** \brief Every `stride`-th point, those that are not finite left out. */
struct SomePoints {
  std::vector<float> x, y, z;

  SomePoints(const XYZView& points, std::size_t stride)
  {
    for (auto* values : {&x, &y, &z})
      values->reserve(points.size / stride + 1);
    for (std::size_t i = 0; i < points.size; i += stride) {
      if (isFinite(points[i])) {
        x.push_back(points[i][0]);
        y.push_back(points[i][1]);
        z.push_back(points[i][2]);
      }
    }
  }

  /** Leave out the others at the place of this one, such as fillers of a driver. */
  void
  leaveOneAt(std::size_t at)
  {
    const float place[] = {x[at], y[at], z[at]};
    std::size_t kept = 0;
    bool has_one = false;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const bool is_there = x[i] == place[0] && y[i] == place[1] && z[i] == place[2];
      if (is_there && has_one)
        continue;
      has_one = has_one || is_there;
      x[kept] = x[i], y[kept] = y[i], z[kept] = z[i];
      ++kept;
    }
    for (auto* values : {&x, &y, &z})
      values->resize(kept);
  }
};

/** \brief Instead of the squared distance 0: of no neighbor. */
constexpr float at_same_place = std::numeric_limits<float>::infinity();

/** \brief The k-th smallest of the distances from one of the points to others, those at
 * the same place left out. Infinite if there are fewer. */
float
distanceToNearest(const SomePoints& points,
                  std::size_t from,
                  std::size_t k,
                  std::vector<float>& squares)
{
  const std::size_t size = points.x.size();
  if (size < k)
    return std::numeric_limits<float>::infinity();
  squares.resize(size);
  const float x = points.x[from], y = points.y[from], z = points.z[from];
  for (std::size_t i = 0; i < size; ++i) {
    const float dx = points.x[i] - x, dy = points.y[i] - y, dz = points.z[i] - z;
    const float d2 = (dx * dx + dy * dy) + dz * dz;
    squares[i] = d2 > 0.0f ? d2 : at_same_place;
  }
  if (16 * k < size) { // faster for few
    std::vector<float> nearest(k);
    std::partial_sort_copy(
        squares.begin(), squares.end(), nearest.begin(), nearest.end());
    return std::sqrt(nearest.back());
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
  // Enough for a median within a third, and little beside sorting all points.
  constexpr std::size_t samples = 15, max_others = 4096;
  const std::size_t stride = (surface.size + max_others - 1) / max_others;
  const std::size_t nearest = (k + stride - 1) / stride;
  SomePoints points(surface, stride);
  std::vector<float> typical, squares;
  for (std::size_t s = 0; s < std::min(samples, points.x.size()); ++s) {
    // Spread by the golden ratio, not evenly: that might be along one column of an
    // image.
    const double share =
        std::fmod(0.6180339887498949 * (static_cast<double>(s) + 0.5), 1.0);
    const auto from =
        static_cast<std::size_t>(share * static_cast<double>(points.x.size()));
    const float distance = distanceToNearest(points, from, nearest, squares);
    if (std::isfinite(distance))
      typical.push_back(distance);
    if (std::count(squares.begin(), squares.end(), at_same_place) > 1)
      points.leaveOneAt(from);
  }
  if (typical.empty())
    return 0.0;
  std::sort(typical.begin(), typical.end());
  const double share = static_cast<double>(k) / static_cast<double>(nearest * stride);
  return typical[typical.size() / 2] * std::sqrt(share);
}

/** \brief The largest distance between finite coordinates of few points, or 1. */
double
extentOf(const XYZView& points)
{
  float min = std::numeric_limits<float>::max();
  float max = std::numeric_limits<float>::lowest();
  for (std::size_t i = 0; i < points.size; ++i) {
    for (int axis = 0; isFinite(points[i]) && axis < 3; ++axis) {
      min = std::min(min, points[i][axis]);
      max = std::max(max, points[i][axis]);
    }
  }
  const double extent = static_cast<double>(max) - min;
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
  constexpr std::size_t min_points = 64; // row_width.h
  constexpr double radii_per_row = 0.7;  // the fastest on depth images
  // In wider rows most points are no neighbors.
  constexpr double max_radii_per_row = 16.0;
  const double dense = typicalDistance(surface, std::max(size.k, min_points));
  if (size.k > 0)
    return dense > 0.0 ? dense : extentOf(surface);
  const double radius = size.radii ? medianOf(size.radii, queries) : size.radius;
  return std::max(radii_per_row * radius, std::min(dense, max_radii_per_row * radius));
}

} // namespace pcl::kernels
