/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "surface_steps.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl::segmentation {
namespace {

constexpr int directions = 4;
constexpr int terms = 6; // of a paraboloid: 1, x, y, xx, xy, yy
constexpr std::size_t least_points = 20;
constexpr double least_side = 0.25; // of the points on each side of a line
constexpr double pi = 3.14159265358979323846;

using Terms = Eigen::Matrix<double, terms, 1>;
using Square = Eigen::Matrix<double, terms, terms>;

/** Sums over the points that least squares need. */
struct Sums {
  Square terms_terms = Square::Zero();
  Terms terms_heights = Terms::Zero();
  Eigen::Matrix<double, terms, directions> terms_sides =
      Eigen::Matrix<double, terms, directions>::Zero();
  Eigen::Array<double, directions, 1> sides_heights =
      Eigen::Array<double, directions, 1>::Zero();
  Eigen::Array<double, directions, 1> sides =
      Eigen::Array<double, directions, 1>::Zero();
  double heights_heights = 0.0;
};

Sums
sumsOf(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3f& normal)
{
  const Eigen::Vector3d n = normal.cast<double>(), x_axis = n.unitOrthogonal(),
                        y_axis = n.cross(x_axis);
  Sums sums;
  for (const Eigen::Vector3f& point : points) {
    const Eigen::Vector3d p = point.cast<double>();
    const double x = p.dot(x_axis), y = p.dot(y_axis), height = p.dot(n);
    Terms t;
    t << 1.0, x, y, x * x, x * y, y * y;
    sums.terms_terms += t * t.transpose();
    sums.terms_heights += height * t;
    sums.heights_heights += height * height;
    for (int k = 0; k < directions; ++k) {
      const double angle = pi * k / directions;
      const double side = x * std::cos(angle) + y * std::sin(angle) < 0.0 ? -1.0 : 1.0;
      sums.terms_sides.col(k) += side * t;
      sums.sides_heights[k] += side * height;
      sums.sides[k] += side;
    }
  }
  return sums;
}

} // namespace

SurfaceStep
largestStep(const std::vector<Eigen::Vector3f>& points,
            const Eigen::Vector3f& normal,
            float noise)
{
  SurfaceStep best;
  if (points.size() < least_points)
    return best;
  const Sums sums = sumsOf(points, normal);
  const auto count = static_cast<double>(points.size());
  const Eigen::LDLT<Square> solver(sums.terms_terms);
  const double rest = std::max(
      0.0,
      sums.heights_heights - sums.terms_heights.dot(solver.solve(sums.terms_heights)));
  for (int k = 0; k < directions; ++k) {
    if (std::abs(sums.sides[k]) > (1.0 - 2.0 * least_side) * count)
      continue;
    const Terms of_side = solver.solve(sums.terms_sides.col(k));
    const double own = count - sums.terms_sides.col(k).dot(of_side);
    const double with_rest = sums.sides_heights[k] - of_side.dot(sums.terms_heights);
    if (!(own > 1e-6 * count))
      continue;
    const double explained = with_rest * with_rest / own;
    const double left = std::max(0.0, rest - explained) + count * noise * noise;
    const auto gain = static_cast<float>(explained / left);
    if (gain > best.gain)
      best = {2.0f * static_cast<float>(std::abs(with_rest) / own), gain};
  }
  return best;
}

} // namespace pcl::segmentation
