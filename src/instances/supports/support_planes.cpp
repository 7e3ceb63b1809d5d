// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Tables, floors, shelves: large planes with things before them and nothing behind.

#include "instances/supports/support_planes.h"

#include "common/parallel.h"
#include "common/quiet.h"
#include "instances/pieces/smooth_pieces.h"
#include "instances/supports/support_choice.h"
#include "instances/supports/support_surroundings.h"

#include <cstdint>
#include <limits>

namespace pcl::segmentation {
namespace {

using detail::InstanceInput;
using Eigen::Vector3f;
using Nodes = std::vector<SurfaceNode>;

constexpr float same_normal = 0.94f; // cosine of 20 degrees
// From the support, half of a stereo camera's window: not the floor of a bowl.
constexpr float smear_spacings = 3.0f;

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
  Support support{part.support.plane, part.support.offset, {}, {}};
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
  for (const std::size_t k : carriersAmong(parts, nodes, unit, input.threads))
    supports.push_back(supportOf(parts[k], input, unit, is_free));
  return supports;
}

} // namespace pcl::segmentation
