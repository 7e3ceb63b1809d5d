/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "layout.h"

#include <algorithm>

namespace pcl::scene {
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
