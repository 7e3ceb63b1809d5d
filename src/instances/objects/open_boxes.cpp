// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Inner walls by their concave edges, outer walls and floors by where they are.

#include "instances/objects/open_boxes.h"

#include "common/disjoint_sets.h"
#include "instances/objects/body_sample.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace pcl::segmentation {
namespace {

using detail::InstanceInput;
using Eigen::Vector3f;

constexpr std::size_t min_points = 30;   // fewer are a rim, or noise
constexpr float min_share = 0.8f;        // of the points: some are at a rim
constexpr float min_flat = 0.95f;        // length of the mean normal: one plane
constexpr float max_corner = 0.5f;       // cosine of the normals of two sides of a box
constexpr float min_edge = 0.5f;         // of the height: where two inner walls meet
constexpr float max_rim_step = 0.15f;    // of the height: walls end at the same height
constexpr float max_rim_spacings = 3.0f; // likewise, beyond the band of an edge
// Walls are thin: as far as a tenth or so of the box, or the bands of two edges.
constexpr float max_thickness = 0.15f, max_thickness_spacings = 6.0f;
// Of the size of the inside, of which often only two walls are seen: a corner.
constexpr float max_beyond = 2.0f;

/** The groups' faces, without their edges. */
std::vector<BodySample>
bodiesOf(const InstanceInput& input,
         const Vector3f& up,
         const Labels& faces,
         const Labels& groups)
{
  Labels bodies(faces.size(), -1);
  for (std::size_t i = 0; i < faces.size(); ++i)
    if (faces[i] >= 0)
      bodies[i] = groups[static_cast<std::size_t>(faces[i])];
  return bodySamples(input, up, bodies, groups.size());
}

/** Whether a body is mostly walls, without a lid. */
bool
isOpenWall(const BodySample& body)
{
  return body.points.size() >= min_points && body.upright >= min_share;
}

bool
endAtOneHeight(const BodySample& a, const BodySample& b)
{
  const float height = std::max(a.high - a.low, b.high - b.low);
  const float limit = std::max(max_rim_step * height,
                               max_rim_spacings * std::max(a.spacing, b.spacing));
  return std::abs(a.high - b.high) <= limit;
}

/** Two sides of an inside: they meet at an upright concave edge. */
bool
areInnerWalls(const BodySample& a, const BodySample& b, float concave)
{
  const float height = std::min(a.high - a.low, b.high - b.low);
  return isOpenWall(a) && isOpenWall(b) && a.facing.norm() > min_flat &&
         b.facing.norm() > min_flat && std::abs(a.facing.dot(b.facing)) < max_corner &&
         endAtOneHeight(a, b) && concave * a.spacing > min_edge * height &&
         a.facing.dot(b.middle - a.middle) > 0.0f &&
         b.facing.dot(a.middle - b.middle) > 0.0f;
}

/** Some walls, or their points, as one. */
BodySample
together(const std::vector<BodySample>& bodies, const std::vector<std::size_t>& some)
{
  BodySample all;
  all.low = std::numeric_limits<float>::infinity();
  all.high = -all.low;
  for (const std::size_t k : some) {
    const BodySample& body = bodies[k];
    all.points.insert(all.points.end(), body.points.begin(), body.points.end());
    all.normals.insert(all.normals.end(), body.normals.begin(), body.normals.end());
    all.low = std::min(all.low, body.low);
    all.high = std::max(all.high, body.high);
    all.spacing = std::max(all.spacing, body.spacing);
    all.middle += body.middle / static_cast<float>(some.size());
  }
  return all;
}

/** Level, from a middle. */
float
farthest(const BodySample& body, const Vector3f& middle, const Vector3f& up)
{
  float radius = 0.0f;
  for (const Vector3f& point : body.points)
    radius = std::max(radius, levelPart(point - middle, up).norm());
  return radius;
}

/** The nearest two sampled points. */
float
distanceBetween(const BodySample& a, const BodySample& b)
{
  float nearest = std::numeric_limits<float>::infinity();
  for (const Vector3f& p : a.points)
    for (const Vector3f& q : b.points)
      nearest = std::min(nearest, (p - q).squaredNorm());
  return std::sqrt(nearest);
}

/** The share of the points that face away from a middle. */
float
outwardShare(const BodySample& body, const Vector3f& middle, const Vector3f& up)
{
  std::size_t outward = 0;
  for (std::size_t k = 0; k < body.points.size(); ++k)
    outward += levelPart(body.points[k] - middle, up).dot(body.normals[k]) > 0.0f;
  return static_cast<float>(outward) / static_cast<float>(body.points.size());
}

/** Whether a body is an outer wall around an inside, back to back with it. */
bool
isOutside(const BodySample& body, const BodySample& inside, const Vector3f& up)
{
  if (!isOpenWall(body) || !endAtOneHeight(body, inside) ||
      outwardShare(body, inside.middle, up) < min_share)
    return false;
  const float size = farthest(inside, inside.middle, up);
  const float limit =
      std::max(max_thickness * size, max_thickness_spacings * inside.spacing);
  return farthest(body, inside.middle, up) < max_beyond * size &&
         distanceBetween(body, inside) < limit;
}

/** Whether a body is the floor between inner walls, at their feet. */
bool
isFloor(const BodySample& body, const BodySample& inside, const Vector3f& up)
{
  const float limit = max_thickness_spacings * inside.spacing;
  if (body.points.size() < min_points || body.level < min_share ||
      std::abs(body.high - inside.low) >
          std::max(limit, max_rim_step * (inside.high - inside.low)) ||
      distanceBetween(body, inside) > limit)
    return false;
  return farthest(body, inside.middle, up) <
         farthest(inside, inside.middle, up) + limit;
}

/** Whether the middles of some insides are before one wall, along it. */
bool
spans(const BodySample& wall,
      const std::vector<const BodySample*>& insides,
      const Vector3f& up)
{
  const Vector3f along = up.cross(wall.facing);
  float low = std::numeric_limits<float>::infinity(), high = -low;
  for (const Vector3f& point : wall.points) {
    low = std::min(low, along.dot(point));
    high = std::max(high, along.dot(point));
  }
  return std::all_of(insides.begin(), insides.end(), [&](const BodySample* inside) {
    const float middle = along.dot(inside->middle);
    return low < middle && middle < high;
  });
}

struct Inside {
  std::vector<std::size_t> walls;
  BodySample body;     ///< of the walls
  float radius = 0.0f; ///< level, from the middle to the farthest point
};

/** Whether the middles alone show that they are more than a wall apart. */
bool
areFarApart(const Inside& first, const Inside& second, const Vector3f& up)
{
  const float apart = levelPart(first.body.middle - second.body.middle, up).norm();
  // The middle of both is between theirs, so this is as large as both are, or more.
  const float size = apart + std::max(first.radius, second.radius);
  const float limit = std::max(max_thickness * size,
                               max_thickness_spacings *
                                   std::max(first.body.spacing, second.body.spacing));
  constexpr float but_rounding = 0.99f; // far more than floats are off
  return but_rounding * apart > first.radius + second.radius + limit;
}

/** Two compartments of a crate: a wall apart, and with one outer wall along both, which
 * two boxes that touch do not have. */
bool
areCompartments(const std::vector<BodySample>& bodies,
                const Inside& first,
                const Inside& second,
                const Vector3f& up)
{
  const BodySample &a = first.body, &b = second.body;
  if (!endAtOneHeight(a, b) || areFarApart(first, second, up))
    return false;
  std::vector<std::size_t> walls = first.walls;
  walls.insert(walls.end(), second.walls.begin(), second.walls.end());
  const BodySample both = together(bodies, walls);
  const float limit = std::max(max_thickness * farthest(both, both.middle, up),
                               max_thickness_spacings * both.spacing);
  if (distanceBetween(a, b) > limit)
    return false;
  for (std::size_t k = 0; k < bodies.size(); ++k)
    if (std::find(walls.begin(), walls.end(), k) == walls.end() &&
        isOutside(bodies[k], both, up) && spans(bodies[k], {&a, &b}, up))
      return true;
  return false;
}

/** Compartments of one crate are one inside. */
std::vector<std::vector<std::size_t>>
joinCompartments(const std::vector<BodySample>& bodies,
                 const std::vector<std::vector<std::size_t>>& walls_of_insides,
                 const Vector3f& up)
{
  std::vector<Inside> insides;
  for (const std::vector<std::size_t>& walls : walls_of_insides) {
    BodySample body = together(bodies, walls);
    const float radius = farthest(body, body.middle, up);
    insides.push_back({walls, std::move(body), radius});
  }
  DisjointSets sets(insides.size());
  for (std::uint32_t a = 0; a < insides.size(); ++a)
    for (std::uint32_t b = a + 1; b < insides.size(); ++b)
      if (areCompartments(bodies, insides[a], insides[b], up))
        sets.unite(a, b);
  std::map<std::uint32_t, std::vector<std::size_t>> by_root;
  for (std::uint32_t k = 0; k < insides.size(); ++k) {
    auto& walls = by_root[sets.find(k)];
    walls.insert(walls.end(), insides[k].walls.begin(), insides[k].walls.end());
  }
  std::vector<std::vector<std::size_t>> joined;
  for (auto& [root, walls] : by_root)
    joined.push_back(std::move(walls));
  return joined;
}

/** The insides, as lists of bodies: inner walls that meet. */
std::vector<std::vector<std::size_t>>
insidesOf(const std::vector<BodySample>& bodies,
          const std::map<std::pair<std::size_t, std::size_t>, float>& concave)
{
  DisjointSets sets(bodies.size());
  for (const auto& [pair, length] : concave)
    if (areInnerWalls(bodies[pair.first], bodies[pair.second], length))
      sets.unite(static_cast<std::uint32_t>(pair.first),
                 static_cast<std::uint32_t>(pair.second));
  std::map<std::size_t, std::vector<std::size_t>> by_root;
  for (std::uint32_t k = 0; k < bodies.size(); ++k)
    by_root[sets.find(k)].push_back(k);
  std::vector<std::vector<std::size_t>> insides;
  for (auto& [root, walls] : by_root)
    if (walls.size() > 1)
      insides.push_back(std::move(walls));
  return insides;
}

} // namespace

