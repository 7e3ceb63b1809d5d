// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Walls and level faces of machined parts, and the lines between them.

#include "scene/parts/part.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace pcl::scene {
namespace {

/** Faces that meet at less than 8 degrees go over into each other. */
constexpr double smooth_cosine = 0.99;

} // namespace

void
Part::addWall(const Loop& loop, const std::vector<SectionPiece>& section)
{
  for (const SectionPiece& piece : section)
    if (piece.bend != Bend::Straight && loop.hasSharpCorners())
      throw std::invalid_argument("a wall with a round section has a loop with sharp "
                                  "corners; expected all corners rounded");
  const std::vector<Stroke>& strokes = loop.strokes();
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    addSection(strokes[i], section);
    const Stroke& before = strokes[(i + strokes.size() - 1) % strokes.size()];
    for (const SectionPiece& piece : section)
      addBegin(before, strokes[i], piece);
  }
}

void
Part::addSection(const Stroke& stroke, const std::vector<SectionPiece>& section)
{
  addJoint(stroke, nullptr, &section.front());
  for (std::size_t i = 0; i < section.size(); ++i) {
    faces_.push_back(stripFace(stroke, section[i]));
    const bool is_last = i + 1 == section.size();
    addJoint(stroke, &section[i], is_last ? nullptr : &section[i + 1]);
  }
}

/** Between two pieces of a section, or a level face where there is none. */
void
Part::addJoint(const Stroke& stroke,
               const SectionPiece* before,
               const SectionPiece* after)
{
  constexpr SectionPoint level{1.0, 0.0};
  const SectionPoint a = before ? before->endTangent() : level;
  const SectionPoint b = after ? after->beginTangent() : level;
  const SectionPoint at = before ? before->end : after->begin;
  const Curve line = stroke.curve(at.depth, at.height);
  if (std::abs(a.depth * b.depth + a.height * b.height) < smooth_cosine) {
    creases_.push_back(line);
    return;
  }
  double radius = std::numeric_limits<double>::infinity();
  for (const SectionPiece* piece : {before, after})
    if (piece && piece->radius() > 0.0)
      radius = std::min(radius, piece->radius());
  seams_.push_back({line, radius});
}

/** Where a piece of the wall along a stroke meets that along the stroke before it. */
void
Part::addBegin(const Stroke& before, const Stroke& stroke, const SectionPiece& piece)
{
  if (stroke.isWholeCircle())
    return;
  const int steps = piece.bend == Bend::Straight ? 1 : 8;
  const auto at = [&](int step) {
    const SectionPoint p = piece.point(static_cast<double>(step) / steps);
    return stroke.point(0.0, p.depth) + Vec3{0.0, 0.0, p.height};
  };
  double radius = std::numeric_limits<double>::infinity();
  for (const Stroke* side : {&before, &stroke})
    if (side->radius(0.0) != 0.0)
      radius = std::min(radius, std::abs(side->radius(piece.meanDepth())));
  if (piece.radius() > 0.0)
    radius = std::min(radius, piece.radius());
  for (int step = 0; step < steps; ++step) {
    const Curve line = Curve::segment(at(step), at(step + 1));
    if (stroke.isSharpAtBegin())
      creases_.push_back(line);
    else
      seams_.push_back({line, radius});
  }
}

void
Part::addLevel(double height,
               bool faces_up,
               const Outline& outer,
               const std::vector<Outline>& holes)
{
  faces_.push_back(levelFace(height, faces_up, outer, holes));
}

double
Part::area() const
{
  double sum = 0.0;
  for (const auto& face : faces_)
    sum += face->area();
  return sum;
}

Hit
Part::intersect(const Ray& ray) const
{
  Hit hit;
  for (std::size_t i = 0; i < faces_.size(); ++i)
    faces_[i]->meet(ray, [&](double t) {
      if (t < hit.t) {
        hit.t = t;
        hit.face = static_cast<int>(i);
      }
    });
  if (hit.face >= 0) {
    hit.point = ray.origin + ray.direction * hit.t;
    hit.normal = faces_[static_cast<std::size_t>(hit.face)]->normal(hit.point);
  }
  return hit;
}

double
Part::thickness(const Vec3& p, const Vec3& normal) const
{
  constexpr double beside = 1e-6; // meters: the face itself is not met
  const double inside = intersect({p - normal * beside, -normal}).t;
  const double outside = intersect({p + normal * beside, normal}).t;
  return beside + std::min(inside, outside);
}

Sphere
Part::bounds() const
{
  constexpr double infinite = std::numeric_limits<double>::infinity();
  Vec3 low{infinite, infinite, infinite}, high = -low;
  for (const auto& face : faces_) {
    const Box3& box = face->bounds();
    low = {std::min(low.x, box.low.x),
           std::min(low.y, box.low.y),
           std::min(low.z, box.low.z)};
    high = {std::max(high.x, box.high.x),
            std::max(high.y, box.high.y),
            std::max(high.z, box.high.z)};
  }
  return {(low + high) * 0.5, 0.5 * norm(high - low)};
}

} // namespace pcl::scene
