// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Where faces meet, and whether they are one body there.

#include "instances/faces/face_contacts.h"

#include "common/parallel.h"
#include "common/statistics.h"
#include "geometry/vectors.h"
#include "instances/label_cells.h"
#include "instances/label_runs.h"
#include "instances/primitives/primitives.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace pcl::segmentation {
namespace {

using detail::InstanceInput;
using Eigen::Vector3f;

// In spacings.
constexpr float contact_reach = 1.0f; // between points of two faces that meet
// Beyond the edge's band, where the points of both faces are clean.
constexpr float fit_spacings = 3.0f, fit_per_noise = 10.0f;
constexpr float coarse_cells = 8.0f; // most hold one face, and boxes of a reach fit in
constexpr int min_side_points = 5;   // fewer have no direction
constexpr float flat_cosine = 0.94f; // of 20 degrees: less may be noise
constexpr float flat_sine = 0.34f;   // likewise

/** A place where two faces meet: one a pair of faces in each cell of space. */
struct Meeting {
  std::int32_t first, second; ///< labels of the faces
  std::array<float, 3> cell;
  std::array<float, 3> position;
  float spacing;
};

/** What the border of two faces is like at a place. */
struct Bend {
  float convexity = 0.0f; ///< 1 convex or no border at all, -1 concave or a step
  float gap = 0.0f;  ///< between the two surfaces there, 1: as much as noise may make
  float rise = 0.0f; ///< cosine to up of the normal that is nearer to it
};

/** A face near a place. */
struct Side {
  Vector3f center = Vector3f::Zero();
  Vector3f normal = Vector3f::Zero();
  int points = 0;
};

/** Adds what one point meets. */
void
collect(const InstanceInput& input,
        const PointGrid& grid,
        const Labels& grown,
        const LabelRuns& runs,
        const LabelCells& cells,
        float cell_size,
        std::size_t i,
        std::vector<Meeting>& meetings)
{
  const Vector3f p = positionOf(input.points, i);
  const float reach = contact_reach * input.spacings[i];
  if (!cells.mayHaveOther(p, reach, grown[i]))
    return;
  const Eigen::Array3f cell = (p.array() / cell_size).floor();
  std::array<std::int32_t, 8> seen{};
  std::size_t count = 0;
  const auto meet = [&](std::int32_t other) {
    const auto end = seen.begin() + static_cast<std::ptrdiff_t>(count);
    if (other < 0 || other == grown[i] || count == seen.size() ||
        std::find(seen.begin(), end, other) != end)
      return;
    seen[count++] = other;
    meetings.push_back({std::min(grown[i], other),
                        std::max(grown[i], other),
                        {cell.x(), cell.y(), cell.z()},
                        {p.x(), p.y(), p.z()},
                        input.spacings[i]});
  };
  grid.forEachRangeWithin(p, reach, [&](std::uint32_t begin, std::uint32_t end) {
    if (!runs.hasOther(begin, end, grown[i]))
      return;
    for (std::uint32_t at = begin; at < end; ++at) {
      const std::uint32_t j = grid.order()[at];
      if ((positionOf(input.points, j) - p).squaredNorm() < reach * reach)
        meet(grown[j]);
    }
  });
}

/** Sorted by the faces' labels. */
std::vector<Meeting>
meetingsOf(const InstanceInput& input, const PointGrid& grid, const Labels& grown)
{
  const float cell_size = medianSpacing(input);
  const LabelRuns runs(grid, grown);
  const LabelCells cells(input.points, grown, coarse_cells * cell_size);
  const auto add = [&](std::uint32_t i, std::vector<Meeting>& found) {
    if (grown[i] >= 0)
      collect(input, grid, grown, runs, cells, cell_size, i, found);
  };
  std::vector<Meeting> all = kernels::collectForEach<Meeting>(
      static_cast<std::uint32_t>(grown.size()), input.threads, add);
  std::sort(all.begin(), all.end(), [](const Meeting& a, const Meeting& b) {
    return std::tie(a.first, a.second, a.cell, a.position) <
           std::tie(b.first, b.second, b.cell, b.position);
  });
  const auto is_same = [](const Meeting& a, const Meeting& b) {
    return std::tie(a.first, a.second, a.cell) == std::tie(b.first, b.second, b.cell);
  };
  all.erase(std::unique(all.begin(), all.end(), is_same), all.end());
  return all;
}

/** The place on a face's surface, continued, that is nearest to a meeting, relative to
 * the meeting; the side's normal becomes the one there. */
Vector3f
continueTo(const Face& face, const Vector3f& position, Side& side)
{
  const Vector3f local = position - face.origin;
  const Vector3f normal = normalOf(face.surface, local);
  side.normal = normal.dot(side.normal) < 0.0f ? Vector3f(-normal) : normal;
  return footOn(face.surface, local) + (face.origin - position);
}

/** 1 where the sides turn away from each other, -1 where they turn to each other. */
float
opening(const Side& a, const Side& b)
{
  const Vector3f between = a.center - b.center;
  const float opening = (a.normal - b.normal).dot(between) / between.norm();
  return std::clamp(opening / flat_sine, -1.0f, 1.0f);
}

/** What is known from the points alone. */
float
convexity(const Side& a, const Side& b, float step_limit)
{
  if (!(a.normal.dot(b.normal) > flat_cosine))
    return opening(a, b);
  const float step = 0.5f * std::abs((a.normal + b.normal).dot(a.center - b.center));
  return step < step_limit ? 1.0f : -1.0f;
}

Bend
bendAt(const Meeting& meeting,
       const InstanceInput& input,
       const PointGrid& grid,
       const Labels& faces,
       const std::vector<Face>& properties,
       const Vector3f& up)
{
  const Vector3f position = toVector(meeting.position);
  const float radius =
      (fit_spacings + fit_per_noise * static_cast<float>(input.noise)) *
      meeting.spacing;
  Side a, b;
  grid.forEachWithin(position, radius, [&](std::uint32_t j, float) {
    if (faces[j] != meeting.first && faces[j] != meeting.second)
      return;
    Side& side = faces[j] == meeting.first ? a : b;
    side.center += positionOf(input.points, j) - position;
    side.normal += normalOf(input, j);
    ++side.points;
  });
  if (std::min(a.points, b.points) < min_side_points)
    return {}; // nothing is known there: neither a convexity nor a level face
  for (Side* side : {&a, &b}) {
    side->center /= static_cast<float>(side->points);
    side->normal.normalize();
  }
  const float rise = std::max(a.normal.dot(up), b.normal.dot(up));
  const Face& first = properties[static_cast<std::size_t>(meeting.first)];
  const Face& second = properties[static_cast<std::size_t>(meeting.second)];
  if (first.surface.type == PrimitiveType::None ||
      second.surface.type == PrimitiveType::None)
    return {convexity(a, b, stepLimit(input) * meeting.spacing), 0.0f, rise};
  const Vector3f foot_a = continueTo(first, position, a);
  const Vector3f foot_b = continueTo(second, position, b);
  const float sine = a.normal.cross(b.normal).norm();
  const float gap = (foot_a - foot_b).norm() / meeting.spacing;
  const bool is_flat = a.normal.dot(b.normal) > flat_cosine;
  return {is_flat ? 1.0f : opening(a, b),
          gap / (stepLimit(input) + contact_reach * sine),
          rise};
}

bool
arePlanes(const FaceContact& contact, const std::vector<Face>& properties)
{
  const auto isPlane = [&](std::int32_t face) {
    return properties[static_cast<std::size_t>(face)].surface.type ==
           PrimitiveType::Plane;
  };
  return isPlane(contact.first) && isPlane(contact.second);
}

} // namespace

