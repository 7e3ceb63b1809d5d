// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Boxes and cylinders that make a room, and free places to stand in it.

#include "scene/random.h"
#include "scene/worlds/place.h"

#include <algorithm>

namespace pcl::scene {
namespace {

constexpr std::uint64_t room_stream = 30;
constexpr double wall_thickness = 0.2;
constexpr double scanner_height = 1.5;

/** \brief A rectangle of the floor that is taken. */
struct Area {
  double left, right, near, far;
};

class Builder {
public:
  explicit Builder(std::uint64_t seed) : random_(seed, room_stream) {}

  Place
  run()
  {
    room_.length = random_.uniform(4.0, 8.0);
    room_.width = random_.uniform(4.0, 7.0);
    height_ = random_.uniform(2.4, 3.2);
    addShell();
    addStairs();
    addBoard();
    addPipes();
    const unsigned things = 4 + random_.below(5);
    for (unsigned i = 0; i < things; ++i)
      addThing(i == 0 ? 0 : random_.below(4)); // one pillar at least: something round
    addStations();
    return std::move(room_);
  }

private:
  void
  addBox(const Vec3& low, const Vec3& high)
  {
    room_.world.solids.push_back(boxBetween(low, high));
  }

  /** \param[in] axis unit */
  void
  addCylinder(const Vec3& base, const Vec3& axis, double radius, double height)
  {
    const auto [x, y] = perpendiculars(axis);
    room_.world.solids.push_back(
        {Shape::Cylinder, {radius, height, 0.0}, {{{x, y, axis}}, base}});
  }

  void
  addShell()
  {
    const double l = room_.length, w = room_.width, h = height_, t = wall_thickness;
    addBox({-t, -t, -t}, {l + t, w + t, 0.0});
    addBox({-t, -t, h}, {l + t, w + t, h + t});
    addBox({-t, -t, 0.0}, {0.0, w + t, h});
    addBox({l, -t, 0.0}, {l + t, w + t, h});
    addBox({0.0, -t, 0.0}, {l, 0.0, h});
    addBox({0.0, w, 0.0}, {l, w + t, h});
    room_.shell = room_.world.solids.size();
  }

  /** Along the wall y = 0, from the corner at x = 0. */
  void
  addStairs()
  {
    const unsigned steps = random_.below(6);
    const double rise = random_.uniform(0.15, 0.19), run = random_.uniform(0.26, 0.3);
    const double width = random_.uniform(0.9, 1.2);
    if (steps == 0)
      return;
    // One body: boxes beside each other would have edges within the same plane.
    std::vector<Vec3> profile{{0.0, 0.0}, {steps * run, 0.0}};
    for (unsigned i = steps; i > 0; --i) {
      profile.push_back({i * run, i * rise});
      profile.push_back({(i - 1) * run, i * rise});
    }
    profile.pop_back();
    profile.push_back({0.0, rise});
    room_.world.solids.push_back(extrusion(
        profile, {{{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}}}, {0.0, width, 0.0}}, width));
    taken_.push_back({0.0, steps * run, 0.0, width});
  }

  /** A skirting board, or a molding, along the wall at the far side. */
  void
  addBoard()
  {
    const double deep = random_.uniform(0.012, 0.03),
                 high = random_.uniform(0.06, 0.15);
    addBox({0.0, room_.width - deep, 0.0}, {room_.length, room_.width, high});
    const double at = height_ - random_.uniform(0.1, 0.3);
    const double reach = random_.uniform(0.02, 0.06);
    addBox({0.0, room_.width - reach, at}, {room_.length, room_.width, at + reach});
  }

  /** Below the ceiling, from wall to wall. */
  void
  addPipes()
  {
    const unsigned pipes = random_.below(3);
    has_pipes_ = pipes > 0; // and no pillar up to the ceiling, which they might meet
    double y = random_.uniform(1.5, 2.0);
    for (unsigned i = 0; i < pipes; ++i) {
      const double radius = random_.uniform(0.03, 0.15);
      addCylinder({0.0, y, height_ - radius - random_.uniform(0.02, 0.2)},
                  {1.0, 0.0, 0.0},
                  radius,
                  room_.length);
      y += random_.uniform(0.4, 0.8);
    }
  }

