// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Instances of a class, and whole objects: the steps in their order.

#include "instances/instance_detection.h"

#include "common/finite.h"
#include "instances/faces/face_grouping.h"
#include "instances/label_growth.h"
#include "instances/objects/hidden_parts.h"
#include "instances/objects/hollow_bodies.h"
#include "instances/objects/open_boxes.h"
#include "instances/pieces/smooth_pieces.h"
#include "instances/supports/support_faces.h"

#include <algorithm>
#include <cmath>

namespace pcl::detail {
namespace {

using namespace segmentation;

constexpr float grid_spacings = 1.5f;       // near the radii of most queries
constexpr std::size_t min_face_points = 12; // a neighborhood of one spacing
// Hysteresis over a piece: a band of doubt around something else is no instance.
constexpr double high_share = 0.25;

bool
isKnown(const InstanceInput& input, std::size_t i)
{
  return kernels::isFinite(input.points[i]) && !std::isnan(input.normals[3 * i]) &&
         !std::isnan(input.likelihood[i]);
}

/** Labels with too few points of a high likelihood are dropped. */
void
dropUnlikely(const InstanceInput& input, double high, Labels& labels)
{
  std::vector<std::size_t> points, high_points; // of each label
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] < 0)
      continue;
    const auto label = static_cast<std::size_t>(labels[i]);
    points.resize(std::max(points.size(), label + 1));
    high_points.resize(points.size());
    ++points[label];
    high_points[label] += input.likelihood[i] >= static_cast<float>(high) ? 1 : 0;
  }
  for (std::int32_t& label : labels) {
    const auto k = static_cast<std::size_t>(label);
    if (label >= 0 && !isLikely(points[k], high_points[k]))
      label = -1;
  }
}

/** Each support is a face more. */
void
addFaces(const std::vector<Support>& supports, Labels& faces)
{
  std::int32_t next =
      faces.empty() ? 0 : *std::max_element(faces.begin(), faces.end()) + 1;
  for (const Support& support : supports) {
    for (const std::uint32_t i : support.points)
      faces[i] = next;
    ++next;
  }
}

} // namespace

std::vector<char>
membersOf(const InstanceInput& input, double low, bool with_edges)
{
  std::vector<char> members(input.points.size, 0);
  for (std::size_t i = 0; i < members.size(); ++i)
    members[i] = isKnown(input, i) && input.likelihood[i] >= static_cast<float>(low) &&
                 (with_edges || !(input.edge[i] > edge_threshold));
  return members;
}

bool
isLikely(std::size_t points, std::size_t high_points)
{
  return static_cast<double>(high_points) >= high_share * static_cast<double>(points);
}

float
gridCell(float median_spacing)
{
  return grid_spacings * median_spacing;
}

InstanceLabels
findComponents(const InstanceInput& input,
               const PointGrid& grid,
               const InstanceLimits& limits)
{
  Labels labels = smoothPieces(input, grid, membersOf(input, limits.low, false));
  dropUnlikely(input, limits.high, labels);
  growLabels(input, grid, {membersOf(input, limits.low, true), true}, labels);
  sortLabels(input, limits.min_points, labels);
  return labels;
}

InstanceLabels
findObjects(const InstanceInput& input,
            const PointGrid& grid,
            const InstanceLimits& limits)
{
  std::vector<char> members = membersOf(input, 0.0, false);
  const std::vector<Support> planes = supportPlanes(input, grid, members);
  for (const Support& plane : planes)
    for (const std::uint32_t i : plane.points)
      members[i] = 0;
  Labels faces = smoothPieces(input, grid, members);
  addFaces(planes, faces);
  sortLabels(input, min_face_points, faces);
  if (std::none_of(faces.begin(), faces.end(), [](auto face) { return face >= 0; }))
    return faces;
  Labels grown = faces;
  const std::vector<char> open(grown.size(), 1);
  growLabels(input, grid, {open, true}, grown);
  growLabels(input, grid, {open, false}, grown);

  const std::vector<Face> properties = facesOf(input, faces);
  const Eigen::Vector3f up =
      planes.empty() ? Eigen::Vector3f::Zero() : planes.front().plane.normal;
  const std::vector<FaceContact> contacts =
      faceContacts(input, grid, faces, properties, grown, up);
  const std::vector<char> patches = patchesOf(planes, input, faces, properties);
  const Labels lone_patches = lonePatches(patches, planes, faces, contacts, grown);
  const std::vector<char> supports =
      supportsAmong(input, faces, properties, patches, contacts);
  Labels groups = groupFaces(properties, supports, contacts);
  joinHiddenParts(input, faces, properties, groups);
  for (std::int32_t& label : grown)
    if (label >= 0)
      label = groups[static_cast<std::size_t>(label)];
  if (!planes.empty()) {
    joinOpenBoxes(input, up, faces, contacts, groups, grown);
    joinInsides(input, up, grown);
    joinFloors(input, up, lone_patches, grown);
  }
  for (const Support& plane : planes)
    for (const std::uint32_t i : plane.smeared)
      grown[i] = -1;
  sortLabels(input, limits.min_points, grown);
  return grown;
}

} // namespace pcl::detail
