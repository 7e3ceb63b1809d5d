// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What the viewpoint sees of the space between two faces.

#include "instances/objects/lines_of_sight.h"

#include "common/finite.h"
#include "common/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::segmentation {
namespace {

using detail::InstanceInput;
using Eigen::Vector3f;
using Members = std::vector<std::uint32_t>;

constexpr float cell = 0.02f; // of directions: a degree, less than most gaps are wide
// An angle near 0 is off by this much if its cosine is by the rounding of some floats.
constexpr float rounding = 2e-3f;
constexpr float half_turn = static_cast<float>(M_PI);

constexpr std::size_t max_ends = 150;         // points of a face that lines begin at
constexpr std::size_t lines = 12, places = 8; // between two faces, and on each line
constexpr float before = 3.0f; // in spacings: beyond the noise of a far point
// Beside a nearer body some sensors see nothing, so not all places must be behind it.
// A ray that goes on to something farther shows that a body ends, but for the points
// that fly at its border.
constexpr float min_covered = 0.5f, max_beyond = 0.1f;

Vector3f
fromViewPoint(const InstanceInput& input, std::uint32_t i)
{
  return positionOf(input.points, i) - input.view_point;
}

std::vector<Vector3f>
directionsOf(const InstanceInput& input)
{
  std::vector<Vector3f> directions(input.points.size);
  kernels::parallelForEach(directions.size(), input.threads, [&](std::size_t i) {
    const auto k = static_cast<std::uint32_t>(i);
    directions[i] = kernels::isFinite(input.points[i])
                        ? Vector3f(fromViewPoint(input, k).normalized())
                        : Vector3f::Constant(std::numeric_limits<float>::quiet_NaN());
  });
  return directions;
}

XYZView
viewOf(const std::vector<Vector3f>& vectors)
{
  return {vectors.empty() ? nullptr : vectors.front().data(), 3, vectors.size()};
}

/** At most max_ends of them, evenly in their order. */
Members
some(const Members& members)
{
  const std::size_t step = (members.size() + max_ends - 1) / max_ends;
  Members chosen;
  for (std::size_t k = 0; k < members.size(); k += step)
    chosen.push_back(members[k]);
  return chosen;
}

struct Line {
  float squared_length;
  std::uint32_t from, to;
};

/** To the nearest of some points. */
Line
lineFrom(std::uint32_t from, const Members& ends, const XYZView& points)
{
  const Vector3f start = positionOf(points, from);
  Line line{std::numeric_limits<float>::infinity(), from, ends.front()};
  for (const std::uint32_t end : ends) {
    const float squared = (positionOf(points, end) - start).squaredNorm();
    if (squared < line.squared_length)
      line = {squared, from, end};
  }
  return line;
}

} // namespace

SeenDirections::SeenDirections(const InstanceInput& input)
: input_(input)
, directions_(directionsOf(input))
, grid_(viewOf(directions_), cell, input.threads)
{}

Members
SeenDirections::inCone(const Vector3f& axis, float angle) const
{
  const float chord = 2.0f * std::sin(0.5f * std::min(half_turn, angle));
  const float min_cosine = std::cos(angle);
  Members inside;
  grid_.forEachWithin(axis, chord + rounding, [&](std::uint32_t i, float) {
    const Vector3f from = fromViewPoint(input_, i);
    if (from.dot(axis) > min_cosine * from.norm())
      inside.push_back(i);
  });
  return inside;
}

LinesOfSight::LinesOfSight(const InstanceInput& input,
                           const Members& from,
                           const Members& to)
: input_(input)
{
  const Members starts = some(from), ends = some(to);
  std::vector<Line> all;
  for (const std::uint32_t start : starts)
    all.push_back(lineFrom(start, ends, input.points));
  std::stable_sort(all.begin(), all.end(), [](const Line& a, const Line& b) {
    return a.squared_length < b.squared_length;
  });
  gap_ = std::sqrt(all.front().squared_length);
  all.resize(std::min(lines, all.size()));
  for (const Line& line : all)
    addLine(line.from, line.to);
}

void
LinesOfSight::addLine(std::uint32_t from, std::uint32_t to)
{
  const Vector3f start = fromViewPoint(input_, from), end = fromViewPoint(input_, to);
  const float spacing = std::max(input_.spacings[from], input_.spacings[to]);
  for (std::size_t k = 1; k <= places; ++k) {
    const float share = static_cast<float>(k) / static_cast<float>(places + 1);
    const Vector3f place = start + share * (end - start);
    places_.push_back({place.normalized(), place.norm(), spacing});
  }
}

bool
LinesOfSight::areHidden(const SeenDirections& seen) const
{
  const Members near = pointsInView(seen);
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

/** The points in the cone around all places. */
Members
LinesOfSight::pointsInView(const SeenDirections& seen) const
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
  return seen.inCone(axis, std::acos(std::min(1.0f, min_cosine)) + 2.0f * spacing);
}

LinesOfSight::Sight
LinesOfSight::sightAt(const Place& place, const Members& near) const
{
  float nearest = std::numeric_limits<float>::infinity();
  for (const std::uint32_t i : near) {
    const Vector3f from = fromViewPoint(input_, i);
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

} // namespace pcl::segmentation
