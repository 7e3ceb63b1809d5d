/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "face_contacts.h"

#include "../kernels/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace pcl::segmentation {
namespace {

using detail::InstanceInput;
using Eigen::Vector3f;

// In spacings; doc/instances.md has the reason of each number.
constexpr float reach = 1.0f;
constexpr float fit_spacings = 3.0f, fit_per_noise = 10.0f;
constexpr int least_points = 5;
constexpr float flat_cosine = 0.94f; // of 20 degrees
constexpr float flat_sine = 0.34f;

/** A place where two faces meet. */
struct Meeting {
  std::int32_t first, second;
  std::array<float, 3> cell;
  std::array<float, 3> position;
  float spacing;
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
           const Labels& grown)
  : input_(input)
  , grid_(grid)
  , faces_(faces)
  , grown_(grown)
  , cell_(medianSpacing(input))
  , step_(stepLimit(input))
  {}

  /** One meeting a pair of faces in each cell of space. */
  std::vector<Meeting>
  meetings() const
  {
    constexpr std::size_t part = 8192;
    std::vector<std::vector<Meeting>> found((grown_.size() + part - 1) / part);
    kernels::parallelFor(found.size(), input_.threads, [&](std::size_t p) {
      const std::size_t end = std::min(grown_.size(), (p + 1) * part);
      for (std::size_t i = p * part; i < end; ++i)
        if (grown_[i] >= 0)
          collect(i, found[p]);
    });
    std::vector<Meeting> all;
    for (const auto& some : found)
      all.insert(all.end(), some.begin(), some.end());
    std::sort(all.begin(), all.end(), [](const Meeting& a, const Meeting& b) {
      return std::tie(a.first, a.second, a.cell, a.position) <
             std::tie(b.first, b.second, b.cell, b.position);
    });
    all.erase(std::unique(all.begin(),
                          all.end(),
                          [](const Meeting& a, const Meeting& b) {
                            return std::tie(a.first, a.second, a.cell) ==
                                   std::tie(b.first, b.second, b.cell);
                          }),
              all.end());
    return all;
  }

  /** Above 0 if the border is convex or no border at all, below if concave or a step,
   * 0 if that cannot be told. */
  float
  convexityAt(const Meeting& meeting) const
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
      return 0.0f;
    a.center /= static_cast<float>(a.points);
    b.center /= static_cast<float>(b.points);
    a.normal.normalize();
    b.normal.normalize();
    return convexity(a, b, meeting.spacing);
  }

private:
  void
  collect(std::size_t i, std::vector<Meeting>& meetings) const
  {
    const Vector3f position = positionOf(input_.points, i);
    const float* p = input_.points[i];
    const Eigen::Array3f cell = (position.array() / cell_).floor();
    std::array<std::int32_t, 8> seen{};
    std::size_t count = 0;
    grid_.forEachWithin(
        position, reach * input_.spacings[i], [&](std::uint32_t j, float) {
          const std::int32_t other = grown_[j];
          const auto end = seen.begin() + static_cast<std::ptrdiff_t>(count);
          if (other < 0 || other == grown_[i] || count == seen.size() ||
              std::find(seen.begin(), end, other) != end)
            return;
          seen[count++] = other;
          meetings.push_back({std::min(grown_[i], other),
                              std::max(grown_[i], other),
                              {cell.x(), cell.y(), cell.z()},
                              {p[0], p[1], p[2]},
                              input_.spacings[i]});
        });
  }

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
    const float distance = between.norm();
    const float cosine = a.normal.dot(b.normal);
    if (cosine > flat_cosine) {
      const float step = 0.5f * std::abs((a.normal + b.normal).dot(between));
      return step < step_ * spacing ? 1.0f : -1.0f;
    }
    const float opening = (a.normal - b.normal).dot(between) / distance;
    return std::clamp(opening / flat_sine, -1.0f, 1.0f);
  }

  const InstanceInput& input_;
  const PointGrid& grid_;
  const Labels& faces_;
  const Labels& grown_;
  float cell_;
  float step_;
};

} // namespace

std::vector<FaceContact>
faceContacts(const InstanceInput& input,
             const PointGrid& grid,
             const Labels& faces,
             const Labels& grown)
{
  const Contacts contacts(input, grid, faces, grown);
  const std::vector<Meeting> meetings = contacts.meetings();
  std::vector<float> convexity(meetings.size());
  kernels::parallelForRanges(
      meetings.size(), input.threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
          convexity[k] = contacts.convexityAt(meetings[k]);
      });
  std::vector<FaceContact> result;
  for (std::size_t k = 0; k < meetings.size(); ++k) {
    const Meeting& m = meetings[k];
    if (result.empty() || result.back().first != m.first ||
        result.back().second != m.second)
      result.push_back({m.first, m.second, 0.0f, 0.0f});
    result.back().convex += std::max(0.0f, convexity[k]);
    result.back().concave += std::max(0.0f, -convexity[k]);
  }
  return result;
}

} // namespace pcl::segmentation
