// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Cups and bowls: the inside, seen over the rim, and its floor belong to the outside.

#include "instances/objects/hollow_bodies.h"

#include "common/statistics.h"
#include "instances/extent.h"
#include "instances/objects/body_sample.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl::segmentation {
namespace {

using detail::InstanceInput;
using Eigen::Matrix3f;
using Eigen::Vector3f;

constexpr std::size_t min_points = 30; // of walls, or of a body in an image
// The mean cosine between the normals of a half cylinder's inside and the directions to
// its middle is about 0.6, of a plane 0.
constexpr float min_concavity = 0.25f;
// Of the points: those that face away from the axis, or towards it, or that a body is
// seen around. Some are noise.
constexpr float min_share = 0.8f;
// Normals of a quarter of a circle spread that much across their mean, of a plane not.
constexpr float min_spread = 0.05f;
constexpr float max_miss = 0.35f; // of the radius: how far normals pass by the axis
// Walls are thin, and lean outward: inside and outside are seen at other heights.
constexpr float min_ratio = 0.5f, max_ratio = 1.2f;
// Of the height: the rim is seen from one side. And where the image ends below the rim
// of the farther wall, of the inside only the lower half may be seen.
constexpr float max_rim_step = 0.3f, max_cut = 0.5f;

/** Points of the walls of a body. */
struct Walls {
  std::vector<Vector3f> points;
  std::vector<Vector3f> normals; ///< unit, square to up
  Vector3f middle = Vector3f::Zero();
  float low = 0.0f, high = 0.0f; ///< heights, but for the lowest and highest points
};

Walls
wallsOf(const BodySample& body, const Vector3f& up)
{
  Walls walls;
  walls.low = body.low;
  walls.high = body.high;
  for (std::size_t k = 0; k < body.points.size(); ++k) {
    if (!(std::abs(body.normals[k].dot(up)) < max_upright))
      continue;
    walls.points.push_back(body.points[k]);
    walls.normals.push_back(levelPart(body.normals[k], up).normalized());
    walls.middle += body.points[k];
  }
  walls.middle /= std::max(1.0f, static_cast<float>(walls.points.size()));
  return walls;
}

bool
isConcave(const Walls& walls, const Vector3f& up)
{
  if (walls.points.size() < min_points)
    return false;
  float sum = 0.0f;
  for (std::size_t k = 0; k < walls.points.size(); ++k) {
    const Vector3f to_middle = walls.middle - walls.points[k];
    const Vector3f level = levelPart(to_middle, up);
    sum += level.norm() > 0.0f ? walls.normals[k].dot(level.normalized()) : 0.0f;
  }
  return sum > min_concavity * static_cast<float>(walls.points.size());
}

/** Adds the lines along the normals: what a point nearest to all of them solves. */
void
addLines(const Walls& walls, const Vector3f& origin, Matrix3f& left, Vector3f& right)
{
  for (std::size_t k = 0; k < walls.points.size(); ++k) {
    const Matrix3f across =
        Matrix3f::Identity() - walls.normals[k] * walls.normals[k].transpose();
    left += across / static_cast<float>(walls.points.size());
    right +=
        across * (walls.points[k] - origin) / static_cast<float>(walls.points.size());
  }
}

struct AroundAxis {
  float radius = 0.0f;  ///< the median distance from the axis
  float miss = 0.0f;    ///< how far normals pass by the axis, the median
  float outward = 0.0f; ///< the share of the points that face away from it
};

AroundAxis
around(const Vector3f& axis_point, const Vector3f& up, const Walls& walls)
{
  AroundAxis result;
  std::vector<float> radii, misses;
  for (std::size_t k = 0; k < walls.points.size(); ++k) {
    const Vector3f from = levelPart(walls.points[k] - axis_point, up);
    const float along = from.dot(walls.normals[k]);
    radii.push_back(from.norm());
    misses.push_back((from - along * walls.normals[k]).norm());
    result.outward += along > 0.0f ? 1.0f : 0.0f;
  }
  result.outward /= static_cast<float>(walls.points.size());
  result.radius = median(std::move(radii));
  result.miss = median(std::move(misses));
  return result;
}

/** How badly an inside fits an outside; infinite if it is not its inside. */
float
misfit(const Walls& inside, const Walls& outside, const Vector3f& up)
{
  constexpr float no_fit = std::numeric_limits<float>::infinity();
  if (outside.points.size() < min_points)
    return no_fit;
  const float height = std::max(outside.high - outside.low, inside.high - inside.low);
  const float below = outside.high - inside.high;
  if (below < -max_rim_step * height || below > max_cut * height)
    return no_fit;
  const Vector3f origin = outside.middle;
  Matrix3f left = Matrix3f::Zero();
  Vector3f right = Vector3f::Zero();
  addLines(inside, origin, left, right);
  addLines(outside, origin, left, right);
  const Eigen::SelfAdjointEigenSolver<Matrix3f> solver(left);
  if (!(solver.eigenvalues()[0] > 2.0f * min_spread)) // of two bodies
    return no_fit;
  const Vector3f axis_point = origin + left.inverse() * right;
  const AroundAxis in = around(axis_point, up, inside);
  const AroundAxis out = around(axis_point, up, outside);
  const float ratio = in.radius / out.radius;
  const float miss = std::max(in.miss, out.miss) / std::max(in.radius, out.radius);
  const bool fits = out.outward >= min_share && in.outward <= 1.0f - min_share &&
                    ratio > min_ratio && ratio < max_ratio && miss < max_miss;
  return fits ? miss : no_fit;
}

std::vector<BodySample>
samplesOf(const InstanceInput& input, const Vector3f& up, const Labels& labels)
{
  const auto largest = std::max_element(labels.begin(), labels.end());
  const std::int32_t last = largest == labels.end() ? -1 : *largest;
  return bodySamples(input, up, labels, static_cast<std::size_t>(last + 1));
}

/** Places in an image towards a direction, which is a unit vector. */
std::vector<Vector3f>
seenTowards(const Vector3f& direction,
            const Vector3f& view_point,
            const std::vector<Vector3f>& points)
{
  std::vector<Vector3f> seen;
  for (const Vector3f& point : points)
    if (const float depth = direction.dot(point - view_point); depth > 0.0f)
      seen.emplace_back((point - view_point) / depth - direction);
  return seen;
}

/** Whether one sees a body around most of a floor; their places in an image towards a
 * direction, that of the floor's middle. */
bool
surrounds(const std::vector<Vector3f>& body,
          const std::vector<Vector3f>& floor,
          const Vector3f& direction)
{
  if (body.size() < min_points)
    return false;
  const Extent extent(direction, {body.front().data(), 3, body.size()});
  if (!extent.isInside(Vector3f::Zero())) // the middle: most bodies are elsewhere
    return false;
  const auto inside = std::count_if(floor.begin(), floor.end(), [&](const auto& place) {
    return extent.isInside(place);
  });
  return static_cast<float>(inside) >= min_share * static_cast<float>(floor.size());
}

float
medianLength(const std::vector<Vector3f>& vectors)
{
  std::vector<float> lengths;
  for (const Vector3f& vector : vectors)
    lengths.push_back(vector.norm());
  return median(std::move(lengths));
}

/** The innermost body that one sees around most of a floor; -1 if there is none. */
std::int32_t
bodyAround(const BodySample& floor,
           const std::vector<BodySample>& bodies,
           const Vector3f& view_point)
{
  const Vector3f direction = (floor.middle - view_point).normalized();
  const auto floor_places = seenTowards(direction, view_point, floor.points);
  std::int32_t innermost = -1;
  if (floor_places.empty())
    return innermost;
  float nearest = std::numeric_limits<float>::infinity();
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const auto places = seenTowards(direction, view_point, bodies[k].points);
    if (!surrounds(places, floor_places, direction))
      continue;
    if (const float distance = medianLength(places); distance < nearest) {
      nearest = distance;
      innermost = static_cast<std::int32_t>(k);
    }
  }
  return innermost;
}

} // namespace

