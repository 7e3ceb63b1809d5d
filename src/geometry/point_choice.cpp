// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Points chosen by where they are, whatever their order in the cloud.

#include "geometry/point_choice.h"

#include "geometry/point_grid.h"

#include <algorithm>
#include <tuple>

namespace pcl::segmentation {

void
sortByPosition(const XYZView& points, std::vector<std::uint32_t>& indices)
{
  // Their x beside the indices: few comparisons need the points.
  struct Entry {
    float x;
    std::uint32_t index;
  };
  std::vector<Entry> entries;
  entries.reserve(indices.size());
  for (const std::uint32_t i : indices)
    entries.push_back({points[i][0], i});
  std::sort(entries.begin(), entries.end(), [&](const Entry& a, const Entry& b) {
    if (a.x != b.x)
      return a.x < b.x;
    const float* p = points[a.index];
    const float* q = points[b.index];
    return std::tie(p[1], p[2], a.index) < std::tie(q[1], q[2], b.index);
  });
  for (std::size_t k = 0; k < indices.size(); ++k)
    indices[k] = entries[k].index;
}

std::array<float, 3>
cellAt(const float* place, float cell)
{
  const Eigen::Array3f c = (Eigen::Map<const Eigen::Array3f>(place) / cell).floor();
  return {c.x(), c.y(), c.z()};
}

std::vector<std::uint32_t>
centralPoints(const XYZView& points,
              const std::vector<std::uint32_t>& candidates,
              float cell)
{
  struct Entry {
    std::array<float, 3> cell;
    float off_center;
    std::size_t rank; ///< among the candidates
  };
  std::vector<Entry> entries;
  entries.reserve(candidates.size());
  for (const std::uint32_t i : candidates) {
    const Eigen::Array3f p = positionOf(points, i).array() / cell;
    const float off_center = (p - p.floor() - 0.5f).matrix().squaredNorm();
    entries.push_back({cellAt(points[i], cell), off_center, entries.size()});
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.cell, a.off_center, a.rank) <
           std::tie(b.cell, b.off_center, b.rank);
  });
  std::vector<std::uint32_t> chosen;
  for (std::size_t k = 0; k < entries.size(); ++k)
    if (k == 0 || entries[k].cell != entries[k - 1].cell)
      chosen.push_back(candidates[entries[k].rank]);
  return chosen;
}

} // namespace pcl::segmentation
