// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Parts of one body on either side of what hides its middle.

#include "instances/objects/hidden_parts.h"

#include "common/parallel.h"
#include "common/quiet.h"
#include "geometry/principal_axes.h"
#include "instances/objects/lines_of_sight.h"
#include "instances/primitives/instance_primitive.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iterator>
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
// Of the lengths of both faces together: each surface is extended by its own length,
// where the error of its direction puts it off three times as far as at its own end.
constexpr float max_gap = 1.0f;

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

/** Whether the direction of a surface through two faces differs from that of each no
 * more than theirs differ. A plane that rises from one face to a higher, parallel one
 * is tilted to both. */
bool
isBetween(const ShapePrimitive& one, const ShapePrimitive& a, const ShapePrimitive& b)
{
  const float limit = angleBetween(a, b) + max_tilt;
  return one.type == PrimitiveType::Sphere ||
         std::max(angleBetween(one, a), angleBetween(one, b)) < limit;
}

/** A face of one group and the face of another that goes on with its surface. */
struct FacePair {
  std::size_t first, second;
};

/** Groups of faces, and which of them are one body. */
class HiddenParts {
public:
  HiddenParts(const InstanceInput& input,
              const Labels& faces,
              const std::vector<Face>& properties,
              const Labels& groups)
  : input_(input)
  , spacing_(medianSpacing(input))
  , properties_(properties)
  , members_(membersInOrder(input, faces, properties.size(), [&](std::uint32_t i) {
    return mayJoin(static_cast<std::size_t>(faces[i]), groups);
  }))
  {
    for (const Members& members : members_) {
      boxes_.emplace_back();
      for (const std::uint32_t i : members)
        boxes_.back().extend(positionOf(input.points, i));
    }
    std::map<std::int32_t, std::vector<std::size_t>> faces_of;
    for (std::size_t f = 0; f < groups.size(); ++f)
      if (mayJoin(f, groups))
        faces_of[groups[f]].push_back(f);
    for (auto& [group, its_faces] : faces_of)
      groups_.push_back({group, std::move(its_faces)});
  }

  void
  join(Labels& groups) const
  {
    const std::vector<Continuation> continuations = allContinuations();
    if (continuations.empty())
      return;
    const SeenDirections seen(input_);
    std::vector<char> are_hidden(continuations.size());
    kernels::parallelFor(continuations.size(), input_.threads, [&](std::size_t k) {
      const std::vector<FacePair>& pairs = continuations[k].pairs;
      are_hidden[k] =
          std::all_of(pairs.begin(), pairs.end(), [&](const FacePair& pair) {
            return linesBetween(pair).areHidden(seen);
          });
    });
    for (std::size_t k = 0; k < continuations.size(); ++k) {
      const std::int32_t first = groups[continuations[k].first];
      const std::int32_t second = groups[continuations[k].second];
      if (are_hidden[k])
        std::replace(groups.begin(),
                     groups.end(),
                     std::max(first, second),
                     std::min(first, second));
    }
  }

private:
  struct Group {
    std::int32_t label;
    std::vector<std::size_t> faces;
  };

  /** Two groups whose surfaces go on from one to the other. */
  struct Continuation {
    std::size_t first, second; ///< a face of each
    std::vector<FacePair> pairs;
  };

  bool
  mayJoin(std::size_t face, const Labels& groups) const
  {
    return groups[face] >= 0 && properties_[face].points >= min_points;
  }

  /** Of all pairs of groups, in their order. */
  std::vector<Continuation>
  allContinuations() const
  {
    std::vector<std::vector<Continuation>> of_groups(groups_.size());
    kernels::parallelFor(groups_.size(), input_.threads, [&](std::size_t a) {
      for (std::size_t b = a + 1; b < groups_.size(); ++b) {
        std::vector<FacePair> pairs = pairsThatGoOn(groups_[a].faces, groups_[b].faces);
        if (!pairs.empty())
          of_groups[a].push_back(
              {groups_[a].faces.front(), groups_[b].faces.front(), std::move(pairs)});
      }
    });
    std::vector<Continuation> all;
    for (std::vector<Continuation>& of_group : of_groups)
      std::move(of_group.begin(), of_group.end(), std::back_inserter(all));
    return all;
  }

  /** One pair of curved faces, or two of planes in two directions; else none. */
  std::vector<FacePair>
  pairsThatGoOn(const std::vector<std::size_t>& first,
                const std::vector<std::size_t>& second) const
  {
    std::vector<FacePair> planes;
    for (const std::size_t a : first)
      for (const std::size_t b : second) {
        if (!areAlike(properties_[a], properties_[b]) || !areNear({a, b}) ||
            !areOneSurface(a, b))
          continue;
        const ShapePrimitive& surface = properties_[a].surface;
        if (surface.type != PrimitiveType::Plane)
          return {{a, b}};
        for (const FacePair& other : planes)
          if (std::abs(directionOf(surface).dot(
                  directionOf(properties_[other.first].surface))) < other_direction)
            return {{a, b}, other};
        planes.push_back({a, b});
      }
    return {};
  }

  LinesOfSight
  linesBetween(const FacePair& pair) const
  {
    return LinesOfSight(input_, members_[pair.first], members_[pair.second]);
  }

  bool
  areNear(const FacePair& pair) const
  {
    const double lengths =
        properties_[pair.first].length + properties_[pair.second].length;
    const float limit = max_gap * spacing_ * static_cast<float>(lengths);
    // Boxes are no farther apart than what they hold, and take less time.
    return boxes_[pair.first].exteriorDistance(boxes_[pair.second]) <= limit &&
           linesBetween(pair).gap() <= limit;
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

  const InstanceInput& input_;
  float spacing_;
  const std::vector<Face>& properties_;
  std::vector<Members> members_;
  std::vector<Eigen::AlignedBox3f> boxes_; ///< around the members
  std::vector<Group> groups_;              ///< by their labels
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
