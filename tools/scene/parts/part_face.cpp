// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Where rays meet the faces of machined parts, and points spread over them.

#include "scene/parts/part_face.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace pcl::scene {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double half_pi = 1.57079632679489661923;
constexpr double quarter_turn = 0.25;
constexpr double no_gap = 1e-9; // meters by which faces overlap for rays: no leaks

double
sign(double value)
{
  return value < 0.0 ? -1.0 : 1.0;
}

/** The part of a ray that is inside a box, in lengths of its direction. */
std::optional<std::pair<double, double>>
inside(const Box3& box, const Ray& ray)
{
  double low = 0.0, high = infinite;
  const auto clip = [&](double origin, double direction, double from, double to) {
    if (direction == 0.0) {
      if (origin < from || origin > to)
        high = -1.0;
      return;
    }
    const double a = (from - origin) / direction, b = (to - origin) / direction;
    low = std::max(low, std::min(a, b));
    high = std::min(high, std::max(a, b));
  };
  clip(ray.origin.x, ray.direction.x, box.low.x, box.high.x);
  clip(ray.origin.y, ray.direction.y, box.low.y, box.high.y);
  clip(ray.origin.z, ray.direction.z, box.low.z, box.high.z);
  if (low > high)
    return std::nullopt;
  return std::make_pair(low, high);
}

/** Around some points of a stroke's parallel, widened to what an arc may bulge. */
void
include(const Stroke& stroke, double depth, Box3& box)
{
  constexpr int steps = 16;
  // Between two of the places an arc of at most a turn bulges by r (1 - cos(pi / 16)).
  const double bulge = 0.02 * std::abs(stroke.radius(depth));
  for (int i = 0; i <= steps; ++i) {
    const Vec3 p = stroke.point(static_cast<double>(i) / steps, depth);
    box.low.x = std::min(box.low.x, p.x - bulge);
    box.low.y = std::min(box.low.y, p.y - bulge);
    box.high.x = std::max(box.high.x, p.x + bulge);
    box.high.y = std::max(box.high.y, p.y + bulge);
  }
}

Box3
emptyBox(double low, double high)
{
  return {{infinite, infinite, low - no_gap}, {-infinite, -infinite, high + no_gap}};
}

Box3
boundsOf(const Outline& outline, double height)
{
  Box3 box = emptyBox(height, height);
  for (const Stroke& stroke : outline.loop.strokes())
    include(stroke, outline.depth, box);
  return box;
}

Box3
boundsOf(const Stroke& stroke, const SectionPiece& piece)
{
  const auto [low, high] = std::minmax(piece.begin.height, piece.end.height);
  Box3 box = emptyBox(low, high);
  include(stroke, piece.begin.depth, box);
  include(stroke, piece.end.depth, box);
  // The sides of a strip that stands upright and straight have no width of their own.
  box.low = box.low - Vec3{no_gap, no_gap, 0.0};
  box.high = box.high + Vec3{no_gap, no_gap, 0.0};
  return box;
}

/** In plan. */
bool
isWithin(const Vec3& p, const Box3& box, double tolerance)
{
  return p.x >= box.low.x - tolerance && p.x <= box.high.x + tolerance &&
         p.y >= box.low.y - tolerance && p.y <= box.high.y + tolerance;
}

} // namespace

double
SectionPiece::radius() const
{
  return bend == Bend::Straight ? 0.0 : std::abs(end.depth - begin.depth);
}

double
SectionPiece::length() const
{
  if (bend != Bend::Straight)
    return half_pi * radius();
  const double depth = end.depth - begin.depth, height = end.height - begin.height;
  return std::sqrt(depth * depth + height * height);
}

SectionPoint
SectionPiece::point(double along) const
{
  double across = along, up = along;
  if (bend != Bend::Straight) {
    const UnitVector angle = fromTurns(quarter_turn * along);
    across = bend == Bend::FromUpright ? 1.0 - angle.cosine : angle.sine;
    up = bend == Bend::FromUpright ? angle.sine : 1.0 - angle.cosine;
  }
  return {begin.depth + across * (end.depth - begin.depth),
          begin.height + up * (end.height - begin.height)};
}

double
SectionPiece::meanDepth() const
{
  // Of 1 - cos and of sin over a quarter turn
  const double share = bend == Bend::Straight      ? 0.5
                       : bend == Bend::FromUpright ? 1.0 - 1.0 / half_pi
                                                   : 1.0 / half_pi;
  return begin.depth + share * (end.depth - begin.depth);
}

SectionPoint
SectionPiece::beginTangent() const
{
  const double across = end.depth - begin.depth, up = end.height - begin.height;
  if (bend == Bend::FromUpright)
    return {0.0, sign(up)};
  if (bend == Bend::FromLevel)
    return {sign(across), 0.0};
  return {across / length(), up / length()};
}

