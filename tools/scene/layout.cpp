// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Random places for objects on a table, tried until none overlap.

#include "scene/layout.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace pcl::scene {
namespace {

constexpr double clearance = 0.006;   // meters between objects that do not touch
constexpr double max_top = 0.32;      // meters; higher the camera would not see it
constexpr double stacked_scale = 0.8; // objects on others are smaller

bool
widestAtCommonHeight(const Body& a, const Body& b)
{
  return std::max(a.widest_low, b.widest_low) <= std::min(a.widest_high, b.widest_high);
}

class Layout {
public:
  Layout(const Ground& ground, double scale, Random& random)
  : ground_(ground)
  , scale_(scale)
  , random_(random)
  {}

  /** \brief Put an object of this kind somewhere.
   * \param[in] any_kind the kinds are mixed: put it against others if too few touch
   * \return false if no room was found */
  bool
  add(Shape shape, bool any_kind)
  {
    constexpr int attempts = 200;
    const bool is_first = bodies_.empty();
    const bool must_touch =
        any_kind && !is_first && 10 * countTouching() < 4 * bodies_.size() + 4;
    const bool in_contact = must_touch || (!is_first && random_.chance(0.5));
    const bool stack = any_kind && shape == Shape::Box && !is_first &&
                       std::none_of(bodies_.begin(), bodies_.end(), [](const Body& b) {
                         return b.low > 0.0;
                       });
    for (int attempt = 0; attempt < attempts; ++attempt) {
      std::optional<Body> body;
      if (stack && attempt < attempts / 4)
        body = onTop(shape);
      else if (in_contact && (any_kind || attempt < attempts / 2))
        body = inContact(shape);
      else
        body = alone(shape);
      if (!body || !fits(*body))
        continue;
      for (const std::size_t other : body->touches)
        bodies_[other].touches.push_back(bodies_.size());
      bodies_.push_back(std::move(*body));
      return true;
    }
    return false;
  }

  const std::vector<Body>&
  bodies() const
  {
    return bodies_;
  }

  /** \brief How many objects touch another one (the table does not count). */
  std::size_t
  countTouching() const
  {
    return static_cast<std::size_t>(
        std::count_if(bodies_.begin(), bodies_.end(), [](const Body& b) {
          return !b.touches.empty();
        }));
  }

private:
  Body
  alone(Shape shape)
  {
    const Body body = randomBody(shape, scale_, randomHeading(random_), random_);
    const double y = random_.uniform(ground_.near, ground_.far);
    const double x = y * ground_.spread * random_.uniform(-1.0, 1.0);
    return moved(body, {x, y, 0.0});
  }

  std::optional<Body>
  onTop(Shape shape)
  {
    const std::size_t index = randomIndex();
    const Body& carrier = bodies_[index];
    if (!carrier.carries)
      return {};
    Body body =
        randomBody(shape, stacked_scale * scale_, randomHeading(random_), random_);
    const bool round = carrier.solid.shape == Shape::Cylinder;
    const double length = round ? 1.2 * carrier.solid.size[0] : carrier.solid.size[0];
    const double width = round ? length : carrier.solid.size[1];
    const double along = 0.25 * length * random_.uniform(-1.0, 1.0);
    const double across = 0.25 * width * random_.uniform(-1.0, 1.0);
    const auto& axes = carrier.solid.pose.axes;
    body = moved(body, carrier.topCenter() + (axes[0] * along + axes[1] * across));
    body.touches = {index};
    return body;
  }

  std::optional<Body>
  beside(Shape shape)
  {
    const std::size_t index = randomIndex();
    const Body& partner = bodies_[index];
    if (partner.low != 0.0)
      return {};
    Body body;
    if (shape == Shape::Box && partner.solid.shape == Shape::Box && random_.chance(0.5))
      body = besideFlush(partner);
    else {
      body = moved(randomBody(shape, scale_, randomHeading(random_), random_),
                   partner.center);
      const Vec3 direction = randomHeading(random_);
      body = moved(body,
                   direction *
                       slideToContact(body.footprint, direction, partner.footprint));
    }
    if (!widestAtCommonHeight(body, partner))
      return {};
    body.touches = {index};
    return body;
  }

