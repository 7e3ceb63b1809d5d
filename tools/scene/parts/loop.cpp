// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Closed outlines: parallels of their lines and arcs, what they enclose.

#include "scene/parts/loop.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::scene {
namespace {

constexpr double two_pi = 6.28318530717958647693;

double
crossZ(const Vec3& a, const Vec3& b)
{
  return a.x * b.y - a.y * b.x;
}

Vec3
rightOf(const Vec3& a)
{
  return {a.y, -a.x, 0.0};
}

Vec3
heading(double turns)
{
  const UnitVector unit = fromTurns(turns);
  return {unit.cosine, unit.sine, 0.0};
}

/** The tangent of half the angle by which a path turns, from one unit vector to the
 * other; left is positive. */
double
halfTurnTangent(const Vec3& before, const Vec3& after)
{
  return crossZ(before, after) / (1.0 + dot(before, after));
}

/** The turns of a unit vector, by bisection: the same on every machine. */
double
turnsOf(const Vec3& unit)
{
  double low = unit.y >= 0.0 ? 0.0 : 0.5, high = low + 0.5;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (crossZ(heading(middle), unit) >= 0.0 ? low : high) = middle;
  }
  return low;
}

} // namespace

Stroke
Stroke::line(const Vec3& begin, const Vec3& end, double begin_slope, double end_slope)
{
  Stroke stroke;
  stroke.begin_ = begin;
  stroke.end_ = end;
  stroke.along_ = normalized(end - begin);
  stroke.begin_slope_ = begin_slope;
  stroke.end_slope_ = end_slope;
  return stroke;
}

Stroke
Stroke::arc(const Vec3& center, double radius, double from, double to)
{
  Stroke stroke;
  stroke.round_ = true;
  stroke.center_ = center;
  stroke.radius_ = radius;
  stroke.from_ = from;
  stroke.to_ = to;
  return stroke;
}

double
Stroke::radius(double depth) const
{
  if (!round_)
    return 0.0;
  return to_ > from_ ? radius_ - depth : -(radius_ + depth);
}

Vec3
Stroke::point(double along, double depth) const
{
  if (round_)
    return center_ + heading(from_ + along * (to_ - from_)) * std::abs(radius(depth));
  const Vec3 inward = -rightOf(along_) * depth;
  const Vec3 begin = begin_ + inward + along_ * (begin_slope_ * depth);
  const Vec3 end = end_ + inward - along_ * (end_slope_ * depth);
  return begin + (end - begin) * along;
}

Vec3
Stroke::outward(double along) const
{
  if (!round_)
    return rightOf(along_);
  return heading(from_ + along * (to_ - from_)) * (to_ > from_ ? 1.0 : -1.0);
}

double
Stroke::depthOf(const Vec3& p) const
{
  if (!round_)
    return dot(begin_ - p, rightOf(along_));
  const double rho = std::sqrt((p.x - center_.x) * (p.x - center_.x) +
                               (p.y - center_.y) * (p.y - center_.y));
  return to_ > from_ ? radius_ - rho : rho - radius_;
}

Vec3
Stroke::outwardAt(const Vec3& p) const
{
  if (!round_)
    return rightOf(along_);
  const Vec3 level{p.x - center_.x, p.y - center_.y, 0.0};
  return normalized(level) * (to_ > from_ ? 1.0 : -1.0);
}

bool
Stroke::spans(const Vec3& p, double tolerance) const
{
  if (!round_) {
    const double depth = depthOf(p);
    return dot(p - begin_, along_) >= begin_slope_ * depth - tolerance &&
           dot(end_ - p, along_) >= end_slope_ * depth - tolerance;
  }
  if (isWholeCircle())
    return true;
  const double turn = to_ > from_ ? 1.0 : -1.0;
  const Vec3 level{p.x - center_.x, p.y - center_.y, 0.0};
  return turn * crossZ(heading(from_), level) >= -tolerance &&
         turn * crossZ(level, heading(to_)) >= -tolerance;
}

double
Stroke::length(double depth) const
{
  if (round_)
    return two_pi * std::abs(to_ - from_) * std::abs(radius(depth));
  return norm(end_ - begin_) - depth * (begin_slope_ + end_slope_);
}

