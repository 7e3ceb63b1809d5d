// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Distances in an image to the nearest marked pixel.

#include "geometry/distance_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pcl::segmentation {
namespace {

constexpr int none = 1000000; // cells: beyond any image
constexpr double far = 1e12;  // its square, exact in a double

/** How far the nearest marked pixel of a row is, squared; far if there is none. */
void
transformRow(const char* marks, int count, double* squared)
{
  int away = none;
  for (int x = 0; x < count; ++x) {
    away = marks[x] != 0 ? 0 : std::min(away + 1, none);
    squared[x] = away;
  }
  away = none;
  for (int x = count; x-- > 0;) {
    away = marks[x] != 0 ? 0 : std::min(away + 1, none);
    const double nearer = std::min(squared[x], static_cast<double>(away));
    squared[x] = nearer * nearer;
  }
}

struct Parabola {
  double value, from;
  int vertex;
};

/** The lower envelope of the parabolas values[q] + (x - q)^2, in place. What is far is
 * above all others. \param[in,out] envelope its memory */
void
transformLine(double* values,
              int count,
              std::ptrdiff_t step,
              std::vector<Parabola>& envelope)
{
  envelope.clear();
  for (int q = 0; q < count; ++q) {
    const double value = values[q * step];
    if (value == far)
      continue;
    const auto meet = [&](const Parabola& p) {
      return (value - p.value) / (2.0 * (q - p.vertex)) + 0.5 * (q + p.vertex);
    };
    double from = -far;
    while (!envelope.empty() && (from = meet(envelope.back())) <= envelope.back().from)
      envelope.pop_back();
    envelope.push_back({value, envelope.empty() ? -far : from, q});
  }
  if (envelope.empty())
    return;
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
  std::vector<double> squared(marks.size());
  for (std::ptrdiff_t row = 0; row < side; ++row)
    transformRow(marks.data() + row * side, side, squared.data() + row * side);
  std::vector<Parabola> envelope;
  for (std::ptrdiff_t column = 0; column < side; ++column)
    transformLine(squared.data() + column, side, side, envelope);
  std::vector<float> distances;
  distances.reserve(squared.size());
  for (const double d2 : squared)
    distances.push_back(static_cast<float>(std::sqrt(d2)));
  return distances;
}

} // namespace pcl::segmentation
