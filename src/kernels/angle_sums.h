/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include "angle.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace pcl::kernels {

__extension__ using Wide = unsigned __int128;

/** \brief Mean and standard deviation of angles, in units (angle.h). */
struct Spread {
  double mean;
  double sd;
};

/** \brief Neighborhoods up to this size have sums of squares that fit in 64 bits. */
constexpr std::uint64_t most_for_64_bits = 1u << 15;

/** \brief From exact sums over at most most_for_64_bits angles. The squares are taken
 * about the rounded mean, exactly, so that nothing cancels. */
inline Spread
spreadOf(std::uint64_t count, std::uint64_t sum, std::uint64_t squares)
{
  const auto n = static_cast<double>(static_cast<std::int64_t>(count));
  const double mean = static_cast<double>(static_cast<std::int64_t>(sum)) / n;
  const auto middle = static_cast<std::uint64_t>(
      static_cast<std::int64_t>(static_cast<std::int32_t>(mean)));
  const auto about_middle =
      static_cast<std::int64_t>(squares - middle * (2 * sum - count * middle));
  const auto rest = static_cast<std::int64_t>(sum - count * middle);
  const double offset = static_cast<double>(rest) / n;
  const double variance = static_cast<double>(about_middle) / n - offset * offset;
  return {mean, std::sqrt(std::max(0.0, variance))};
}

/** \brief Exact first and second moments of angles in units. */
struct AngleSums {
  std::uint64_t count = 0;
  std::uint64_t sum = 0;
  Wide squares = 0;

  Spread
  spread() const
  {
    if (count <= most_for_64_bits) {
      return spreadOf(count, sum, static_cast<std::uint64_t>(squares));
    }
    const auto n = static_cast<double>(count);
    const Wide scaled = count * squares - Wide{sum} * sum;
    return {static_cast<double>(sum) / n, std::sqrt(static_cast<double>(scaled)) / n};
  }
};

/** \brief The angles that outlier rejection keeps: |a - mean| <= c sd (1 + 1e-5). */
struct KeptRange {
  std::int32_t first = 0;
  std::int32_t last = std::numeric_limits<std::int32_t>::max();

  bool
  contains(std::uint32_t units) const
  {
    const auto a = static_cast<std::int32_t>(units);
    return a >= first && a <= last;
  }
};

inline KeptRange
keptRange(const Spread& spread, double outlier_rate)
{
  if (outlier_rate == 0.0 || spread.sd == 0.0) {
    return {};
  }
  const double width = outlier_rate * spread.sd * (1.0 + 1e-5);
  constexpr double most = std::numeric_limits<std::int32_t>::max();
  return {static_cast<std::int32_t>(std::ceil(std::max(0.0, spread.mean - width))),
          static_cast<std::int32_t>(std::floor(std::min(most, spread.mean + width)))};
}

} // namespace pcl::kernels