  Body
  besideFlush(const Body& partner)
  {
    const Vec3& along = partner.solid.pose.axes[0];
    const Vec3& across = partner.solid.pose.axes[1];
    const Body box = randomBody(Shape::Box, scale_, along, random_);
    const double shift = 0.3 * partner.solid.size[1] * random_.uniform(-1.0, 1.0);
    const Vec3 away = random_.chance(0.5) ? along : -along;
    const Body inside = moved(box, partner.center + across * shift);
    return moved(inside,
                 away * slideToContact(inside.footprint, away, partner.footprint));
  }

  std::optional<Body>
  leaning()
  {
    const std::size_t index = randomIndex();
    const Body& support = bodies_[index];
    const bool suitable = support.solid.shape == Shape::Box && support.carries &&
                          support.low == 0.0 && support.high >= 0.05 * scale_;
    if (!suitable)
      return {};
    const Vec3& axis = support.solid.pose.axes[random_.below(2)];
    const bool to_the_camera = random_.chance(0.75);
    const Vec3 outward = (axis.y < 0.0) == to_the_camera ? axis : -axis;
    Body body = randomLeaningBox(support, outward, scale_, random_);
    body.touches = {index};
    return body;
  }

  std::optional<Body>
  inBowl()
  {
    const std::size_t index = randomIndex();
    const Body& bowl = bodies_[index];
    const bool occupied =
        std::any_of(bodies_.begin(), bodies_.end(), [&](const Body& body) {
          return body.low > bowl.low && body.isTouching(index);
        });
    if (!bowl.open || occupied)
      return {};
    Body body = randomBallInBowl(bowl, random_);
    body.touches = {index};
    return body;
  }

  std::optional<Body>
  inContact(Shape shape)
  {
    switch (random_.below(4)) {
    case 0:
      if (shape == Shape::Box)
        return leaning();
      return shape == Shape::Sphere ? inBowl() : beside(shape);
    case 1:
      return onTop(shape);
    default:
      return beside(shape);
    }
  }

  bool
  fits(const Body& body) const
  {
    const Vec3& center = body.center;
    if (center.y < ground_.near || center.y > ground_.far || body.high > max_top ||
        std::abs(center.x) > std::min(ground_.half_width, ground_.spread * center.y))
      return false;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const Body& other = bodies_[i];
      const bool at_other_heights = body.low >= other.high || body.high <= other.low;
      if (!at_other_heights && !body.isTouching(i) &&
          distance(body.footprint, other.footprint) < clearance)
        return false;
    }
    return true;
  }

  std::size_t
  randomIndex()
  {
    return random_.below(static_cast<unsigned>(bodies_.size()));
  }

  Ground ground_;
  double scale_;
  Random& random_;
  std::vector<Body> bodies_;
};

} // namespace

std::vector<Body>
randomLayout(const Ground& ground,
             unsigned count,
             const std::vector<Shape>& kinds,
             Random& random)
{
  const bool any_kind = kinds.empty();
  const std::vector<Shape> mixed{Shape::Box,
                                 Shape::Box,
                                 Shape::Cylinder,
                                 Shape::Sphere,
                                 Shape::Bowl,
                                 Shape::Box,
                                 Shape::Cylinder,
                                 Shape::Cone};
  const std::vector<Shape>& shapes = any_kind ? mixed : kinds;
  for (double scale = 1.0;; scale *= 0.95) {
    Layout layout(ground, scale, random);
    unsigned added = 0;
    while (added < count && layout.add(shapes[added % shapes.size()], any_kind))
      ++added;
    const bool enough_touch =
        !any_kind || count < 2 || 10 * layout.countTouching() >= 3 * count;
    if (added == count && enough_touch)
      return layout.bodies();
  }
}

} // namespace pcl::scene
