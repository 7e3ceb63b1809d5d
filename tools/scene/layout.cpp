// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "scene/layout.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::scene {
namespace {

constexpr double clearance = 0.006;
constexpr double highest_top = 0.32;

} // namespace

Layout::Layout(const Ground& ground, double scale, Random& random)
: ground_(ground)
, scale_(scale)
, random_(random)
{}

std::size_t
Layout::countTouching() const
{
  return static_cast<std::size_t>(
      std::count_if(bodies_.begin(), bodies_.end(), [](const Body& b) {
        return !b.touches.empty();
      }));
}

std::size_t
Layout::randomIndex()
{
  return random_.below(static_cast<unsigned>(bodies_.size()));
}

Point2
Layout::randomHeading()
{
  const UnitVector heading = fromTurns(random_.uniform());
  return {heading.cosine, heading.sine};
}

bool
Layout::fits(const Body& body) const
{
  const bool in_view = body.centre.y >= ground_.near && body.centre.y <= ground_.far &&
                       std::abs(body.centre.x) <=
                           std::min(ground_.half_width, ground_.spread * body.centre.y);
  if (!in_view || body.high > highest_top)
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

bool
Layout::add(Shape shape)
{
  constexpr int attempts = 200;
  const bool must_touch =
      !bodies_.empty() && 10 * countTouching() < 4 * bodies_.size() + 4;
  const bool in_contact = must_touch || (!bodies_.empty() && random_.chance(0.5));
  const bool none_stacked = std::none_of(
      bodies_.begin(), bodies_.end(), [](const Body& body) { return body.low > 0.0; });
  for (int attempt = 0; attempt < attempts; ++attempt) {
    const bool stack = shape == Shape::Box && none_stacked && !bodies_.empty() &&
                       attempt < attempts / 4;
    Candidate body =
        stack ? onTop(shape) : (in_contact ? inContact(shape) : alone(shape));
    if (!body || !fits(*body))
      continue;
    insert(std::move(*body));
    return true;
  }
  return false;
}

bool
Layout::addWherePossible(Shape shape)
{
  constexpr int attempts = 200;
  const bool in_contact = !bodies_.empty() && random_.chance(0.5);
  for (int attempt = 0; attempt < attempts; ++attempt) {
    Candidate body =
        in_contact && attempt < attempts / 2 ? inContact(shape) : alone(shape);
    if (!body || !fits(*body))
      continue;
    insert(std::move(*body));
    return true;
  }
  return false;
}

void
Layout::insert(Body body)
{
  for (const std::size_t other : body.touches)
    bodies_[other].touches.push_back(bodies_.size());
  bodies_.push_back(std::move(body));
}

namespace {

std::vector<Body>
layoutOfKinds(const Ground& ground,
              unsigned count,
              const std::vector<Shape>& kinds,
              Random& random)
{
  for (double scale = 1.0;; scale *= 0.95) {
    Layout layout(ground, scale, random);
    unsigned added = 0;
    while (added < count && layout.addWherePossible(kinds[added % kinds.size()]))
      ++added;
    if (added == count)
      return layout.bodies();
  }
}

} // namespace

std::vector<Body>
randomLayout(const Ground& ground,
             unsigned count,
             const std::vector<Shape>& only,
             Random& random)
{
  if (!only.empty())
    return layoutOfKinds(ground, count, only, random);
  constexpr std::array<Shape, 8> kinds{Shape::Box,
                                       Shape::Box,
                                       Shape::Cylinder,
                                       Shape::Sphere,
                                       Shape::Bowl,
                                       Shape::Box,
                                       Shape::Cylinder,
                                       Shape::Cone};
  for (double scale = 1.0;; scale *= 0.95) {
    Layout layout(ground, scale, random);
    unsigned added = 0;
    while (added < count && layout.add(kinds[added % kinds.size()]))
      ++added;
    const bool enough_touch = count < 2 || 10 * layout.countTouching() >= 3 * count;
    if (added == count && enough_touch)
      return layout.bodies();
  }
}

namespace {

constexpr double stacked_scale = 0.8;

bool
widestAtCommonHeight(const Body& a, const Body& b)
{
  return std::max(a.widest_low, b.widest_low) <= std::min(a.widest_high, b.widest_high);
}

} // namespace

Layout::Candidate
Layout::alone(Shape shape)
{
  const Body body = randomBody(shape, scale_, randomHeading(), random_);
  const double y = random_.uniform(ground_.near, ground_.far);
  const double x = y * ground_.spread * random_.uniform(-1.0, 1.0);
  return moved(body, {x, y, 0.0});
}

Layout::Candidate
Layout::onTop(Shape shape)
{
  const std::size_t index = randomIndex();
  const Body& carrier = bodies_[index];
  if (!carrier.carries)
    return {};
  Body body = randomBody(shape, stacked_scale * scale_, randomHeading(), random_);
  const bool round = carrier.solid.shape == Shape::Cylinder;
  const double length = round ? 1.2 * carrier.solid.size[0] : carrier.solid.size[0];
  const double width = round ? length : carrier.solid.size[1];
  const double along = 0.25 * length * random_.uniform(-1.0, 1.0);
  const double across = 0.25 * width * random_.uniform(-1.0, 1.0);
  const auto& axes = carrier.solid.pose.axes;
  const Vec3 offset = axes[0] * along + axes[1] * across;
  body = moved(
      body, {carrier.centre.x + offset.x, carrier.centre.y + offset.y, carrier.high});
  body.touches = {index};
  return body;
}

Layout::Candidate
Layout::beside(Shape shape)
{
  const std::size_t index = randomIndex();
  const Body& partner = bodies_[index];
  if (partner.low != 0.0)
    return {};
  Candidate body;
  if (shape == Shape::Box && partner.solid.shape == Shape::Box && random_.chance(0.5))
    body = besideFlush(partner);
  else {
    body = moved(randomBody(shape, scale_, randomHeading(), random_),
                 {partner.centre.x, partner.centre.y, 0.0});
    const Point2 direction = randomHeading();
    const double by = slideToContact(body->footprint, direction, partner.footprint);
    body = moved(*body, {by * direction.x, by * direction.y, 0.0});
  }
  if (!widestAtCommonHeight(*body, partner))
    return {};
  body->touches = {index};
  return body;
}

Layout::Candidate
Layout::besideFlush(const Body& partner)
{
  const Vec3& along = partner.solid.pose.axes[0];
  const Vec3& across = partner.solid.pose.axes[1];
  const Body box = randomBody(Shape::Box, scale_, {along.x, along.y}, random_);
  const double shift = 0.3 * partner.solid.size[1] * random_.uniform(-1.0, 1.0);
  const Vec3 start = across * shift;
  const Vec3 away = random_.chance(0.5) ? along : -along;
  const Body inside =
      moved(box, {partner.centre.x + start.x, partner.centre.y + start.y, 0.0});
  const double by =
      slideToContact(inside.footprint, {away.x, away.y}, partner.footprint);
  return moved(inside, {by * away.x, by * away.y, 0.0});
}

Layout::Candidate
Layout::leaning()
{
  const std::size_t index = randomIndex();
  const Body& support = bodies_[index];
  const bool suitable = support.solid.shape == Shape::Box && support.carries &&
                        support.low == 0.0 && support.high >= 0.05 * scale_;
  if (!suitable)
    return {};
  const auto& axes = support.solid.pose.axes;
  const Vec3& axis = axes[random_.below(2)];
  const bool to_the_camera = random_.chance(0.75);
  const Vec3 outward = (axis.y < 0.0) == to_the_camera ? axis : -axis;
  Body body = randomLeaningBox(support, outward, scale_, random_);
  body.touches = {index};
  return body;
}

Layout::Candidate
Layout::inBowl()
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

Layout::Candidate
Layout::inContact(Shape shape)
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

} // namespace pcl::scene
