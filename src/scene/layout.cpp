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

} // namespace pcl::scene
