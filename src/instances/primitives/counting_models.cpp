// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PCL's models of planes, cylinders and spheres that count the points on them faster.
// Sums are in the order of PCL's on SSE2, so that the same points count.

#include "instances/primitives/counting_models.h"

#include <cmath>
#include <limits>

namespace pcl::segmentation {
namespace {

/** The float that floats are below if they are below a double. */
float
roundedUp(double value)
{
  const auto nearest = static_cast<float>(value);
  return nearest < value
             ? std::nextafter(nearest, std::numeric_limits<float>::infinity())
             : nearest;
}

} // namespace

CountedPoints::CountedPoints(const PointCloud<PointXYZ>& points)
{
  x_.reserve(points.size());
  y_.reserve(points.size());
  z_.reserve(points.size());
  for (const PointXYZ& point : points) {
    x_.push_back(point.x);
    y_.push_back(point.y);
    z_.push_back(point.z);
  }
}

template <>
std::size_t
PlaneModel::countWithinDistance(const Eigen::VectorXf& coefficients,
                                double threshold) const
{
  if (!isModelValid(coefficients))
    return 0;
  const float a = coefficients[0], b = coefficients[1], c = coefficients[2],
              d = coefficients[3], limit = roundedUp(threshold);
  return points_.count([=](float x, float y, float z) {
    return std::abs((a * x + c * z) + (b * y + d)) < limit;
  });
}

template <>
std::size_t
SphereModel::countWithinDistance(const Eigen::VectorXf& coefficients,
                                 double threshold) const
{
  if (!isModelValid(coefficients))
    return 0;
  const float a = coefficients[0], b = coefficients[1], c = coefficients[2];
  const double radius = coefficients[3];
  const double inner = std::max(0.0, radius - threshold), outer = radius + threshold;
  const auto low = static_cast<float>(inner * inner);
  const auto high = static_cast<float>(outer * outer);
  return points_.count([=](float x, float y, float z) {
    const float dx = x - a, dy = y - b, dz = z - c;
    const float squared = dx * dx + (dy * dy + dz * dz);
    return squared >= low && squared <= high;
  });
}

template <>
std::size_t
CylinderModel::countWithinDistance(const Eigen::VectorXf& coefficients,
                                   double threshold) const
{
  if (!isModelValid(coefficients))
    return 0;
  const float a = coefficients[0], b = coefficients[1], c = coefficients[2];
  const float u = coefficients[3], v = coefficients[4], w = coefficients[5];
  const float length = (u * u + w * w) + v * v; // squared
  const double radius = coefficients[6];
  return points_.count([=](float x, float y, float z) {
    const float dx = a - x, dy = b - y, dz = c - z;
    const float p = v * dz - w * dy, q = w * dx - u * dz, r = u * dy - v * dx;
    const double squared = ((p * p + r * r) + q * q) / length;
    return std::abs(std::sqrt(squared) - radius) < threshold;
  });
}

} // namespace pcl::segmentation