void
joinInsides(const InstanceInput& input, const Vector3f& up, Labels& labels)
{
  std::vector<Walls> walls;
  for (const BodySample& body : samplesOf(input, up, labels))
    walls.push_back(wallsOf(body, up));
  std::vector<std::int32_t> joined(walls.size());
  for (std::size_t k = 0; k < walls.size(); ++k) {
    joined[k] = static_cast<std::int32_t>(k);
    if (!isConcave(walls[k], up))
      continue;
    float best = std::numeric_limits<float>::infinity();
    for (std::size_t other = 0; other < walls.size(); ++other) {
      const float fit = other == k || isConcave(walls[other], up)
                            ? std::numeric_limits<float>::infinity()
                            : misfit(walls[k], walls[other], up);
      if (fit < best) {
        best = fit;
        joined[k] = static_cast<std::int32_t>(other);
      }
    }
  }
  for (std::int32_t& label : labels)
    if (label >= 0)
      label = joined[static_cast<std::size_t>(label)];
}

void
joinFloors(const InstanceInput& input,
           const Vector3f& up,
           const Labels& patch_of,
           Labels& labels)
{
  const std::vector<BodySample> floors = samplesOf(input, up, patch_of);
  if (floors.empty())
    return;
  const std::vector<BodySample> bodies = samplesOf(input, up, labels);
  std::vector<std::int32_t> body_of;
  for (const BodySample& floor : floors)
    body_of.push_back(bodyAround(floor, bodies, input.view_point));
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] < 0 && patch_of[i] >= 0)
      labels[i] = body_of[static_cast<std::size_t>(patch_of[i])];
}

} // namespace pcl::segmentation
