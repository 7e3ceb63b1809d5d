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
#include "crease_corners.h"
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
constexpr unsigned empty_sectors = 6; // 135 degrees

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

} // namespace

std::vector<EdgeType>
edgeTypes(const AdaptiveInput& input, const AdaptiveEdges& edges, double threshold)
{
  const std::size_t size = input.points.size;
  const float most = *std::max_element(edges.spacings.begin(), edges.spacings.end());
  const PointGrid grid(input.points, most);
  const CreaseCorners corners(edges);
  std::vector<EdgeType> types(size, EdgeType::None);
  kernels::parallelForRanges(
      size, input.threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          if (!kernels::isFinite(input.points[i]) || std::isnan(edges.likelihood[i]))
            continue;
          if (edges.likelihood[i] > 1.0 - threshold)
            types[i] = corners.areAt(positionOf(input.points, i), edges.spacings[i])
                           ? EdgeType::Corner
                           : EdgeType::Crease;
          else if (isOnBoundary(input, edges, grid, i))
            types[i] = EdgeType::OpenBoundary;
        }
      });
  return types;
}

} // namespace pcl::detail
