// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Tables, floors, shelves: large planes with things before them and nothing behind.

#include "instances/support_planes.h"

#include "common/parallel.h"
#include "common/quiet.h"
#include "instances/smooth_pieces.h"
#include "instances/support_surroundings.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pcl::segmentation {
namespace {

using detail::InstanceInput;
using Eigen::Vector3f;
using Nodes = std::vector<SurfaceNode>;

// Of the largest part, by area or, as a near table is small before a far floor, by its
// points: supports are large.
constexpr double min_share = 0.25;
constexpr double min_on_top = 0.2; // of what is around
constexpr double max_behind = 0.2; // of what is around: noise, and the plane's own rim
// Of its own area: the rim of a table; the sides of a box are larger.
constexpr double max_sides = 0.25;
constexpr float same_level = 0.94f; // cosine of 20 degrees
constexpr float max_bend = 8.0f;    // of a plane at the corners of an image
constexpr double patch_share = 0.8; // of a face's points, as some are at its borders

struct Largest {
  double area = 0.0, points = 0.0;
};

bool
isWide(const SupportPart& part, const Largest& largest)
{
  return part.area >= min_share * largest.area;
}

/** In space, or in the sight of the camera. */
bool
isLarge(const SupportPart& part, const Largest& largest)
{
  return isWide(part, largest) || part.points >= min_share * largest.points;
}

bool
hasThingsOnTop(const Surroundings& around)
{
  return around.on_top >= min_on_top * (around.before + around.behind);
}

bool
hasNothingBehind(const Surroundings& around)
{
  return around.behind <= max_behind * (around.before + around.behind);
}

/** Things lie before it and nothing behind, or things stand on it and it has a rim. */
bool
carries(const SupportPart& part, const Largest& largest, const Surroundings& around)
{
  if (!(around.before + around.behind > 0.0))
    return part.area > around.others;
  const bool has_rim = around.sides <= max_sides * part.area;
  if (hasThingsOnTop(around))
    return hasNothingBehind(around) || has_rim;
  return hasNothingBehind(around) && isWide(part, largest);
}

/** Things lie before it and nothing behind. Around the lid of a box that is seen from
 * above there is nothing at all. */
bool
isFoot(const Surroundings& around)
{
  return around.before > 0.0 && hasNothingBehind(around);
}

/** Behind a support, and parallel to it: what stands on it is above it. */
bool
isBelow(const SupportPart& part, const std::vector<Support>& supports)
{
  return std::any_of(supports.begin(), supports.end(), [&](const Support& support) {
    const Plane<float>& plane = part.support.plane;
    const Vector3f above = support.plane.center - plane.center;
    return plane.normal.dot(support.plane.normal) > same_level &&
           support.plane.normal.dot(above) > 0.0f && plane.normal.dot(above) > 0.0f;
  });
}

/** The points near a support's nodes that are on its plane. */
std::vector<std::uint32_t>
pointsOn(const SupportPart& part,
         const InstanceInput& input,
         float unit,
         std::vector<char>& is_free)
{
  const PointGrid grid(positionsOf(part.nodes), around_spacings * unit);
  std::vector<char> is_on(is_free.size(), 0);
  kernels::parallelForEach(is_free.size(), input.threads, [&](std::size_t i) {
    if (!is_free[i])
      return;
    const Vector3f position = positionOf(input.points, i);
    const SurfaceNode node{position, normalOf(input, i), input.spacings[i]};
    is_on[i] = isOn(node, part.support) &&
               grid.anyWithin(position,
                              around_spacings * node.spacing,
                              [](std::uint32_t, const Vector3f&) { return true; });
  });
  std::vector<std::uint32_t> points;
  for (std::uint32_t i = 0; i < is_on.size(); ++i)
    if (is_on[i]) {
      points.push_back(i);
      is_free[i] = 0;
    }
  return points;
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
  std::vector<SupportPart> parts = supportParts(nodes, offsetLimit(input), unit);
  Largest largest;
  for (const SupportPart& part : parts) {
    largest.area = std::max(largest.area, part.area);
    largest.points = std::max(largest.points, part.points);
  }
  std::vector<char> is_free = members;
  std::vector<Support> supports;
  const auto addThose = [&](const auto& may_be) {
    for (SupportPart& part : parts) {
      if (part.nodes.empty() || !may_be(part))
        continue;
      supports.push_back({part.support.plane,
                          part.support.offset,
                          pointsOn(part, input, unit, is_free)});
      part.nodes.clear();
    }
  };
  addThose([&](const SupportPart& part) {
    return isLarge(part, largest) &&
           carries(part, largest, surroundingsOf(part, nodes, unit));
  });
  addThose([&](const SupportPart& part) {
    return isBelow(part, supports) && isFoot(surroundingsOf(part, nodes, unit));
  });
  return supports;
}

std::vector<char>
patchesOf(const std::vector<Support>& supports,
          const InstanceInput& input,
          const Labels& faces)
{
  const std::int32_t last =
      faces.empty() ? -1 : *std::max_element(faces.begin(), faces.end());
  const auto count = static_cast<std::size_t>(last + 1);
  std::vector<std::size_t> points(count, 0);
  std::vector<char> is_patch(count, 0);
  for (const std::int32_t face : faces)
    if (face >= 0)
      ++points[static_cast<std::size_t>(face)];
  for (const Support& support : supports) {
    std::vector<std::size_t> low(count, 0);
    for (std::size_t i = 0; i < faces.size(); ++i) {
      if (faces[i] < 0)
        continue;
      const float height =
          support.plane.normal.dot(positionOf(input.points, i) - support.plane.center) /
          input.spacings[i];
      if (height < std::max(max_ripple, support.offset) && height > -max_bend)
        ++low[static_cast<std::size_t>(faces[i])];
    }
    for (std::size_t f = 0; f < count; ++f)
      if (static_cast<double>(low[f]) >= patch_share * static_cast<double>(points[f]))
        is_patch[f] = 1;
  }
  return is_patch;
}

} // namespace pcl::segmentation
