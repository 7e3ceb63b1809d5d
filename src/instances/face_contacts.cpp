// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "instances/face_contacts.h"

#include "common/parallel.h"
#include "common/statistics.h"
#include "geometry/primitives.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace pcl::segmentation {
namespace {

using detail::InstanceInput;
using Eigen::Vector3f;

/** What one point meets. */
void
collect(const InstanceInput& input,
        const PointGrid& grid,
        const Labels& grown,
        float cell_size,
        std::size_t i,
        std::vector<FaceMeeting>& meetings)
{
  const Vector3f position = positionOf(input.points, i);
  const float* p = input.points[i];
  const Eigen::Array3f cell = (position.array() / cell_size).floor();
  std::array<std::int32_t, 8> seen{};
  std::size_t count = 0;
  grid.forEachWithin(
      position, contact_reach * input.spacings[i], [&](std::uint32_t j, float) {
        const std::int32_t other = grown[j];
        const auto end = seen.begin() + static_cast<std::ptrdiff_t>(count);
        if (other < 0 || other == grown[i] || count == seen.size() ||
            std::find(seen.begin(), end, other) != end)
          return;
        seen[count++] = other;
        meetings.push_back({std::min(grown[i], other),
                            std::max(grown[i], other),
                            {cell.x(), cell.y(), cell.z()},
                            {p[0], p[1], p[2]},
                            input.spacings[i]});
      });
}

} // namespace

std::vector<FaceMeeting>
faceMeetings(const InstanceInput& input, const PointGrid& grid, const Labels& grown)
{
  const float cell_size = medianSpacing(input);
  constexpr std::size_t part = 8192;
  std::vector<std::vector<FaceMeeting>> found((grown.size() + part - 1) / part);
  kernels::parallelFor(found.size(), input.threads, [&](std::size_t p) {
    const std::size_t end = std::min(grown.size(), (p + 1) * part);
    for (std::size_t i = p * part; i < end; ++i)
      if (grown[i] >= 0)
        collect(input, grid, grown, cell_size, i, found[p]);
  });
  std::vector<FaceMeeting> all;
  for (const auto& some : found)
    all.insert(all.end(), some.begin(), some.end());
  std::sort(all.begin(), all.end(), [](const FaceMeeting& a, const FaceMeeting& b) {
    return std::tie(a.first, a.second, a.cell, a.position) <
           std::tie(b.first, b.second, b.cell, b.position);
  });
  all.erase(std::unique(all.begin(),
                        all.end(),
                        [](const FaceMeeting& a, const FaceMeeting& b) {
                          return std::tie(a.first, a.second, a.cell) ==
                                 std::tie(b.first, b.second, b.cell);
                        }),
            all.end());
  return all;
}

namespace {

using detail::InstanceInput;
using Eigen::Vector3f;

// In spacings; doc/instances.md has the reason of each number.
constexpr float fit_spacings = 3.0f, fit_per_noise = 10.0f;
constexpr int least_points = 5;
constexpr float flat_cosine = 0.94f; // of 20 degrees
constexpr float flat_sine = 0.34f;

/** What the border of two faces is like at a place. */
struct Bend {
  float convexity = 0.0f; ///< -1 to 1
  float gap = 0.0f; ///< between the two surfaces there, 1: as much as noise may make
};

/** A face near a place. */
struct Side {
  Vector3f center = Vector3f::Zero();
  Vector3f normal = Vector3f::Zero();
  int points = 0;
};

class Contacts {
public:
  Contacts(const InstanceInput& input,
           const PointGrid& grid,
           const Labels& faces,
           const std::vector<Face>& properties)
  : input_(input)
  , grid_(grid)
  , faces_(faces)
  , properties_(properties)
  , step_(stepLimit(input))
  {}

