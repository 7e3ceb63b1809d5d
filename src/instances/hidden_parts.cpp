// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Parts of one body on either side of what hides its middle.

#include "instances/hidden_parts.h"

#include "common/finite.h"
#include "common/quiet.h"
#include "geometry/point_grid.h"
#include "geometry/principal_axes.h"
#include "instances/instance_primitive.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace pcl::segmentation {
namespace {

using detail::InstanceInput;
using Eigen::Vector3f;
using Members = std::vector<std::uint32_t>;

constexpr std::size_t min_points = 100; // a disc of 3 spacings, which has a direction
constexpr std::size_t max_fitted = 500; // likewise of single faces
// Of what one face may be off its surface, likewise of gaps: both are extended far.
constexpr float off_both = 1.5f;
// Planes and axes to try: they are off by a few degrees, as faces are small.
constexpr float same_direction = 0.966f; // cosine of 15 degrees
constexpr float other_direction = 0.94f; // of 20: as flat as one face may be
constexpr float max_tilt = 0.035f;       // of 2 degrees: noise
constexpr float max_radius_ratio = 1.25f;

constexpr std::size_t max_ends = 150;         // points of a face that lines begin at
constexpr std::size_t lines = 12, places = 8; // between two faces, and on each line
constexpr float before = 3.0f; // in spacings: beyond the noise of a far point
// Beside what is nearer some sensors see nothing; what is farther is seen past the end
// of a body, but for the points that fly at its border.
constexpr float min_covered = 0.5f, max_beyond = 0.1f;

Vector3f
directionOf(const ShapePrimitive& surface)
{
  const std::vector<float>& c = surface.coefficients;
  return surface.type == PrimitiveType::Cylinder ? Vector3f(c[3], c[4], c[5])
                                                 : Vector3f(c[0], c[1], c[2]);
}

/** Alike enough to try one surface for both. */
bool
areAlike(const Face& a, const Face& b)
{
  if (a.surface.type != b.surface.type || a.surface.type == PrimitiveType::None ||
      std::min(a.points, b.points) < min_points)
    return false;
  if (a.surface.type != PrimitiveType::Plane) {
    const auto [small, large] =
        std::minmax(a.surface.coefficients.back(), b.surface.coefficients.back());
    if (!(large < max_radius_ratio * small))
      return false;
  }
  return a.surface.type == PrimitiveType::Sphere ||
         std::abs(directionOf(a.surface).dot(directionOf(b.surface))) > same_direction;
}

/** By least squares: there are many planes to try. */
ShapePrimitive
planeOf(const PrimitiveSample& sample)
{
  const auto& points = sample.points->points;
  const Plane<float> plane = fitPlane<float>([&](const auto& visit) {
    for (const auto& point : points)
      visit(Vector3f(point.getVector3fMap()));
  });
  float squares = 0.0f;
  for (const auto& point : points) {
    const float distance = plane.distance(point.getVector3fMap());
    squares += distance * distance;
  }
  ShapePrimitive fitted;
  fitted.type = PrimitiveType::Plane;
  const Vector3f& n = plane.normal;
  fitted.coefficients = {n.x(), n.y(), n.z(), -n.dot(plane.center)};
  fitted.residual = std::sqrt(squares / static_cast<float>(points.size()));
  return fitted;
}

float
angleBetween(const ShapePrimitive& a, const ShapePrimitive& b)
{
  const float cosine = std::abs(directionOf(a).dot(directionOf(b)));
  return std::acos(std::min(1.0f, cosine));
}

/** No more tilted to one of two than these are to each other: a plane through two
 * levels is. */
bool
isBetween(const ShapePrimitive& one, const ShapePrimitive& a, const ShapePrimitive& b)
{
  const float limit = angleBetween(a, b) + max_tilt;
  return one.type == PrimitiveType::Sphere ||
         std::max(angleBetween(one, a), angleBetween(one, b)) < limit;
}

/** What the ray from the viewpoint to a place meets. */
enum class Sight { Nothing, Nearer, There, Beyond };

/** Lines between two faces, and what is seen along them. */
class LinesOfSight {
public:
  LinesOfSight(const InstanceInput& input, const Members& from, const Members& to)
  : input_(input)
  {
    const Members starts = some(from), ends = some(to);
    std::vector<std::pair<float, std::pair<std::uint32_t, std::uint32_t>>> pairs;
    for (const std::uint32_t i : starts) {
      const Vector3f start = positionOf(input.points, i);
      float nearest = std::numeric_limits<float>::infinity();
      std::uint32_t end = ends.front();
      for (const std::uint32_t k : ends) {
        const float squared = (positionOf(input.points, k) - start).squaredNorm();
        if (squared < nearest) {
          nearest = squared;
          end = k;
        }
      }
      pairs.push_back({nearest, {i, end}});
    }
    std::stable_sort(pairs.begin(), pairs.end(), [](const auto& a, const auto& b) {
      return a.first < b.first;
    });
    pairs.resize(std::min(lines, pairs.size()));
    for (const auto& [distance, pair] : pairs)
      addLine(pair.first, pair.second);
  }

