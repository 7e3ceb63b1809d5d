// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Edges and rims of objects, cut to the parts of which both sides are seen.

#include "scene/creases.h"

#include "scene/parts/part.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace pcl::scene {
namespace {

constexpr double contact_tolerance = 1e-7;
constexpr double beside = 1e-3; // how far beside a crease its faces are looked at
constexpr double beside_on_part = 2e-4;   // likewise: faces of parts are narrow
constexpr double beside_tolerance = 1e-4; // a round face bends away that much
constexpr double table_step = 1e-3; // where visibility is looked up: objects are small
constexpr double end_accuracy = 1e-6;
constexpr double same_plane = 1.0 - 1e-9; // cosine: the tops of two walls are one face

/** Decides whether a point of an edge is a crease for the observer. */
class Visibility {
public:
  Visibility(const World& world, const std::vector<Observer>& observers)
  : world_(world)
  , observers_(observers)
  , caster_(world)
  {}

  bool
  seesTwoFaces(const Vec3& point, const Vec3& tangent) const
  {
    std::optional<Vec3> first; // the normal of a face that is seen
    const auto isSecond = [&](const Vec3& normal) {
      const bool is_first = !first;
      first = first.value_or(normal);
      return !is_first && dot(*first, normal) < same_plane;
    };
    const Vec3 up{0.0, 0.0, 1.0};
    const auto isOnTable = [this](const Vec3& p) { return world_.table.contains(p); };
    if (std::abs(point.z) <= contact_tolerance && isOnTable(point) &&
        seesBeside(point, tangent, up, beside, isOnTable))
      first = up;
    for (const Solid& solid : world_.solids) {
      const double step = solid.shape == Shape::Part ? beside_on_part : beside;
      for (const FaceAt& at : facesAt(solid, point, contact_tolerance)) {
        const auto isOnFace = [&](const Vec3& p) {
          const auto faces = facesAt(solid, p, beside_tolerance);
          return std::any_of(faces.begin(), faces.end(), [&](const FaceAt& face) {
            return face.face == at.face;
          });
        };
        if (seesBeside(point, tangent, at.normal, step, isOnFace) &&
            isSecond(at.normal))
          return true;
      }
    }
    return false;
  }

private:
  template <class Contains>
  bool
  seesBeside(const Vec3& point,
             const Vec3& tangent,
             const Vec3& normal,
             double step,
             Contains contains) const
  {
    const Vec3 into_face = normalized(cross(normal, tangent)) * step;
    for (const Vec3& neighbor : {point + into_face, point - into_face})
      if (contains(neighbor) && isSeen(neighbor, normal))
        return true;
    return false;
  }

  bool
  isSeen(const Vec3& point, const Vec3& normal) const
  {
    return std::any_of(
        observers_.begin(), observers_.end(), [&](const Observer& observer) {
          return caster_.seen(observer, point, normal);
        });
  }