  bool
  isFree(const Area& area) const
  {
    return std::none_of(taken_.begin(), taken_.end(), [&](const Area& other) {
      return area.left < other.right && other.left < area.right &&
             area.near < other.far && other.near < area.far;
    });
  }

  /** A free rectangle on the floor; of no size if none was found. */
  Area
  place(double length, double width)
  {
    constexpr double clearance = 0.3;
    for (int attempt = 0; attempt < 40; ++attempt) {
      const double x = random_.uniform(clearance, room_.length - length - clearance);
      const double y = random_.uniform(clearance, room_.width - width - clearance);
      if (isFree({x - clearance,
                  x + length + clearance,
                  y - clearance,
                  y + width + clearance})) {
        taken_.push_back({x, x + length, y, y + width});
        return taken_.back();
      }
    }
    return {};
  }

  void
  addThing(unsigned kind)
  {
    const double length = random_.uniform(0.3, 1.4);
    const double width = kind < 2 ? length : random_.uniform(0.3, 0.9);
    const Area area = place(length, width);
    if (area.right <= area.left)
      return;
    const Vec3 middle{0.5 * (area.left + area.right), 0.5 * (area.near + area.far)};
    if (kind == 0) // a pillar or a tall bin
      addCylinder(middle,
                  {0.0, 0.0, 1.0},
                  0.5 * std::min(0.8, length),
                  has_pipes_ || random_.chance(0.6) ? random_.uniform(0.4, 1.6)
                                                    : height_);
    else if (kind == 1) { // a round table
      addCylinder(middle, {0.0, 0.0, 1.0}, 0.06, 0.72);
      addCylinder(middle + Vec3{0.0, 0.0, 0.72}, {0.0, 0.0, 1.0}, 0.5 * length, 0.03);
    }
    else if (kind == 2)
      addTable(area);
    else
      addCabinet(area);
  }

  void
  addTable(const Area& area)
  {
    constexpr double leg = 0.06, high = 0.7, thick = 0.04, inside = 0.03;
    for (const double x : {area.left + inside, area.right - leg - inside})
      for (const double y : {area.near + inside, area.far - leg - inside})
        addBox({x, y, 0.0}, {x + leg, y + leg, high});
    addBox({area.left, area.near, high}, {area.right, area.far, high + thick});
  }

  void
  addCabinet(const Area& area)
  {
    const double high = random_.uniform(0.4, 2.0);
    addBox({area.left, area.near, 0.0}, {area.right, area.far, high});
    const double side = 0.5 * std::min(area.right - area.left, area.far - area.near);
    if (random_.chance(0.6)) { // something on it
      const double x = area.left + 0.4 * side, y = area.near + 0.4 * side;
      addBox({x, y, high}, {x + side, y + side, high + 0.6 * side});
    }
  }

  void
  addStations()
  {
    for (int attempt = 0; attempt < 1000 && room_.stations.size() < max_stations;
         ++attempt) {
      const double x = random_.uniform(0.5, room_.length - 0.5);
      const double y = random_.uniform(0.5, room_.width - 0.5);
      constexpr double space = 0.35, apart = 1.2;
      const Vec3 at{x, y, scanner_height};
      const bool is_near_another =
          std::any_of(room_.stations.begin(),
                      room_.stations.end(),
                      [&](const Vec3& other) { return norm(other - at) < apart; });
      if (!is_near_another && isFree({x - space, x + space, y - space, y + space}))
        room_.stations.push_back(at);
    }
  }

  Random random_;
  Place room_;
  double height_ = 0.0;
  bool has_pipes_ = false;
  std::vector<Area> taken_;
};

} // namespace

Place
randomRoom(std::uint64_t seed)
{
  return Builder(seed).run();
}

} // namespace pcl::scene
