// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Tables, floors, shelves: large planes with things before them and nothing behind.

#include "instances/supports/support_planes.h"

#include "common/parallel.h"
#include "common/quiet.h"
#include "common/statistics.h"
#include "instances/extent.h"
#include "instances/pieces/smooth_pieces.h"
#include "instances/supports/support_choice.h"
#include "instances/supports/support_surroundings.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace pcl::segmentation {
namespace {

using detail::InstanceInput;
using Eigen::Vector3f;
using Nodes = std::vector<SurfaceNode>;

constexpr float same_normal = 0.94f; // cosine of 20 degrees
// From the support, half of a stereo camera's window: not the floor of a bowl.
constexpr float smear_spacings = 3.0f;
// Walls of one height have a rim: a wall that the image cuts off ends anywhere.
constexpr std::ptrdiff_t min_walls = 2;
// Of the width of a bottom: the nearest wall hides what is before it.
constexpr float max_rim_distance = 0.25f;

/** Raised by what touches it, as by a stereo camera, which finds one depth for a
 * window: lower than what is told from a support, and nearly parallel to it. */
bool
isSmear(const SurfaceNode& node, const SupportPlane& support)
{
  const float height = heightOf(node, support.plane);
  return height > 0.0f && height < max_ripple &&
         node.normal.dot(support.plane.normal) > same_normal;
}

/** A support and the points near its nodes that are on its plane. */
Support
supportOf(const SupportPart& part,
          const InstanceInput& input,
          float unit,
          std::vector<char>& is_free)
{
  const PointGrid grid(positionsOf(part.nodes), around_spacings * unit);
  std::vector<char> is_on(is_free.size(), 0), is_smeared(is_free.size(), 0);
  const auto look = [&](std::size_t i, Vector3f& last) {
    const Vector3f position = positionOf(input.points, i);
    const SurfaceNode node{position, normalOf(input, i), input.spacings[i]};
    const bool may_be_on = isOn(node, part.support);
    if (!may_be_on && !isSmear(node, part.support))
      return;
    const float reach = (may_be_on ? around_spacings : smear_spacings) * node.spacing;
    const bool is_near =
        (last - position).squaredNorm() < reach * reach ||
        grid.anyWithin(position, reach, [&](std::uint32_t, const Vector3f& found) {
          last = found;
          return true;
        });
    is_on[i] = is_near && may_be_on;
    is_smeared[i] = is_near && !may_be_on;
  };
  kernels::parallelForRanges(
      is_free.size(), input.threads, [&](std::size_t begin, std::size_t end) {
        // Mostly near the next point, too.
        Vector3f last = Vector3f::Constant(std::numeric_limits<float>::quiet_NaN());
        for (std::size_t i = begin; i < end; ++i)
          if (is_free[i])
            look(i, last);
      });
  Support support{part.support.plane, part.support.offset, {}, {}, {}};
  for (std::uint32_t i = 0; i < is_on.size(); ++i) {
    if (is_on[i]) {
      support.points.push_back(i);
      is_free[i] = 0;
    }
    if (is_smeared[i])
      support.smeared.push_back(i);
  }
  return support;
}

/** How high a wall is above its bottom, in meters. Nodes are spread over its height, so
 * that a quantile tells, whatever strays are above. */
float
heightOfWall(const SupportPart& wall, const SupportPart& bottom)
{
  constexpr double share = 0.95;
  std::vector<float> heights;
  for (const SurfaceNode& node : wall.nodes)
    heights.push_back(heightOf(node, bottom.support.plane) * node.spacing);
  return quantile(std::move(heights), share) / static_cast<float>(share);
}

/** The points on top of the walls around a bottom: beside it, and as high as two of the
 * walls, but for the band of an edge. That of a wall whose inside nobody sees is among
 * them. A rim may be too narrow for normals. */
std::vector<std::uint32_t>
rimOf(const SupportPart& bottom,
      const std::vector<float>& walls,
      const InstanceInput& input,
      const std::vector<char>& is_free)
{
  const Nodes places = placesOf(bottom.nodes);
  const Extent extent(bottom.support.plane.normal, positionsOf(places));
  const float reach = max_rim_distance * static_cast<float>(std::sqrt(bottom.area));
  const PointGrid grid(positionsOf(places), reach);
  std::vector<std::uint32_t> rim;
  for (std::uint32_t i = 0; i < is_free.size(); ++i) {
    if (!is_free[i])
      continue;
    const SurfaceNode node{
        positionOf(input.points, i), normalOf(input, i), input.spacings[i]};
    const float height = heightOf(node, bottom.support.plane);
    const auto ends_here = std::count_if(walls.begin(), walls.end(), [&](float wall) {
      return std::abs(height - wall / node.spacing) < around_spacings;
    });
    const Vector3f foot =
        node.position - height * node.spacing * bottom.support.plane.normal;
    if (ends_here >= min_walls && isNear(foot, grid, reach) && !extent.isInside(foot))
      rim.push_back(i);
  }
  return rim;
}

} // namespace

std::vector<Support>
supportPlanes(const InstanceInput& input,
              const PointGrid& grid,
              const std::vector<char>& members)
{
  const Nodes nodes = surfaceNodes(input, grid, members);
  const float unit = medianSpacing(input);
  const detail::Quiet quiet;
  const std::vector<SupportPart> parts = supportParts(nodes, offsetLimit(input), unit);
  std::vector<char> is_free = members;
  std::vector<Support> supports;
  const std::vector<std::size_t> carriers =
      carriersAmong(parts, nodes, unit, input.threads);
  for (const std::size_t k : carriers)
    supports.push_back(supportOf(parts[k], input, unit, is_free));
  for (std::size_t s = 0; s < carriers.size(); ++s) {
    const SupportPart& bottom = parts[carriers[s]];
    const auto first = carriers.begin(), own = first + static_cast<std::ptrdiff_t>(s);
    if (std::any_of(first, own, [&](std::size_t k) { // walls come after their bottoms
          return isWallOf(bottom, parts[k], unit);
        }))
      continue;
    std::vector<float> walls;
    for (const std::size_t k : carriers)
      if (isWallOf(parts[k], bottom, unit))
        walls.push_back(heightOfWall(parts[k], bottom));
    if (static_cast<std::ptrdiff_t>(walls.size()) >= min_walls)
      supports[s].rim = rimOf(bottom, walls, input, is_free);
  }
  return supports;
}

} // namespace pcl::segmentation