void
joinOpenBoxes(const InstanceInput& input,
              const Vector3f& up,
              const Labels& faces,
              const std::vector<FaceContact>& contacts,
              const Labels& groups,
              Labels& labels)
{
  const std::vector<BodySample> bodies = bodiesOf(input, up, faces, groups);
  std::map<std::pair<std::size_t, std::size_t>, float> concave;
  for (const FaceContact& contact : contacts) {
    const auto [a, b] = std::minmax(groups[static_cast<std::size_t>(contact.first)],
                                    groups[static_cast<std::size_t>(contact.second)]);
    if (a >= 0 && a != b)
      concave[{static_cast<std::size_t>(a), static_cast<std::size_t>(b)}] +=
          contact.concave - contact.convex;
  }
  std::vector<std::int32_t> joined(bodies.size());
  for (std::size_t k = 0; k < joined.size(); ++k)
    joined[k] = static_cast<std::int32_t>(k);
  const std::vector<std::vector<std::size_t>> insides =
      joinCompartments(bodies, insidesOf(bodies, concave), up);
  std::vector<char> is_inner(bodies.size(), 0); // a wall has one box
  for (const std::vector<std::size_t>& walls : insides)
    for (const std::size_t wall : walls)
      is_inner[wall] = 1;
  for (const std::vector<std::size_t>& walls : insides) {
    const BodySample inside = together(bodies, walls);
    const auto name = static_cast<std::int32_t>(walls.front());
    for (const std::size_t wall : walls)
      joined[wall] = name;
    for (std::size_t k = 0; k < bodies.size(); ++k)
      if (!is_inner[k] && joined[k] == static_cast<std::int32_t>(k) &&
          (isOutside(bodies[k], inside, up) || isFloor(bodies[k], inside, up)))
        joined[k] = name;
  }
  for (std::int32_t& label : labels)
    if (label >= 0)
      label = joined[static_cast<std::size_t>(label)];
}

} // namespace pcl::segmentation
