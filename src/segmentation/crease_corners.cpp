/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "crease_corners.h"

#include "crease_positions.h"
#include "crease_votes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl::segmentation {
namespace {

using detail::AdaptiveEdges;
using Eigen::Vector3f;

// doc/method.md has the reason of each number.
constexpr float around_fits = 0.75f; // where fits see all faces of a corner
constexpr float ring_fits = 2.0f;    // and one to two, where they see two
constexpr float line_spacings = 1.5f;
constexpr float other_direction = 0.7071f; // cosine of 45 degrees
constexpr std::size_t least_points = 3;    // of each of a corner's creases

/** True if so many of them are more than 45 degrees from so many others. */
bool
differ(const std::vector<Vector3f>& directions)
{
  return std::any_of(directions.begin(), directions.end(), [&](const Vector3f& one) {
    std::size_t along = 0, across = 0;
    for (const Vector3f& other : directions)
      ++(std::abs(one.dot(other)) > other_direction ? along : across);
    return std::min(along, across) >= least_points;
  });
}

} // namespace

CreaseCorners::CreaseCorners(const AdaptiveEdges& edges)
: creases_(edges.creases)
, fit_(fitSpacings(edges.noise))
, grid_(positionsOf(creases_),
        fit_ * *std::max_element(edges.spacings.begin(), edges.spacings.end()))
{}

CreaseCorners::Directions
CreaseCorners::around(const Vector3f& center, float reach) const
{
  Directions directions;
  grid_.forEachWithin(center, reach, [&](std::uint32_t k, float) {
    directions.push_back(Eigen::Map<const Vector3f>(creases_[k].direction.data()));
  });
  return directions;
}

CreaseCorners::Directions
CreaseCorners::leadingTo(const Vector3f& center, float spacing) const
{
  const float inner = fit_ * spacing;
  const float off = line_spacings * spacing;
  Directions directions;
  grid_.forEachWithin(center, ring_fits * inner, [&](std::uint32_t k, float d2) {
    const Vector3f direction = Eigen::Map<const Vector3f>(creases_[k].direction.data());
    const Vector3f position = Eigen::Map<const Vector3f>(creases_[k].position.data());
    const bool leads = direction.cross(position - center).squaredNorm() < off * off;
    if (d2 > inner * inner && leads)
      directions.push_back(direction);
  });
  return directions;
}

bool
CreaseCorners::areAt(const Vector3f& center, float spacing) const
{
  return differ(around(center, around_fits * fit_ * spacing)) &&
         differ(leadingTo(center, spacing));
}

} // namespace pcl::segmentation