SectionPoint
SectionPiece::endTangent() const
{
  const double across = end.depth - begin.depth, up = end.height - begin.height;
  if (bend == Bend::FromUpright)
    return {sign(across), 0.0};
  if (bend == Bend::FromLevel)
    return {0.0, sign(up)};
  return beginTangent();
}

double
SectionPiece::distance(const SectionPoint& p) const
{
  if (bend == Bend::Straight) {
    const SectionPoint t = beginTangent();
    return (p.height - begin.height) * t.depth - (p.depth - begin.depth) * t.height;
  }
  const double depth = bend == Bend::FromUpright ? end.depth : begin.depth;
  const double height = bend == Bend::FromUpright ? begin.height : end.height;
  return std::sqrt((p.depth - depth) * (p.depth - depth) +
                   (p.height - height) * (p.height - height)) -
         radius();
}

bool
SectionPiece::spans(const SectionPoint& p, double tolerance) const
{
  if (bend == Bend::Straight) {
    const SectionPoint t = beginTangent();
    const double along =
        (p.depth - begin.depth) * t.depth + (p.height - begin.height) * t.height;
    return along >= -tolerance && along <= length() + tolerance;
  }
  const auto between = [&](double value, double a, double b) {
    return value >= std::min(a, b) - tolerance && value <= std::max(a, b) + tolerance;
  };
  return between(p.depth, begin.depth, end.depth) &&
         between(p.height, begin.height, end.height);
}

SectionPoint
SectionPiece::normal(const SectionPoint& p) const
{
  if (bend == Bend::Straight) {
    const SectionPoint t = beginTangent();
    return {-t.height, t.depth};
  }
  const double depth = bend == Bend::FromUpright ? end.depth : begin.depth;
  const double height = bend == Bend::FromUpright ? begin.height : end.height;
  // Away from the center where the piece turns right, towards it where it turns left
  const double turn = sign(end.depth - begin.depth) * sign(end.height - begin.height) *
                      (bend == Bend::FromUpright ? 1.0 : -1.0);
  const Vec3 radial = normalized(Vec3{p.depth - depth, p.height - height, 0.0}) * turn;
  return {radial.x, radial.y};
}

namespace {

/** A level face, inside one outline and outside others. */
class LevelFace : public PartFace {
public:
  LevelFace(double height,
            bool faces_up,
            const Outline& outer,
            const std::vector<Outline>& holes)
  : PartFace(boundsOf(outer, height), true)
  , height_(height)
  , faces_up_(faces_up)
  , outer_(outer)
  , holes_(holes)
  {
    for (const Outline& hole : holes_)
      hole_bounds_.push_back(boundsOf(hole, height));
  }

  void
  meet(const Ray& ray, const std::function<void(double)>& found) const override
  {
    const double t = (height_ - ray.origin.z) / ray.direction.z;
    if (t > 0.0 && t < infinite && contains(ray.origin + ray.direction * t))
      found(t);
  }

  bool
  isAt(const Vec3& p, double tolerance) const override
  {
    if (std::abs(p.z - height_) > tolerance)
      return false;
    if (contains(p) || outer_.loop.distance(p, outer_.depth) <= tolerance)
      return true;
    for (std::size_t i = 0; i < holes_.size(); ++i)
      if (isWithin(p, hole_bounds_[i], tolerance) &&
          holes_[i].loop.distance(p, holes_[i].depth) <= tolerance)
        return true;
    return false;
  }

  Vec3
  normal(const Vec3&) const override
  {
    return {0.0, 0.0, faces_up_ ? 1.0 : -1.0};
  }

  double
  radius(const Vec3&) const override
  {
    return infinite;
  }

  double
  area() const override
  {
    double area = outer_.loop.area(outer_.depth);
    for (const Outline& hole : holes_)
      area -= hole.loop.area(hole.depth);
    return area;
  }

  Vec3
  randomPoint(Random& random) const override
  {
    const Box3& box = bounds();
    for (;;) {
      const double x = random.uniform(box.low.x, box.high.x);
      const Vec3 p{x, random.uniform(box.low.y, box.high.y), height_};
      if (contains(p))
        return p;
    }
  }

private:
  bool
  contains(const Vec3& p) const
  {
    if (!outer_.loop.contains(p, outer_.depth))
      return false;
    for (std::size_t i = 0; i < holes_.size(); ++i)
      if (isWithin(p, hole_bounds_[i], 0.0) &&
          holes_[i].loop.contains(p, holes_[i].depth))
        return false;
    return true;
  }

