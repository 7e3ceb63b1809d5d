// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Points chosen by where they are, whatever their order in the cloud.

#include "geometry/point_choice.h"

#include "common/radix_sort.h"
#include "geometry/cell_loop.h"
#include "geometry/point_grid.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace pcl::segmentation {
namespace {

/** Bits that are in the order of finite floats; of both zeros the same. */
std::uint32_t
sortedBitsOf(float value)
{
  constexpr std::uint32_t sign = 0x80000000U;
  value += 0.0f;
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return (bits & sign) != 0 ? ~bits : bits | sign;
}

} // namespace

void
sortByPosition(const XYZView& points, std::vector<std::uint32_t>& indices)
{
  // By x as sorted bits; only those of one x need y and z.
  kernels::RawVector<kernels::Keyed<std::uint32_t>> entries;
  entries.reserve(indices.size());
  for (const std::uint32_t i : indices)
    entries.push_back({sortedBitsOf(points[i][0]), i});
  constexpr unsigned threads = 1;
  kernels::radixSort(entries, std::numeric_limits<std::uint32_t>::digits, threads);
  for (auto begin = entries.begin(), end = begin; begin != entries.end(); begin = end) {
    while (end != entries.end() && end->key == begin->key)
      ++end;
    std::sort(begin, end, [&](const auto& a, const auto& b) {
      return isBefore(points, a.index, b.index);
    });
  }
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
              float cell,
              unsigned threads)
{
  const auto inCells = [&](std::uint32_t i) -> Eigen::Array3f {
    return positionOf(points, i).array() / cell;
  };
  std::vector<CellPoint> sorted;
  sorted.reserve(candidates.size());
  for (const std::uint32_t i : candidates)
    sorted.push_back({cellOf(points[i], cell), i});
  sortByCell(sorted, threads);
  const auto offCenter = [&](std::uint32_t i) {
    const Eigen::Array3f p = inCells(i);
    return (p - p.floor() - 0.5f).matrix().squaredNorm();
  };
  const std::vector<std::size_t> begins = beginsOfCells(sorted, threads);
  std::vector<std::uint32_t> chosen(begins.size() - 1);
  forEachCell(
      sorted, begins, threads, [&](const auto begin, const auto end, std::size_t k) {
        std::uint32_t nearest = begin->point;
        float min_off_center = offCenter(nearest);
        for (auto at = begin + 1; at != end; ++at)
          if (const float off_center = offCenter(at->point);
              off_center < min_off_center) {
            min_off_center = off_center;
            nearest = at->point;
          }
        chosen[k] = nearest;
      });
  return chosen;
}

} // namespace pcl::segmentation
