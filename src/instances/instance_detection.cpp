// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "common/finite.h"
#include "instances/face_grouping.h"
#include "instances/label_growth.h"

#include "instances/instance_detection.h"

#include <algorithm>
#include <cmath>

namespace pcl::detail {
namespace {

using namespace segmentation;

constexpr float grid_spacings = 1.5f;
constexpr std::size_t least_face_points = 12; // a neighborhood of one spacing
constexpr double high_share = 0.25;           // see doc/instances.md

bool
isKnown(const InstanceInput& input, std::size_t i)
{
  return kernels::isFinite(input.points[i]) && !std::isnan(input.normals[3 * i]) &&
         !std::isnan(input.likelihood[i]);
}

std::vector<char>
membersOf(const InstanceInput& input, double low, bool with_edges)
{
  std::vector<char> members(input.points.size, 0);
  for (std::size_t i = 0; i < members.size(); ++i)
    members[i] = isKnown(input, i) && input.likelihood[i] >= static_cast<float>(low) &&
                 (with_edges || !(input.edge[i] > edge_threshold));
  return members;
}

/** Labels with too few points of a high likelihood are dropped. */
void
dropUnlikely(const InstanceInput& input, double high, Labels& labels)
{
  struct Count {
    std::size_t points = 0, high = 0;
  };
  std::vector<Count> counts;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] < 0)
      continue;
    const auto label = static_cast<std::size_t>(labels[i]);
    counts.resize(std::max(counts.size(), label + 1));
    ++counts[label].points;
    counts[label].high += input.likelihood[i] >= static_cast<float>(high) ? 1 : 0;
  }
  for (std::int32_t& label : labels) {
    if (label < 0)
      continue;
    const Count& count = counts[static_cast<std::size_t>(label)];
    if (static_cast<double>(count.high) <
        high_share * static_cast<double>(count.points))
      label = -1;
  }
}

} // namespace

InstanceLabels
findComponents(const InstanceInput& input, const InstanceLimits& limits)
{
  const PointGrid grid(input.points, grid_spacings * medianSpacing(input));
  Labels labels = smoothPieces(input, grid, membersOf(input, limits.low, false));
  dropUnlikely(input, limits.high, labels);
  growLabels(input, grid, {membersOf(input, limits.low, true), true}, labels);
  sortLabels(input, limits.min_points, labels);
  return labels;
}

InstanceLabels
findObjects(const InstanceInput& input, const InstanceLimits& limits)
{
  const PointGrid grid(input.points, grid_spacings * medianSpacing(input));
  Labels faces = smoothPieces(input, grid, membersOf(input, 0.0, false));
  sortLabels(input, least_face_points, faces);
  if (std::none_of(faces.begin(), faces.end(), [](auto face) { return face >= 0; }))
    return faces;
  Labels grown = faces;
  const std::vector<char> open(grown.size(), 1);
  growLabels(input, grid, {open, true}, grown);
  growLabels(input, grid, {open, false}, grown);

  const std::vector<Face> properties = facesOf(input, faces);
  const std::vector<FaceContact> contacts =
      faceContacts(input, grid, faces, properties, grown);
  const std::vector<char> supports = supportsAmong(input, faces, properties, contacts);
  const Labels groups = groupFaces(properties, supports, contacts);
  for (std::int32_t& label : grown)
    if (label >= 0)
      label = groups[static_cast<std::size_t>(label)];
  sortLabels(input, limits.min_points, grown);
  return grown;
}

} // namespace pcl::detail
