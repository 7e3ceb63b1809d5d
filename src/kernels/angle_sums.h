/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace pcl {
namespace kernels {

__extension__ using Wide = unsigned __int128;

/** \brief Exact first and second moments of angles in units (angle.h). */
struct AngleSums {
  std::uint64_t count = 0;
  std::uint64_t sum = 0;
  Wide squares = 0;

  void
  add(std::uint32_t units)
  {
    ++count;
    sum += units;
    squares += std::uint64_t{units} * units;
  }

  double
  mean() const
  {
    return static_cast<double>(sum) / static_cast<double>(count);
  }

  double
  standardDeviation() const
  {
    const Wide scaled = count * squares - Wide{sum} * sum;
    return std::sqrt(static_cast<double>(scaled)) / static_cast<double>(count);
  }
};

/** \brief The angles that outlier rejection keeps: |a - mean| <= c sd (1 + 1e-5). */
struct KeptRange {
  std::uint32_t first = 0;
  std::uint32_t last = std::numeric_limits<std::uint32_t>::max();

  bool
  contains(std::uint32_t units) const
  {
    return units >= first && units <= last;
  }
};

inline KeptRange
keptRange(const AngleSums& sums, double outlier_rate)
{
  const double sd = sums.standardDeviation();
  if (outlier_rate == 0.0 || sd == 0.0) {
    return {};
  }
  const double mean = sums.mean();
  const double width = outlier_rate * sd * (1.0 + 1e-5);
  constexpr double most = std::numeric_limits<std::uint32_t>::max();
  return {static_cast<std::uint32_t>(std::ceil(std::max(0.0, mean - width))),
          static_cast<std::uint32_t>(std::floor(std::min(most, mean + width)))};
}

} // namespace kernels
} // namespace pcl
