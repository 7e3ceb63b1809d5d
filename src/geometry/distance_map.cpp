// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "geometry/distance_map.h"

#include <cmath>
#include <cstddef>

namespace pcl::segmentation {
namespace {

constexpr double far = 1e12; // squared cells

/** The lower envelope of the parabolas values[q] + (x - q)^2, in place. */
void
transformLine(double* values, int count, std::ptrdiff_t step)
{
  const auto size = static_cast<std::size_t>(count);
  std::vector<double> line(size), from(size + 1);
  std::vector<int> vertex(size);
  for (int q = 0; q < count; ++q)
    line[static_cast<std::size_t>(q)] = values[q * step];
  std::size_t last = 0;
  from[0] = -far;
  for (int q = 1; q < count; ++q) {
    const auto meet = [&](int p) {
      return (line[static_cast<std::size_t>(q)] - line[static_cast<std::size_t>(p)]) /
                 (2.0 * (q - p)) +
             0.5 * (q + p);
    };
    double at = meet(vertex[last]);
    while (last > 0 && at <= from[last])
      at = meet(vertex[--last]);
    vertex[++last] = q;
    from[last] = at;
  }
  std::size_t k = 0;
  for (int x = 0; x < count; ++x) {
    while (k < last && from[k + 1] < x)
      ++k;
    const double off = x - vertex[k];
    values[x * step] = off * off + line[static_cast<std::size_t>(vertex[k])];
  }
}

} // namespace

std::vector<float>
distancesTo(const std::vector<char>& marks, int side)
{
  std::vector<double> squared;
  squared.reserve(marks.size());
  for (const char mark : marks)
    squared.push_back(mark != 0 ? 0.0 : far);
  for (int i = 0; i < side; ++i)
    transformLine(
        &squared[static_cast<std::size_t>(i) * static_cast<std::size_t>(side)],
        side,
        1);
  for (int i = 0; i < side; ++i)
    transformLine(&squared[static_cast<std::size_t>(i)], side, side);
  std::vector<float> distances;
  distances.reserve(squared.size());
  for (const double d2 : squared)
    distances.push_back(static_cast<float>(std::sqrt(d2)));
  return distances;
}

} // namespace pcl::segmentation
