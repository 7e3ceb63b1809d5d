/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "face_meetings.h"

#include "../kernels/parallel.h"

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

} // namespace pcl::segmentation