Curve
Stroke::curve(double depth, double height) const
{
  const Vec3 up{0.0, 0.0, height};
  if (!round_)
    return Curve::segment(point(0.0, depth) + up, point(1.0, depth) + up);
  return Curve::circle(center_ + up, {1, 0, 0}, {0, 1, 0}, std::abs(radius(depth)))
      .part(std::min(from_, to_), std::max(from_, to_));
}

double
Stroke::doubleArea(double depth) const
{
  const Vec3 begin = point(0.0, depth), end = point(1.0, depth);
  if (!round_)
    return crossZ(begin, end);
  const double r = radius(depth);
  return r * r * two_pi * (to_ - from_) + crossZ(center_, end - begin);
}

int
Stroke::crossings(const Vec3& p, double depth) const
{
  const Vec3 begin = point(0.0, depth), end = point(1.0, depth);
  if (!round_) {
    if ((begin.y > p.y) == (end.y > p.y))
      return 0;
    const double x = begin.x + (p.y - begin.y) / (end.y - begin.y) * (end.x - begin.x);
    return x > p.x ? 1 : 0;
  }
  const double r = radius(depth), y = p.y - center_.y;
  if (std::abs(y) >= std::abs(r))
    return 0;
  const double half = std::sqrt(r * r - y * y);
  int count = 0;
  for (const double x : {-half, half})
    count += center_.x + x > p.x && spans({center_.x + x, p.y, 0.0}, 0.0);
  return count;
}

Loop
Loop::polygon(const std::vector<Vec3>& corners, const std::vector<double>& corner_radii)
{
  const std::size_t count = corners.size();
  const auto along = [&](std::size_t i) {
    return normalized(corners[(i + 1) % count] - corners[i % count]);
  };
  const auto slopeAt = [&](std::size_t i) {
    return halfTurnTangent(along(i + count - 1), along(i));
  };
  Loop loop;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = (i + 1) % count;
    const double before = corner_radii[i] * std::abs(slopeAt(i));
    const double after = corner_radii[next] * std::abs(slopeAt(next));
    const Vec3 begin = corners[i] + along(i) * before;
    const Vec3 end = corners[next] - along(i) * after;
    constexpr double no_line = 1e-9; // meters: both arcs meet, as at the end of a slot
    if (norm(end - begin) > no_line)
      loop.strokes_.push_back(
          Stroke::line(begin,
                       end,
                       corner_radii[i] == 0.0 ? slopeAt(i) : 0.0,
                       corner_radii[next] == 0.0 ? slopeAt(next) : 0.0));
    if (corner_radii[next] == 0.0)
      continue;
    const double turn = slopeAt(next) > 0.0 ? 1.0 : -1.0;
    const Vec3 start = corners[next] - along(i) * after;
    const Vec3 center = start + leftOf(along(i)) * (turn * corner_radii[next]);
    const double from = turnsOf(rightOf(along(i)) * turn);
    double to = turnsOf(rightOf(along(next)) * turn);
    to += turn > 0.0 && to < from ? 1.0 : turn < 0.0 && to > from ? -1.0 : 0.0;
    loop.strokes_.push_back(Stroke::arc(center, corner_radii[next], from, to));
  }
  return loop;
}

Loop
Loop::circle(const Vec3& center, double radius)
{
  Loop loop;
  loop.strokes_ = {Stroke::arc(center, radius, 0.0, 1.0)};
  return loop;
}

bool
Loop::contains(const Vec3& p, double depth) const
{
  int crossings = 0;
  for (const Stroke& stroke : strokes_)
    crossings += stroke.crossings(p, depth);
  return crossings % 2 == 1;
}

double
Loop::area(double depth) const
{
  double sum = 0.0;
  for (const Stroke& stroke : strokes_)
    sum += stroke.doubleArea(depth);
  return 0.5 * sum;
}

double
Loop::distance(const Vec3& p, double depth) const
{
  double nearest = std::numeric_limits<double>::infinity();
  for (const Stroke& stroke : strokes_)
    nearest = std::min(nearest, stroke.curve(depth, 0.0).distance({p.x, p.y, 0.0}));
  return nearest;
}

bool
Loop::hasSharpCorners() const
{
  return std::any_of(strokes_.begin(), strokes_.end(), [](const Stroke& stroke) {
    return stroke.isSharpAtBegin();
  });
}

} // namespace pcl::scene