  /** Above 0 if the border is convex or no border at all, below if concave or a step,
   * 0 if that cannot be told. */
  Bend
  bendAt(const FaceMeeting& meeting) const
  {
    Side a, b;
    const Vector3f position = Eigen::Map<const Vector3f>(meeting.position.data());
    const float radius =
        (fit_spacings + fit_per_noise * static_cast<float>(input_.noise)) *
        meeting.spacing;
    grid_.forEachWithin(position, radius, [&](std::uint32_t j, float) {
      if (faces_[j] == meeting.first)
        add(j, position, a);
      else if (faces_[j] == meeting.second)
        add(j, position, b);
    });
    if (a.points < least_points || b.points < least_points)
      return {};
    a.center /= static_cast<float>(a.points);
    b.center /= static_cast<float>(b.points);
    a.normal.normalize();
    b.normal.normalize();
    const Face& first = properties_[static_cast<std::size_t>(meeting.first)];
    const Face& second = properties_[static_cast<std::size_t>(meeting.second)];
    if (first.surface.type == PrimitiveType::None ||
        second.surface.type == PrimitiveType::None)
      return {convexity(a, b, meeting.spacing)};
    const Vector3f foot_a = continueTo(first, position, a);
    const Vector3f foot_b = continueTo(second, position, b);
    const float sine = a.normal.cross(b.normal).norm();
    const float limit = step_ + contact_reach * sine;
    const float gap = (foot_a - foot_b).norm() / meeting.spacing;
    const bool is_flat = a.normal.dot(b.normal) > flat_cosine;
    return {is_flat ? 1.0f : opening(a, b), gap / limit};
  }

private:
  void
  add(std::size_t j, const Vector3f& origin, Side& side) const
  {
    side.center += positionOf(input_.points, j) - origin;
    side.normal += normalOf(input_, j);
    ++side.points;
  }

  float
  convexity(const Side& a, const Side& b, float spacing) const
  {
    const Vector3f between = a.center - b.center;
    const float cosine = a.normal.dot(b.normal);
    if (cosine > flat_cosine) {
      const float step = 0.5f * std::abs((a.normal + b.normal).dot(between));
      return step < step_ * spacing ? 1.0f : -1.0f;
    }
    return opening(a, b);
  }

  static float
  opening(const Side& a, const Side& b)
  {
    const Vector3f between = a.center - b.center;
    const float opening = (a.normal - b.normal).dot(between) / between.norm();
    return std::clamp(opening / flat_sine, -1.0f, 1.0f);
  }

  /** The place on a face's surface, continued, nearest to a meeting; the side's normal
   * becomes the one there. */
  static Vector3f
  continueTo(const Face& face, const Vector3f& position, Side& side)
  {
    const Vector3f local = position - face.origin;
    const Vector3f normal = normalOf(face.surface, local);
    side.normal = normal.dot(side.normal) < 0.0f ? Vector3f(-normal) : normal;
    return footOn(face.surface, local) + (face.origin - position);
  }

  const InstanceInput& input_;
  const PointGrid& grid_;
  const Labels& faces_;
  const std::vector<Face>& properties_;
  float step_;
};

} // namespace

std::vector<FaceContact>
faceContacts(const InstanceInput& input,
             const PointGrid& grid,
             const Labels& faces,
             const std::vector<Face>& properties,
             const Labels& grown)
{
  const Contacts contacts(input, grid, faces, properties);
  const std::vector<FaceMeeting> meetings = faceMeetings(input, grid, grown);
  std::vector<Bend> bends(meetings.size());
  kernels::parallelForRanges(
      meetings.size(), input.threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
          bends[k] = contacts.bendAt(meetings[k]);
      });
  std::vector<FaceContact> result;
  for (std::size_t begin = 0, end = 0; begin < meetings.size(); begin = end) {
    FaceContact contact{meetings[begin].first, meetings[begin].second};
    std::vector<float> gaps;
    for (; end < meetings.size() && meetings[end].first == contact.first &&
           meetings[end].second == contact.second;
         ++end) {
      contact.convex += std::max(0.0f, bends[end].convexity);
      contact.concave += std::max(0.0f, -bends[end].convexity);
      gaps.push_back(bends[end].gap);
    }
    if (median(std::move(gaps)) > 1.0f) {
      contact.concave += contact.convex;
      contact.convex = 0.0f;
    }
    result.push_back(contact);
  }
  return result;
}

} // namespace pcl::segmentation
