// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Distances in an image to the nearest marked pixel.

#include "geometry/distance_map.h"

#include <cmath>
#include <cstddef>

namespace pcl::segmentation {
namespace {

constexpr double far = 1e12; // squared cells: beyond any image, exact in a double

/** The lower envelope of the parabolas values[q] + (x - q)^2, in place. */
void
transformLine(double* values, int count, std::ptrdiff_t step)
{
  struct Parabola {
    double value, from;
    int vertex;
  };
  std::vector<Parabola> envelope{{values[0], -far, 0}};
  for (int q = 1; q < count; ++q) {
    const double value = values[q * step];
    const auto meet = [&](const Parabola& p) {
      return (value - p.value) / (2.0 * (q - p.vertex)) + 0.5 * (q + p.vertex);
    };
    double at = meet(envelope.back());
    while (envelope.size() > 1 && at <= envelope.back().from) {
      envelope.pop_back();
      at = meet(envelope.back());
    }
    envelope.push_back({value, at, q});
  }
  std::size_t k = 0;
  for (int x = 0; x < count; ++x) {
    while (k + 1 < envelope.size() && envelope[k + 1].from < x)
      ++k;
    const double off = x - envelope[k].vertex;
    values[x * step] = off * off + envelope[k].value;
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
  for (std::ptrdiff_t row = 0; row < side; ++row)
    transformLine(squared.data() + row * side, side, 1);
  for (std::ptrdiff_t column = 0; column < side; ++column)
    transformLine(squared.data() + column, side, side);
  std::vector<float> distances;
  distances.reserve(squared.size());
  for (const double d2 : squared)
    distances.push_back(static_cast<float>(std::sqrt(d2)));
  return distances;
}

} // namespace pcl::segmentation
