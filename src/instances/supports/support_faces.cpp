// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Which faces are supports, or patches of them.

#include "instances/supports/support_faces.h"

#include "geometry/principal_axes.h"
#include "instances/supports/support_parts.h"

#include <algorithm>
#include <cmath>

namespace pcl::segmentation {
namespace {

using detail::InstanceInput;

constexpr float max_bend = 8.0f;        // of a plane at the corners of an image
constexpr double min_area_share = 0.25; // of the largest face's: supports are large
constexpr double min_rim = 0.1;   // of its width: a side of a body has convex borders
constexpr float max_touch = 0.1f; // of a border: some places where faces meet are false
constexpr double min_in_plane = 0.8; // of a face's points, as some are at its borders

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

Plane<double>
planeOf(const InstanceInput& input, const Labels& face_of, std::int32_t label)
{
  return fitPlane<double>([&](const auto& visit) {
    for (std::size_t i = 0; i < face_of.size(); ++i)
      if (face_of[i] == label)
        visit(positionOf(input.points, i).cast<double>());
  });
}

/** How many points of each face are in a plane, but for the noise. */
std::vector<std::size_t>
pointsIn(const Plane<double>& plane,
         const InstanceInput& input,
         const Labels& face_of,
         std::size_t faces)
{
  const double limit = offsetLimit(input);
  std::vector<std::size_t> counts(faces, 0);
  for (std::size_t i = 0; i < face_of.size(); ++i) {
    if (face_of[i] < 0)
      continue;
    const double offset = plane.distance(positionOf(input.points, i).cast<double>());
    if (offset < limit * input.spacings[i])
      ++counts[static_cast<std::size_t>(face_of[i])];
  }
  return counts;
}

} // namespace

std::vector<char>
patchesOf(const std::vector<Support>& supports,
          const InstanceInput& input,
          const Labels& face_of,
          const std::vector<Face>& faces)
{
  std::vector<char> is_patch(faces.size(), 0);
  for (const Support& support : supports) {
    std::vector<std::size_t> low(faces.size(), 0), on_rim = low;
    const auto countIn = [&](std::vector<std::size_t>& counts, std::size_t i) {
      if (face_of[i] >= 0)
        ++counts[static_cast<std::size_t>(face_of[i])];
    };
    for (std::size_t i = 0; i < face_of.size(); ++i) {
      const float height =
          support.plane.normal.dot(positionOf(input.points, i) - support.plane.center) /
          input.spacings[i];
      if (height < std::max(max_ripple, support.offset) && height > -max_bend)
        countIn(low, i);
    }
    for (const std::uint32_t i : support.rim)
      countIn(on_rim, i);
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const bool is_thin = faces[f].thickness() < narrow;
      const std::size_t points = std::max(low[f], is_thin ? on_rim[f] : 0);
      if (static_cast<double>(points) >=
          min_in_plane * static_cast<double>(faces[f].points))
        is_patch[f] = 1;
    }
  }
  return is_patch;
}

Labels
lonePatches(const std::vector<char>& patches,
            const std::vector<Support>& supports,
            const Labels& face_of,
            const std::vector<FaceContact>& contacts,
            const Labels& grown_face_of)
{
  std::vector<char> is_plane(patches.size(), 0);
  for (const Support& support : supports)
    for (const std::uint32_t i : support.points)
      if (face_of[i] >= 0)
        is_plane[static_cast<std::size_t>(face_of[i])] = 1;
  std::vector<float> borders(patches.size(), 0.0f), to_planes = borders;
  for (const FaceContact& contact : contacts) {
    const auto first = static_cast<std::size_t>(contact.first);
    const auto second = static_cast<std::size_t>(contact.second);
    const float length = contact.convex + contact.concave;
    borders[first] += length;
    borders[second] += length;
    to_planes[first] += is_plane[second] ? length : 0.0f;
    to_planes[second] += is_plane[first] ? length : 0.0f;
  }
  Labels labels = grown_face_of;
  for (std::int32_t& label : labels) {
    const auto f = static_cast<std::size_t>(label);
    if (label >= 0 &&
        (!patches[f] || is_plane[f] || to_planes[f] > max_touch * borders[f]))
      label = -1;
  }
  return labels;
}

std::vector<char>
supportsAmong(const InstanceInput& input,
              const Labels& face_of,
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
    const Plane<double> plane = planeOf(input, face_of, static_cast<std::int32_t>(s));
    const std::vector<std::size_t> in_plane =
        pointsIn(plane, input, face_of, faces.size());
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const auto needed = min_in_plane * static_cast<double>(faces[f].points);
      if (f == s || static_cast<double>(in_plane[f]) >= needed)
        is_support[f] = 1;
    }
  }
  return is_support;
}

} // namespace pcl::segmentation
