/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "row_index.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace pcl {
namespace kernels {
namespace {

struct Entry {
  std::int32_t iz;
  std::int32_t iy;
  float x, y, z;
  std::uint32_t index;
};

bool
isFinite(const float* p)
{
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

std::vector<Entry>
finiteEntries(const XYZView& points,
              const std::int32_t* indices,
              std::size_t count,
              double edge)
{
  std::vector<Entry> entries;
  entries.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const float* p = points[indices ? static_cast<std::size_t>(indices[i]) : i];
    if (isFinite(p)) {
      entries.push_back({cellOf(p[2], edge),
                         cellOf(p[1], edge),
                         p[0],
                         p[1],
                         p[2],
                         static_cast<std::uint32_t>(i)});
    }
  }
  return entries;
}

void
appendRow(RowIndex& result, const Entry& entry)
{
  const bool is_new = result.rows.empty() || result.rows.back().iz != entry.iz ||
                      result.rows.back().iy != entry.iy;
  if (is_new) {
    const auto begin = static_cast<std::uint32_t>(result.order.size());
    result.rows.push_back({entry.iz, entry.iy, begin});
  }
}

} // namespace

std::int32_t
cellOf(double coordinate, double edge)
{
  constexpr double limit = 1 << 30;
  return static_cast<std::int32_t>(
      std::clamp(std::floor(coordinate / edge), -limit, limit));
}

RowIndex
buildRowIndex(const XYZView& points,
              const std::int32_t* indices,
              std::size_t count,
              double edge)
{
  auto entries = finiteEntries(points, indices, count, edge);
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.iz, a.iy, a.x, a.y, a.z, a.index) <
           std::tie(b.iz, b.iy, b.x, b.y, b.z, b.index);
  });

  RowIndex result;
  result.edge = edge;
  for (auto* array : {&result.x, &result.y, &result.z}) {
    array->reserve(entries.size());
  }
  result.order.reserve(entries.size());
  for (const Entry& entry : entries) {
    appendRow(result, entry);
    result.x.push_back(entry.x);
    result.y.push_back(entry.y);
    result.z.push_back(entry.z);
    result.order.push_back(entry.index);
  }
  result.rows.push_back({0, 0, static_cast<std::uint32_t>(result.order.size())});
  return result;
}

} // namespace kernels
} // namespace pcl