  /** Whether something nearer hides what is between the faces. */
  bool
  areHidden() const
  {
    const Members near = pointsInView();
    std::size_t covered = 0, beyond = 0;
    for (const Place& place : places_) {
      const Sight sight = sightAt(place, near);
      covered += sight == Sight::Nearer ? 1 : 0;
      beyond += sight == Sight::Beyond ? 1 : 0;
    }
    const auto all = static_cast<float>(places_.size());
    return static_cast<float>(covered) >= min_covered * all &&
           static_cast<float>(beyond) <= max_beyond * all;
  }

private:
  struct Place {
    Vector3f direction; ///< unit, from the viewpoint
    float distance;     ///< from it
    float spacing;
  };

  static Members
  some(const Members& members)
  {
    const std::size_t step = (members.size() + max_ends - 1) / max_ends;
    Members chosen;
    for (std::size_t k = 0; k < members.size(); k += step)
      chosen.push_back(members[k]);
    return chosen;
  }

  void
  addLine(std::uint32_t from, std::uint32_t to)
  {
    const Vector3f start = positionOf(input_.points, from) - input_.view_point;
    const Vector3f end = positionOf(input_.points, to) - input_.view_point;
    const float spacing = std::max(input_.spacings[from], input_.spacings[to]);
    for (std::size_t k = 1; k <= places; ++k) {
      const float share = static_cast<float>(k) / static_cast<float>(places + 1);
      const Vector3f place = start + share * (end - start);
      places_.push_back({place.normalized(), place.norm(), spacing});
    }
  }

  /** The points in the cone around all places. */
  Members
  pointsInView() const
  {
    Vector3f axis = Vector3f::Zero();
    for (const Place& place : places_)
      axis += place.direction;
    axis.normalize();
    float min_cosine = 1.0f, spacing = 0.0f;
    for (const Place& place : places_) {
      min_cosine = std::min(min_cosine, axis.dot(place.direction));
      spacing = std::max(spacing, place.spacing / place.distance);
    }
    const float angle = std::acos(std::min(1.0f, min_cosine)) + 2.0f * spacing;
    Members near;
    for (std::uint32_t i = 0; i < input_.points.size; ++i) {
      if (!kernels::isFinite(input_.points[i]))
        continue;
      const Vector3f from = positionOf(input_.points, i) - input_.view_point;
      if (from.dot(axis) > std::cos(angle) * from.norm())
        near.push_back(i);
    }
    return near;
  }

  Sight
  sightAt(const Place& place, const Members& near) const
  {
    float nearest = std::numeric_limits<float>::infinity();
    for (const std::uint32_t i : near) {
      const Vector3f from = positionOf(input_.points, i) - input_.view_point;
      const float along = from.dot(place.direction);
      const float aside = (from - along * place.direction).squaredNorm();
      if (along > 0.0f && aside < input_.spacings[i] * input_.spacings[i])
        nearest = std::min(nearest, along);
    }
    if (!std::isfinite(nearest))
      return Sight::Nothing;
    const float step = before * place.spacing;
    return nearest < place.distance - step   ? Sight::Nearer
           : nearest > place.distance + step ? Sight::Beyond
                                             : Sight::There;
  }