  double height_;
  bool faces_up_;
  Outline outer_;
  std::vector<Outline> holes_;
  std::vector<Box3> hole_bounds_; /**< most points are beside most holes */
};

/** A piece of a section that is moved along a stroke. */
class StripFace : public PartFace {
public:
  StripFace(const Stroke& stroke, const SectionPiece& piece)
  : PartFace(boundsOf(stroke, piece),
             stroke.radius(0.0) == 0.0 && piece.bend == Bend::Straight)
  , stroke_(stroke)
  , piece_(piece)
  {}

  void
  meet(const Ray& ray, const std::function<void(double)>& found) const override
  {
    const auto range = inside(bounds(), ray);
    if (!range)
      return;
    // A round face is met up to four times; roots that are closer together are grazed.
    const int steps = isFlat() ? 1 : 24;
    const auto [low, high] = *range;
    // Faces are met also where the box ends: begin and end a little outside.
    const double margin = isFlat() ? 1.0 : 0.01 * (high - low) + 1e-6;
    const double from = std::max(low - margin, 0.0);
    const double step = (high + margin - from) / steps;
    const auto value = [&](double t) {
      return piece_.distance(section(ray.origin + ray.direction * t));
    };
    double before = value(from);
    for (int i = 1; i <= steps; ++i) {
      const double after = value(from + i * step);
      if ((before < 0.0) != (after < 0.0)) {
        const double t = root(ray, from + (i - 1) * step, from + i * step);
        const Vec3 p = ray.origin + ray.direction * t;
        if (t > 0.0 && stroke_.spans(p, no_gap) && piece_.spans(section(p), no_gap))
          found(t);
      }
      before = after;
    }
  }

  bool
  isAt(const Vec3& p, double tolerance) const override
  {
    const SectionPoint at = section(p);
    return std::abs(piece_.distance(at)) <= tolerance && piece_.spans(at, tolerance) &&
           stroke_.spans(p, tolerance);
  }

  Vec3
  normal(const Vec3& p) const override
  {
    const SectionPoint at = piece_.normal(section(p));
    return stroke_.outwardAt(p) * -at.depth + Vec3{0.0, 0.0, at.height};
  }

  double
  radius(const Vec3& p) const override
  {
    const double along = piece_.radius() > 0.0 ? piece_.radius() : infinite;
    const SectionPoint at = section(p);
    // Meusnier: a level circle on the face is as curved as its plane is upright to it.
    const double level = std::abs(piece_.normal(at).depth);
    const double around = std::abs(stroke_.radius(at.depth));
    return around == 0.0 || level == 0.0 ? along : std::min(along, around / level);
  }

  double
  area() const override
  {
    return stroke_.length(piece_.meanDepth()) * piece_.length();
  }

  Vec3
  randomPoint(Random& random) const override
  {
    const double longest =
        std::max(stroke_.length(piece_.begin.depth), stroke_.length(piece_.end.depth));
    for (;;) {
      const SectionPoint at = piece_.point(random.uniform());
      if (random.uniform() * longest >= stroke_.length(at.depth))
        continue;
      const Vec3 p = stroke_.point(random.uniform(), at.depth);
      return {p.x, p.y, at.height};
    }
  }

private:
  SectionPoint
  section(const Vec3& p) const
  {
    return {stroke_.depthOf(p), p.z};
  }

  double
  root(const Ray& ray, double low, double high) const
  {
    const auto value = [&](double t) {
      return piece_.distance(section(ray.origin + ray.direction * t));
    };
    double at_low = value(low), at_high = value(high);
    constexpr int max_steps = 60; // a bisection alone reaches the last bit by then
    for (int i = 0; i < max_steps && high - low > 1e-15 * high; ++i) {
      // Secants settle at once where the face is flat; bisection bounds the rest.
      double t = low + at_low / (at_low - at_high) * (high - low);
      if (i % 2 == 1 || !(t > low && t < high))
        t = 0.5 * (low + high);
      const double at = value(t);
      if (std::abs(at) < 1e-14)
        return t;
      ((at < 0.0) == (at_low < 0.0) ? low : high) = t;
      ((at < 0.0) == (at_low < 0.0) ? at_low : at_high) = at;
    }
    return 0.5 * (low + high);
  }

  Stroke stroke_;
  SectionPiece piece_;
};

} // namespace

std::shared_ptr<const PartFace>
levelFace(double height,
          bool faces_up,
          const Outline& outer,
          const std::vector<Outline>& holes)
{
  return std::make_shared<LevelFace>(height, faces_up, outer, holes);
}

std::shared_ptr<const PartFace>
stripFace(const Stroke& stroke, const SectionPiece& piece)
{
  return std::make_shared<StripFace>(stroke, piece);
}

} // namespace pcl::scene
