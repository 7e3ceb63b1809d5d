/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "../kernels/finite.h"
#include "../kernels/parallel.h"
#include "point_grid.h"

#include <pcl/segmentation/adaptive_detection.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <bitset>
#include <cmath>

namespace pcl::detail {
namespace {

using namespace segmentation;
using Eigen::Vector3f;

// doc/method.md has the reason of each number.
constexpr float boundary_spacings = 2.5f;
constexpr unsigned sectors = 16;
constexpr unsigned empty_sectors = 6;      // 135 degrees
constexpr float corner_spacings = 1.5f;    // more than the half-width of exact creases
constexpr float other_direction = 0.7071f; // cosine of 45 degrees
constexpr std::size_t least_points = 3;    // of each of a corner's creases

/** Which of the sectors around the origin a direction is in. */
unsigned
sectorOf(float x, float y)
{
  constexpr float pi = 3.14159265f;
  const float turn = (std::atan2(y, x) + pi) / (2.0f * pi);
  return std::min(sectors - 1, static_cast<unsigned>(turn * sectors));
}

/** True if so many sectors in a row are empty. */
bool
hasGap(const std::bitset<sectors>& taken)
{
  unsigned run = 0;
  for (unsigned s = 0; s < 2 * sectors; ++s) {
    run = taken[s % sectors] ? 0 : run + 1;
    if (run >= empty_sectors)
      return true;
  }
  return false;
}

/** True where the neighbors leave a wide sector of the tangent plane empty. */
bool
isOnBoundary(const AdaptiveInput& input,
             const AdaptiveEdges& edges,
             const PointGrid& grid,
             std::size_t i)
{
  const Vector3f normal = Eigen::Map<const Vector3f>(&edges.normals[3 * i]);
  const Vector3f x = normal.unitOrthogonal(), y = normal.cross(x);
  const Vector3f center = positionOf(input.points, i);
  std::bitset<sectors> taken;
  grid.forEachWithin(
      center, boundary_spacings * edges.spacings[i], [&](std::uint32_t j, float d2) {
        const Vector3f d = positionOf(input.points, j) - center;
        if (d2 > 0.0f)
          taken.set(sectorOf(d.dot(x), d.dot(y)));
      });
  return hasGap(taken);
}

/** True where points of creases of clearly different directions are near. */
bool
isAtCorner(const std::vector<CreasePoint>& creases,
           const PointGrid& grid,
           const Vector3f& center,
           float reach)
{
  std::vector<Vector3f> directions;
  grid.forEachWithin(center, reach, [&](std::uint32_t k, float) {
    directions.push_back(Eigen::Map<const Vector3f>(creases[k].direction.data()));
  });
  for (const Vector3f& one : directions) {
    std::size_t along = 0, across = 0;
    for (const Vector3f& other : directions)
      ++(std::abs(one.dot(other)) > other_direction ? along : across);
    if (std::min(along, across) >= least_points)
      return true;
  }
  return false;
}

} // namespace

std::vector<EdgeType>
edgeTypes(const AdaptiveInput& input, const AdaptiveEdges& edges, double threshold)
{
  const std::size_t size = input.points.size;
  const float most = *std::max_element(edges.spacings.begin(), edges.spacings.end());
  const XYZView crease_points{edges.creases.empty() ? nullptr
                                                    : edges.creases[0].position.data(),
                              sizeof(CreasePoint) / sizeof(float),
                              edges.creases.size()};
  const PointGrid grid(input.points, most);
  const PointGrid creases(crease_points, most);
  std::vector<EdgeType> types(size, EdgeType::None);
  kernels::parallelForRanges(
      size, input.threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          if (!kernels::isFinite(input.points[i]) || std::isnan(edges.likelihood[i]))
            continue;
          const float reach = corner_spacings * edges.spacings[i];
          if (edges.likelihood[i] > 1.0 - threshold)
            types[i] =
                isAtCorner(edges.creases, creases, positionOf(input.points, i), reach)
                    ? EdgeType::Corner
                    : EdgeType::Crease;
          else if (isOnBoundary(input, edges, grid, i))
            types[i] = EdgeType::OpenBoundary;
        }
      });
  return types;
}

} // namespace pcl::detail
