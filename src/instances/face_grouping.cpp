// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Faces grouped to bodies, and the supports that bodies stand on.

#include "instances/face_grouping.h"

#include "geometry/principal_axes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace pcl::segmentation {
namespace {

constexpr double min_area_share = 0.25; // of the largest face's: supports are large
constexpr double min_rim = 0.1; // of its width: a side of a body has convex borders
constexpr double in_plane_share = 0.8; // of a face's points, as some are at its borders
// Of the width of a group: faces of one body share a side, bodies that touch may not.
constexpr float min_side = 1.0f;
// Groups too small, in spacings, for a body of their own need less.
constexpr float narrow = 8.0f, min_narrow_side = 0.5f;

/** Others stand on a face, or lie before it: it is no side of a body. */
bool
carries(std::size_t face,
        const std::vector<Face>& faces,
        const std::vector<FaceContact>& contacts)
{
  float convex = 0.0f, concave = 0.0f;
  for (const FaceContact& contact : contacts) {
    const auto first = static_cast<std::size_t>(contact.first);
    const auto second = static_cast<std::size_t>(contact.second);
    if (first != face && second != face)
      continue;
    convex += contact.convex;
    concave += contact.concave;
  }
  if (concave > 2.0f * convex)
    return true;
  double others = 0.0;
  for (std::size_t f = 0; f < faces.size(); ++f)
    others += f == face ? 0.0 : faces[f].area;
  const double area = faces[face].area;
  return others > 0.0 && area > others && convex < min_rim * std::sqrt(area);
}

Plane<double>
planeOf(const detail::InstanceInput& input, const Labels& labels, std::int32_t label)
{
  return fitPlane<double>([&](const auto& visit) {
    for (std::size_t i = 0; i < labels.size(); ++i)
      if (labels[i] == label)
        visit(positionOf(input.points, i).cast<double>());
  });
}

/** How many points of each face are in a plane, but for the noise. */
std::vector<std::size_t>
pointsIn(const Plane<double>& plane,
         const detail::InstanceInput& input,
         const Labels& labels,
         std::size_t faces)
{
  const double limit = offsetLimit(input);
  std::vector<std::size_t> counts(faces, 0);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] < 0)
      continue;
    const double offset = plane.distance(positionOf(input.points, i).cast<double>());
    if (offset < limit * input.spacings[i])
      ++counts[static_cast<std::size_t>(labels[i])];
  }
  return counts;
}

} // namespace

std::vector<char>
supportsAmong(const detail::InstanceInput& input,
              const Labels& labels,
              const std::vector<Face>& faces,
              const std::vector<FaceContact>& contacts)
{
  double largest = 0.0;
  for (const Face& face : faces)
    if (face.planar > planar_threshold)
      largest = std::max(largest, face.area);
  std::vector<char> is_support(faces.size(), 0);
  for (std::size_t s = 0; s < faces.size(); ++s) {
    const bool is_large = faces[s].area >= min_area_share * largest;
    if (is_support[s] || faces[s].planar <= planar_threshold || !is_large ||
        !carries(s, faces, contacts))
      continue;
    const Plane<double> plane = planeOf(input, labels, static_cast<std::int32_t>(s));
    const std::vector<std::size_t> in_plane =
        pointsIn(plane, input, labels, faces.size());
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const auto needed = in_plane_share * static_cast<double>(faces[f].points);
      if (f == s || static_cast<double>(in_plane[f]) >= needed)
        is_support[f] = 1;
    }
  }
  return is_support;
}

Labels
groupFaces(const std::vector<Face>& faces,
           const std::vector<char>& left_out,
           const std::vector<FaceContact>& contacts)
{
  Labels group;
  std::vector<float> widths; // of groups, in spacings
  for (std::size_t i = 0; i < faces.size(); ++i) {
    group.push_back(left_out[i] ? -1 : static_cast<std::int32_t>(i));
    widths.push_back(static_cast<float>(std::sqrt(faces[i].area)));
  }
  const auto widthOf = [&](std::int32_t g) -> float& {
    return widths[static_cast<std::size_t>(g)];
  };
  // Between groups, the smaller one first; positive ones want to be joined.
  std::map<std::pair<std::int32_t, std::int32_t>, float> weights;
  for (const FaceContact& contact : contacts)
    if (group[static_cast<std::size_t>(contact.first)] >= 0 &&
        group[static_cast<std::size_t>(contact.second)] >= 0)
      weights[{contact.first, contact.second}] += contact.convex - contact.concave;
  for (;;) {
    auto best = weights.end();
    for (auto edge = weights.begin(); edge != weights.end(); ++edge) {
      const auto& [pair, weight] = *edge;
      const float width = std::min(widthOf(pair.first), widthOf(pair.second));
      const bool is_neck =
          weight < width * (width < narrow ? min_narrow_side : min_side);
      if (!is_neck && weight > (best == weights.end() ? 0.0f : best->second))
        best = edge;
    }
    if (best == weights.end())
      return group;
    const auto [kept, gone] = best->first;
    weights.erase(best);
    for (auto edge = weights.begin(); edge != weights.end();) {
      const auto [pair, weight] = *edge;
      if (pair.first != gone && pair.second != gone) {
        ++edge;
        continue;
      }
      edge = weights.erase(edge);
      const std::int32_t other = pair.first == gone ? pair.second : pair.first;
      weights[{std::min(kept, other), std::max(kept, other)}] += weight;
    }
    widthOf(kept) = std::hypot(widthOf(kept), widthOf(gone));
    std::replace(group.begin(), group.end(), gone, kept);
  }
}

} // namespace pcl::segmentation
