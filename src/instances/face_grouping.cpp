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
// Groups too narrow, in spacings, for a body of their own need less: the arc of a
// handle is cut across, where it is as wide as it is thick.
constexpr float narrow = 8.0f, min_narrow_side = 0.5f;

/** Others stand on a face, or lie before it: it is no side of a body. What it meets of
 * a known support says nothing, as a body alone on a table only meets the table. */
bool
carries(std::size_t face,
        const std::vector<Face>& faces,
        const std::vector<char>& known,
        const std::vector<FaceContact>& contacts)
{
  float convex = 0.0f, concave = 0.0f;
  for (const FaceContact& contact : contacts) {
    const auto first = static_cast<std::size_t>(contact.first);
    const auto second = static_cast<std::size_t>(contact.second);
    if ((first != face && second != face) || known[first] || known[second])
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

/** How large a group of faces is, in spacings. */
struct GroupSize {
  float width;     ///< the root of its area
  float thickness; ///< of a strip; of other shapes the width

  static GroupSize
  of(const Face& face)
  {
    const double width = std::sqrt(face.area);
    const double thickness = face.length > width ? face.area / face.length : width;
    return {static_cast<float>(width), static_cast<float>(thickness)};
  }

  GroupSize
  with(const GroupSize& other) const
  {
    return {std::hypot(width, other.width), std::hypot(thickness, other.thickness)};
  }

  /** The least border with another group of the same body. */
  float
  minSide() const
  {
    return thickness < narrow ? min_narrow_side * thickness : min_side * width;
  }
};

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
              const std::vector<char>& known,
              const std::vector<FaceContact>& contacts)
{
  double largest = 0.0;
  for (const Face& face : faces)
    if (face.planar > planar_threshold)
      largest = std::max(largest, face.area);
  std::vector<char> is_support = known;
  for (std::size_t s = 0; s < faces.size(); ++s) {
    const bool is_large = faces[s].area >= min_area_share * largest;
    if (is_support[s] || faces[s].planar <= planar_threshold || !is_large ||
        !carries(s, faces, known, contacts))
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
  std::vector<GroupSize> sizes; // of groups
  for (std::size_t i = 0; i < faces.size(); ++i) {
    group.push_back(left_out[i] ? -1 : static_cast<std::int32_t>(i));
    sizes.push_back(GroupSize::of(faces[i]));
  }
  const auto sizeOf = [&](std::int32_t g) -> GroupSize& {
    return sizes[static_cast<std::size_t>(g)];
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
      const bool is_neck = weight < std::min(sizeOf(pair.first).minSide(),
                                             sizeOf(pair.second).minSide());
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
    sizeOf(kept) = sizeOf(kept).with(sizeOf(gone));
    std::replace(group.begin(), group.end(), gone, kept);
  }
}

} // namespace pcl::segmentation
