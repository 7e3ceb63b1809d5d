// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Straight lines and circles in space: points of them, and exact distances.

#include "scene/curve.h"

#include <algorithm>
#include <cmath>

namespace pcl::scene {

Curve
Curve::segment(const Vec3& begin, const Vec3& end)
{
  Curve curve;
  curve.begin_ = begin;
  curve.end_ = end;
  return curve;
}

Curve
Curve::circle(const Vec3& center, const Vec3& u, const Vec3& v, double radius)
{
  Curve curve;
  curve.round_ = true;
  curve.center_ = center;
  curve.u_ = u;
  curve.v_ = v;
  curve.radius_ = radius;
  return curve;
}

Curve
Curve::part(double from, double to) const
{
  Curve curve = *this;
  curve.from_ = from;
  curve.to_ = to;
  return curve;
}

Curve
Curve::placed(const Pose& pose) const
{
  Curve curve = *this;
  curve.begin_ = pose.toWorld(begin_);
  curve.end_ = pose.toWorld(end_);
  curve.center_ = pose.toWorld(center_);
  curve.u_ = pose.directionToWorld(u_);
  curve.v_ = pose.directionToWorld(v_);
  return curve;
}

Vec3
Curve::point(double parameter) const
{
  if (!round_)
    return begin_ + (end_ - begin_) * parameter;
  const UnitVector angle = fromTurns(parameter);
  return center_ + (u_ * angle.cosine + v_ * angle.sine) * radius_;
}

Vec3
Curve::tangent(double parameter) const
{
  if (!round_)
    return normalized(end_ - begin_);
  const UnitVector angle = fromTurns(parameter);
  return v_ * angle.cosine - u_ * angle.sine;
}

double
Curve::length() const
{
  constexpr double two_pi = 6.28318530717958647693;
  return round_ ? two_pi * radius_ : norm(end_ - begin_);
}

Sphere
Curve::bounds() const
{
  if (round_ && to_ - from_ > 0.5)
    return {center_, radius_};
  // At most half a circle is inside the sphere around its middle through its ends
  const Vec3 middle = point(0.5 * (from_ + to_));
  return {middle, std::max(norm(point(from_) - middle), norm(point(to_) - middle))};
}

double
Curve::distance(const Vec3& p) const
{
  if (!round_) {
    const Vec3 along = end_ - begin_;
    const double nearest = dot(p - begin_, along) / squaredNorm(along);
    return norm(p - point(std::clamp(nearest, from_, to_)));
  }
  const Vec3 from_center = p - center_;
  const double x = dot(from_center, u_), y = dot(from_center, v_);
  const double rho = std::sqrt(x * x + y * y);
  const UnitVector middle = fromTurns(0.5 * (from_ + to_));
  const double cosine_of_half_arc = fromTurns(0.5 * (to_ - from_)).cosine;
  const bool beside_the_arc =
      to_ - from_ >= 1.0 ||
      x * middle.cosine + y * middle.sine >= rho * cosine_of_half_arc;
  if (!beside_the_arc)
    return std::min(norm(p - point(from_)), norm(p - point(to_)));
  const double height2 = std::max(0.0, squaredNorm(from_center) - rho * rho);
  return std::sqrt((rho - radius_) * (rho - radius_) + height2);
}

} // namespace pcl::scene