  const InstanceInput& input_;
  std::vector<Place> places_;
};

class HiddenParts {
public:
  HiddenParts(const InstanceInput& input,
              const Labels& faces,
              const std::vector<Face>& properties,
              const Labels& groups)
  : input_(input)
  , properties_(properties)
  , members_(membersInOrder(input, faces, properties.size(), [&](std::uint32_t i) {
    return mayJoin(static_cast<std::size_t>(faces[i]), groups);
  }))
  {
    for (std::size_t f = 0; f < groups.size(); ++f)
      if (mayJoin(f, groups))
        faces_of_[groups[f]].push_back(f);
  }

  void
  join(Labels& groups) const
  {
    for (auto a = faces_of_.begin(); a != faces_of_.end(); ++a)
      for (auto b = std::next(a); b != faces_of_.end(); ++b) {
        const std::int32_t first = groups[a->second.front()];
        const std::int32_t second = groups[b->second.front()];
        if (first != second && areOne(a->second, b->second))
          std::replace(groups.begin(),
                       groups.end(),
                       std::max(first, second),
                       std::min(first, second));
      }
  }

private:
  bool
  mayJoin(std::size_t face, const Labels& groups) const
  {
    return groups[face] >= 0 && properties_[face].points >= min_points;
  }

  bool
  areOne(const std::vector<std::size_t>& first,
         const std::vector<std::size_t>& second) const
  {
    std::vector<std::pair<std::size_t, std::size_t>> planes;
    for (const std::size_t a : first)
      for (const std::size_t b : second) {
        if (!areAlike(properties_[a], properties_[b]) || !areOneSurface(a, b))
          continue;
        if (properties_[a].surface.type != PrimitiveType::Plane)
          return areHidden(a, b);
        for (const auto& [other_a, other_b] : planes)
          if (std::abs(directionOf(properties_[a].surface)
                           .dot(directionOf(properties_[other_a].surface))) <
              other_direction)
            return areHidden(a, b) && areHidden(other_a, other_b);
        planes.push_back({a, b});
      }
    return false;
  }

  /** One primitive describes both nearly as well as it must describe one. */
  bool
  areOneSurface(std::size_t a, std::size_t b) const
  {
    // As many of each: the larger one must not outvote the other.
    Members both;
    for (const std::size_t face : {a, b}) {
      const Members& all = members_[face];
      const std::size_t step = (all.size() + max_fitted - 1) / max_fitted;
      for (std::size_t k = 0; k < all.size(); k += step)
        both.push_back(all[k]);
    }
    const SurfaceSample sample =
        sampleOf(input_, both, 2 * max_fitted, properties_[a].origin);
    const ShapePrimitive &first = properties_[a].surface,
                         &second = properties_[b].surface;
    const ShapePrimitive one = first.type == PrimitiveType::Plane
                                   ? planeOf(sample)
                                   : fitTo(sample, first.type);
    return one.type != PrimitiveType::None &&
           one.residual < off_both * stepLimit(input_) && isBetween(one, first, second);
  }

  bool
  areHidden(std::size_t a, std::size_t b) const
  {
    return LinesOfSight(input_, members_[a], members_[b]).areHidden();
  }

  const InstanceInput& input_;
  const std::vector<Face>& properties_;
  std::vector<Members> members_;
  std::map<std::int32_t, std::vector<std::size_t>> faces_of_;
};

} // namespace

void
joinHiddenParts(const InstanceInput& input,
                const Labels& faces,
                const std::vector<Face>& properties,
                Labels& groups)
{
  const detail::Quiet quiet;
  HiddenParts(input, faces, properties, groups).join(groups);
}

} // namespace pcl::segmentation
