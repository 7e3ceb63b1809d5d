// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Tables, floors, shelves: large planes with things before them and nothing behind.

#include "instances/support_planes.h"

#include "common/parallel.h"
#include "common/quiet.h"
#include "geometry/principal_axes.h"
#include "instances/primitives.h"
#include "instances/smooth_pieces.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

namespace pcl::segmentation {
namespace {

using detail::InstanceInput;
using Eigen::Vector3f;
using Nodes = std::vector<SurfaceNode>;

constexpr int max_planes = 8;           // more are walls of something else
constexpr double min_area_share = 0.25; // of the largest one's: supports are large
constexpr std::size_t min_nodes = 50;   // some 10 x 10 spacings
constexpr std::size_t max_fitted = 2000;
// The ripple of a depth camera is 1 to 3 mm, a spacing or two, and turns normals by 22
// degrees in the median: normals say little of one point.
constexpr float max_offset = 2.0f, min_cosine = 0.7f;
constexpr float sigmas = 3.0f, sigma_of_median = 1.4826f; // of normal errors
constexpr int refits = 3;
// Around the border of a plane, beyond the band of an edge.
constexpr float around_spacings = 6.0f;
constexpr float max_bend = 8.0f;    // of a plane at the corners of an image
constexpr double patch_share = 0.8; // of a face's points, as some are at its borders
constexpr double max_behind = 0.2;  // of what is around: noise, and the plane's own rim

struct SupportPlane {
  Plane<float> plane;  ///< the normal is towards the viewpoint
  float offset = 0.0f; ///< how far its points are off, at most, in spacings
};

/** Signed, in spacings of the node. */
float
heightOf(const SurfaceNode& node, const Plane<float>& plane)
{
  return plane.normal.dot(node.position - plane.center) / node.spacing;
}

bool
isOn(const SurfaceNode& node, const SupportPlane& support)
{
  return std::abs(heightOf(node, support.plane)) < support.offset &&
         std::abs(node.normal.dot(support.plane.normal)) > min_cosine;
}

Nodes
nodesOn(const Nodes& nodes, const SupportPlane& support)
{
  Nodes on;
  std::copy_if(nodes.begin(), nodes.end(), std::back_inserter(on), [&](const auto& n) {
    return isOn(n, support);
  });
  return on;
}

double
areaOf(const Nodes& nodes)
{
  double area = 0.0;
  for (const SurfaceNode& node : nodes)
    area += static_cast<double>(node.spacing) * node.spacing;
  return area;
}

/** The plane that most nodes are on; the normal is that of most of them. */
std::optional<SupportPlane>
largestPlane(const Nodes& nodes, float unit)
{
  PrimitiveSample sample;
  const Vector3f origin = nodes.front().position;
  const std::size_t step = (nodes.size() + max_fitted - 1) / max_fitted;
  for (std::size_t k = 0; k < nodes.size(); k += step)
    sample.add((nodes[k].position - origin) / unit, nodes[k].normal);
  sample.tolerance = sample.first_tolerance = max_offset;
  const ShapePrimitive fitted = fitTo(sample, PrimitiveType::Plane);
  if (fitted.type == PrimitiveType::None)
    return std::nullopt;
  SupportPlane support;
  support.offset = max_offset;
  support.plane.normal = normalOf(fitted, Vector3f::Zero());
  support.plane.center = origin + unit * footOn(fitted, Vector3f::Zero());
  return support;
}

/** Fit the plane, and how far points are off, to the nodes on it. */
bool
refitTo(const Nodes& nodes, float min_offset, SupportPlane& support)
{
  for (int round = 0; round < refits; ++round) {
    const Nodes on = nodesOn(nodes, support);
    if (on.size() < min_nodes)
      return false;
    const Vector3f origin = on.front().position;
    support.plane = fitPlane<float>([&](const auto& visit) {
      for (const SurfaceNode& node : on)
        visit(Vector3f(node.position - origin));
    });
    support.plane.center += origin;
    Vector3f facing = Vector3f::Zero();
    std::vector<float> offsets;
    for (const SurfaceNode& node : on) {
      facing += node.normal;
      offsets.push_back(std::abs(heightOf(node, support.plane)));
    }
    if (facing.dot(support.plane.normal) < 0.0f)
      support.plane.normal = -support.plane.normal;
    support.offset = std::clamp(
        sigmas * sigma_of_median * median(std::move(offsets)), min_offset, max_offset);
  }
  return true;
}

/** Things stand on a plane, or lie before it, and nothing behind goes on from it. */
bool
carries(const SupportPlane& support, const Nodes& nodes, const Nodes& on, float unit)
{
  const PointGrid grid(positionsOf(on), around_spacings * unit);
  double before = 0.0, behind = 0.0, others = 0.0;
  for (const SurfaceNode& node : nodes) {
    if (isOn(node, support))
      continue;
    const double area = static_cast<double>(node.spacing) * node.spacing;
    others += area;
    const float height = heightOf(node, support.plane);
    if (std::abs(height) < max_offset ||
        !grid.anyWithin(node.position,
                        around_spacings * node.spacing,
                        [](std::uint32_t, const Vector3f&) { return true; }))
      continue;
    (height > 0.0f ? before : behind) += area;
  }
  return before + behind > 0.0 ? behind <= max_behind * (before + behind)
                               : areaOf(on) > others;
}

/** The points near a support's nodes that are on its plane. */
std::vector<std::uint32_t>
pointsOn(const SupportPlane& support,
         const Nodes& on,
         const InstanceInput& input,
         float unit,
         std::vector<char>& is_free)
{
  const PointGrid grid(positionsOf(on), around_spacings * unit);
  std::vector<char> is_on(is_free.size(), 0);
  kernels::parallelForEach(is_free.size(), input.threads, [&](std::size_t i) {
    if (!is_free[i])
      return;
    const Vector3f position = positionOf(input.points, i);
    const SurfaceNode node{position, normalOf(input, i), input.spacings[i]};
    is_on[i] = isOn(node, support) &&
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
  Nodes left = nodes;
  double largest = 0.0;
  std::vector<char> is_free = members;
  std::vector<Support> supports;
  for (int k = 0; k < max_planes && left.size() >= min_nodes; ++k) {
    std::optional<SupportPlane> support = largestPlane(left, unit);
    if (!support || !refitTo(left, offsetLimit(input), *support))
      break;
    const Nodes on = nodesOn(left, *support);
    largest = std::max(largest, areaOf(on));
    if (areaOf(on) < min_area_share * largest)
      break;
    if (carries(*support, nodes, on, unit))
      supports.push_back(
          {support->plane, pointsOn(*support, on, input, unit, is_free)});
    left.erase(std::remove_if(left.begin(),
                              left.end(),
                              [&](const auto& node) { return isOn(node, *support); }),
               left.end());
  }
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
      if (height < max_offset && height > -max_bend)
        ++low[static_cast<std::size_t>(faces[i])];
    }
    for (std::size_t f = 0; f < count; ++f)
      if (static_cast<double>(low[f]) >= patch_share * static_cast<double>(points[f]))
        is_patch[f] = 1;
  }
  return is_patch;
}

} // namespace pcl::segmentation
