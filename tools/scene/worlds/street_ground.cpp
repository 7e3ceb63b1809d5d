// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The height of a street at each place, and where rays meet it.

#include "scene/worlds/street_ground.h"

#include <algorithm>
#include <cmath>

namespace pcl::scene {
namespace {

constexpr double pavement_fall = 0.02; // towards the road, per meter
constexpr double search_step = 1.0;    // meters; far below the length of a wave
constexpr double fine_step = 0.2;      // meters; for ditches and bumps
constexpr double verge = 1.0;          // meters that are mown
constexpr double driveway_begin = 1.0; // meters from the road

/** \brief The root of a falling function between two distances. */
template <typename Function>
double
bisect(double low, double high, const Function& above)
{
  for (int i = 0; i < 45; ++i) {
    const double middle = 0.5 * (low + high);
    (above(middle) > 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

} // namespace

StreetGround::StreetGround(const StreetProfile& shape) : profile(shape)
{
  const StreetPoint vehicle{0.0, profile.lane};
  base_ = -profile.height - height(vehicle, zone(vehicle));
}

StreetPoint
StreetGround::toStreet(double x, double y) const
{
  const auto [c, s] = profile.heading;
  return {c * x - s * y, profile.lane + s * x + c * y};
}

Vec3
StreetGround::toSensor(const StreetPoint& p, double z) const
{
  const auto [c, s] = profile.heading;
  const double t = p.t - profile.lane;
  return {c * p.s + s * t, c * t - s * p.s, z};
}

GroundZone
StreetGround::zone(const StreetPoint& p) const
{
  if (std::abs(p.t) <= profile.half_width)
    return GroundZone::Road;
  return p.t > 0.0 ? GroundZone::LeftWalk : GroundZone::RightWalk;
}

double
StreetGround::height(const StreetPoint& p, GroundZone zone) const
{
  const StreetProfile& f = profile;
  const double turns = p.s / f.wave_length + f.wave_phase;
  const double along =
      f.grade * p.s + 0.5 * f.curvature * p.s * p.s + f.wave * fromTurns(turns).sine;
  const double w = f.half_width;
  const double across =
      zone == GroundZone::Road
          ? -f.crown * p.t * p.t / w
          : f.curb - f.crown * w + pavement_fall * (std::abs(p.t) - w);
  return base_ + along + f.tilt * p.t + across + side(p, zone);
}

double
StreetGround::side(const StreetPoint& p, GroundZone zone) const
{
  double rise = 0.0;
  if (zone == GroundZone::Road) {
    for (const SpeedBump& bump : profile.bumps) {
      const double from = (p.s - bump.s) / bump.half_length;
      if (std::abs(from) < 1.0)
        rise += bump.height * (1.0 - from * from) * (1.0 - from * from);
    }
    return rise;
  }
  const double across = std::abs(p.t) - profile.half_width;
  const auto& knots = profile.sides[zone == GroundZone::LeftWalk ? 1 : 0];
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const SideKnot &a = knots[i - 1], &b = knots[i];
    const double end = i + 1 < knots.size() ? b.across : across;
    const double along = std::min(across, end) - a.across;
    if (along > 0.0)
      rise = a.rise + (b.rise - a.rise) / (b.across - a.across) * along;
  }
  for (const Driveway& way : profile.driveways)
    if (way.side * p.t > 0.0 && p.s > way.begin && p.s < way.end)
      rise += way.slope * std::clamp(across - driveway_begin, 0.0, way.length);
  return rise;
}

Vec3
StreetGround::normal(const StreetPoint& p, GroundZone zone) const
{
  constexpr double h = 0.01;
  const double ds =
      (height({p.s + h, p.t}, zone) - height({p.s - h, p.t}, zone)) / (2.0 * h);
  const double dt =
      (height({p.s, p.t + h}, zone) - height({p.s, p.t - h}, zone)) / (2.0 * h);
  const auto [c, s] = profile.heading;
  return normalized({-(c * ds + s * dt), -(c * dt - s * ds), 1.0});
}

Pose
StreetGround::standing(const StreetPoint& p) const
{
  const auto [c, s] = profile.heading;
  Pose pose;
  pose.axes[2] = normal(p, zone(p));
  pose.axes[1] = normalized(cross(pose.axes[2], Vec3{c, -s, 0.0}));
  pose.axes[0] = cross(pose.axes[1], pose.axes[2]);
  pose.origin = toSensor(p, height(p));
  return pose;
}

std::optional<GroundHit>
StreetGround::cast(const Ray& ray, double reach, double tuft) const
{
  const Vec3& origin = ray.origin;
  const Vec3& direction = ray.direction;
  const bool is_fine = !profile.bumps.empty() || !profile.driveways.empty() ||
                       !profile.sides[0].empty() || !profile.sides[1].empty();
  const double step = is_fine ? fine_step : search_step;
  const auto at = [&](double distance) {
    return toStreet(origin.x + direction.x * distance,
                    origin.y + direction.y * distance);
  };
  const double lane = at(0.0).t;
  const double drift = at(1.0).t - lane;
  std::array<double, 4> ends{0.0, reach, reach, reach};
  for (const double side : {-1.0, 1.0}) {
    const double crossing = (side * profile.half_width - lane) / drift;
    if (crossing > 0.0 && crossing < reach)
      ends[side < 0.0 ? 1 : 2] = crossing;
  }
  std::sort(ends.begin(), ends.end());
  for (std::size_t i = 0; i + 1 < ends.size() && ends[i] < reach; ++i) {
    const GroundZone zone = this->zone(at(0.5 * (ends[i] + ends[i + 1])));
    const auto above = [&](double distance) {
      const StreetPoint p = at(distance);
      const bool is_grass = std::abs(p.t) > profile.half_width + verge;
      return origin.z + direction.z * distance - height(p, zone) -
             (is_grass ? tuft * profile.grass : 0.0);
    };
    if (above(ends[i]) < 0.0)
      return GroundHit{ends[i],
                       true,
                       toSensor({0.0, profile.lane + (drift > 0.0 ? -1.0 : 1.0)}, 0.0)};
    for (double low = ends[i]; low < ends[i + 1]; low += step) {
      const double high = std::min(low + step, ends[i + 1]);
      if (above(high) < 0.0) {
        const double distance = bisect(low, high, above);
        const StreetPoint p = at(distance);
        return GroundHit{distance, std::abs(p.t) > profile.low_level, normal(p, zone)};
      }
    }
  }
  return std::nullopt;
}

} // namespace pcl::scene