std::vector<FaceContact>
faceContacts(const InstanceInput& input,
             const PointGrid& grid,
             const Labels& faces,
             const std::vector<Face>& properties,
             const Labels& grown,
             const Vector3f& up)
{
  const std::vector<Meeting> meetings = meetingsOf(input, grid, grown);
  std::vector<Bend> bends(meetings.size());
  kernels::parallelForEach(meetings.size(), input.threads, [&](std::size_t k) {
    bends[k] = bendAt(meetings[k], input, grid, faces, properties, up);
  });
  std::vector<FaceContact> result;
  for (std::size_t begin = 0, end = 0; begin < meetings.size(); begin = end) {
    FaceContact contact{meetings[begin].first, meetings[begin].second};
    const bool may_slope = !up.isZero() && !arePlanes(contact, properties);
    std::vector<float> gaps;
    for (; end < meetings.size() && meetings[end].first == contact.first &&
           meetings[end].second == contact.second;
         ++end) {
      contact.convex += std::max(0.0f, bends[end].convexity);
      contact.concave += std::max(0.0f, -bends[end].convexity);
      const bool slopes = may_slope && bends[end].rise < flat_cosine;
      contact.sloping += slopes && !(bends[end].convexity > 0.0f) ? 1.0f : 0.0f;
      gaps.push_back(bends[end].gap);
    }
    if (median(std::move(gaps)) > 1.5f) { // one stands on or before the other
      contact.concave += contact.convex;
      contact.convex = contact.sloping = 0.0f;
    }
    result.push_back(contact);
  }
  return result;
}

} // namespace pcl::segmentation