  const World& world_;
  const std::vector<Observer>& observers_;
  RayCaster caster_;
};

/** The parameter between a visible and a hidden one where visibility changes. */
double
bisect(const Visibility& visibility, const Curve& curve, double visible, double hidden)
{
  while (std::abs(hidden - visible) * curve.length() > end_accuracy) {
    const double middle = 0.5 * (visible + hidden);
    const bool seen =
        visibility.seesTwoFaces(curve.point(middle), curve.tangent(middle));
    (seen ? visible : hidden) = middle;
  }
  return visible;
}

std::vector<Curve>
visibleParts(const Visibility& visibility, const Curve& curve, double sampling_step)
{
  const int steps = static_cast<int>(std::ceil(curve.length() / sampling_step));
  const auto middleOf = [&](int step) { return (step + 0.5) / steps; };
  std::vector<Curve> parts;
  double from = 0.0, previous = 0.0;
  bool was_visible = false;
  for (int step = 0; step < steps; ++step) {
    const double parameter = middleOf(step);
    const bool visible =
        visibility.seesTwoFaces(curve.point(parameter), curve.tangent(parameter));
    if (visible && !was_visible)
      from = bisect(visibility, curve, parameter, previous);
    if (!visible && was_visible)
      parts.push_back(curve.part(from, bisect(visibility, curve, previous, parameter)));
    was_visible = visible;
    previous = parameter;
  }
  if (was_visible)
    parts.push_back(curve.part(from, bisect(visibility, curve, previous, 1.0)));
  return parts;
}

Curve
circleAround(const Solid& solid, double height, double radius)
{
  const Pose& pose = solid.pose;
  return Curve::circle(
      pose.origin + pose.axes[2] * height, pose.axes[0], pose.axes[1], radius);
}

std::vector<Curve>
boxEdges(const Solid& box)
{
  std::vector<Curve> edges;
  for (std::size_t along = 0; along < 3; ++along)
    for (const double side1 : {-0.5, 0.5})
      for (const double side2 : {-0.5, 0.5}) {
        const std::size_t i = (along + 1) % 3, j = (along + 2) % 3;
        const Vec3 middle = box.pose.origin + box.pose.axes[i] * (side1 * box.size[i]) +
                            box.pose.axes[j] * (side2 * box.size[j]);
        const Vec3 half = box.pose.axes[along] * (0.5 * box.size[along]);
        edges.push_back(Curve::segment(middle - half, middle + half));
      }
  return edges;
}

std::vector<Curve>
partCreases(const Solid& solid)
{
  std::vector<Curve> creases;
  for (const Curve& crease : solid.part->creases())
    creases.push_back(crease.placed(solid.pose));
  return creases;
}

} // namespace

std::vector<Curve>
edges(const Solid& solid)
{
  switch (solid.shape) {
  case Shape::Box:
    return boxEdges(solid);
  case Shape::Cylinder:
    return {circleAround(solid, 0.0, solid.size[0]),
            circleAround(solid, solid.size[1], solid.size[0])};
  case Shape::Cone:
    return {circleAround(solid, 0.0, solid.size[0])};
  case Shape::Bowl:
    if (solid.pose.axes[2].z > 0.0)
      return {};
    return {circleAround(solid, solid.size[1], bowlOpening(solid).outer)};
  case Shape::Sphere:
    return {};
  case Shape::Part:
    return partCreases(solid);
  }
  return {};
}

std::vector<Curve>
thinPlaces(const Solid& solid)
{
  if (solid.shape == Shape::Bowl && solid.pose.axes[2].z > 0.0) {
    const BowlOpening opening = bowlOpening(solid);
    return {circleAround(solid, solid.size[1], 0.5 * (opening.inner + opening.outer))};
  }
  if (solid.shape == Shape::Cone)
    return {circleAround(solid, solid.size[1], 0.0)};
  if (solid.shape == Shape::Part) {
    std::vector<Curve> lines;
    for (const Seam& seam : solid.part->seams())
      lines.push_back(seam.line.placed(solid.pose));
    return lines;
  }
  return {};
}

ThinPlaces::ThinPlaces(const World& world)
{
  for (const Solid& solid : world.solids)
    places_.push_back(thinPlaces(solid));
}

bool
ThinPlaces::areNear(const Sight& sight, double distance) const
{
  if (sight.object <= table_index)
    return false;
  const auto& places = places_[static_cast<std::size_t>(sight.object - 1)];
  return std::any_of(places.begin(), places.end(), [&](const Curve& place) {
    return place.distance(sight.point) < distance;
  });
}

Creases::Creases(const World& world, const Observer& observer)
: Creases(world, std::vector<Observer>{observer}, table_step)
{}

Creases::Creases(const World& world,
                 const std::vector<Observer>& observers,
                 double step)
{
  const Visibility visibility(world, observers);
  for (const auto& solid : world.solids)
    for (const auto& edge : edges(solid))
      for (const auto& part : visibleParts(visibility, edge, step)) {
        parts_.push_back(part);
        bounds_.push_back(part.bounds());
      }
}

double
Creases::distance(const Vec3& point, double cap) const
{
  double nearest = cap;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const double reach = bounds_[i].radius + nearest;
    if (squaredNorm(point - bounds_[i].center) < reach * reach)
      nearest = std::min(nearest, parts_[i].distance(point));
  }
  return nearest;
}

} // namespace pcl::scene
