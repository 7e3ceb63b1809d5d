/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "primitive_geometry.h"

#include <cmath>
#include <utility>
#include <vector>

namespace pcl::segmentation {
namespace {

using Eigen::Vector3f;

/** A point of the axis and the part of the way to a point that is square to it. */
std::pair<Vector3f, Vector3f>
fromAxis(const std::vector<float>& cylinder, const Vector3f& point)
{
  const Vector3f origin(cylinder[0], cylinder[1], cylinder[2]);
  const Vector3f axis(cylinder[3], cylinder[4], cylinder[5]);
  const Vector3f on_axis = origin + axis.dot(point - origin) * axis;
  return {on_axis, point - on_axis};
}

} // namespace

void
normalize(ShapePrimitive& primitive)
{
  std::vector<float>& c = primitive.coefficients;
  Eigen::Map<Vector3f> first(c.data());
  if (primitive.type == PrimitiveType::Plane) {
    const float length = first.norm();
    first /= length;
    c[3] /= length;
  }
  else if (primitive.type == PrimitiveType::Cylinder) {
    Eigen::Map<Vector3f> axis(&c[3]);
    axis.normalize();
    first -= axis.dot(first) * axis;
    c[6] = std::abs(c[6]);
  }
}

void
enlarge(float times, ShapePrimitive& primitive)
{
  std::vector<float>& c = primitive.coefficients;
  if (primitive.type != PrimitiveType::Plane)
    Eigen::Map<Vector3f>(c.data()) *= times;
  c.back() *= times;
  primitive.residual *= times;
}

Vector3f
footOn(const ShapePrimitive& primitive, const Vector3f& point)
{
  const std::vector<float>& c = primitive.coefficients;
  const Vector3f first(c[0], c[1], c[2]);
  switch (primitive.type) {
  case PrimitiveType::Plane:
    return point - (first.dot(point) + c[3]) * first;
  case PrimitiveType::Sphere:
    return first + c[3] * (point - first).normalized();
  default:
    const auto [on_axis, away] = fromAxis(c, point);
    return on_axis + c[6] * away.normalized();
  }
}

Vector3f
normalOf(const ShapePrimitive& primitive, const Vector3f& point)
{
  const std::vector<float>& c = primitive.coefficients;
  const Vector3f first(c[0], c[1], c[2]);
  switch (primitive.type) {
  case PrimitiveType::Plane:
    return first;
  case PrimitiveType::Sphere:
    return (point - first).normalized();
  default:
    return fromAxis(c, point).second.normalized();
  }
}

} // namespace pcl::segmentation
