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

namespace pcl::kernels {

/** \brief The acute angle between two unit vectors with squared chord t in [0, 2]:
 * 2 asin(sqrt(t) / 2) = sqrt(t) Q(t).
 *
 * Q is the minimax polynomial of degree 6; the error is below 1e-7 rad, and near 0
 * relative, where acos of a float is wrong by 5e-4 rad.
 */
inline float
angleOfChord(float t)
{
  constexpr float q[] = {1.000000898e+00f,
                         4.165096783e-02f,
                         4.766297369e-03f,
                         5.256729479e-04f,
                         3.057683521e-04f,
                         -8.097935841e-05f,
                         2.884860886e-05f};
  float sum = q[6];
  for (int i = 5; i >= 0; --i) {
    sum = sum * t + q[i];
  }
  return std::sqrt(t) * sum;
}

/** \brief Squared chord between two unit vectors of unknown sign: |a - b|^2 or |a +
 * b|^2, whichever is less. Both are sums, not 4 - t, which is inexact near 0. */
inline float
squaredChord(float ax, float ay, float az, float bx, float by, float bz)
{
  const float mx = ax - bx, my = ay - by, mz = az - bz;
  const float px = ax + bx, py = ay + by, pz = az + bz;
  return std::min((mx * mx + my * my) + mz * mz, (px * px + py * py) + pz * pz);
}

/** \brief Angles are added up as integers of this fraction of a radian: the sums are
 * exact and don't depend on their order. */
constexpr float units_per_radian = 8388608.0f; // 2^23

inline std::uint32_t
toUnits(float angle)
{
  return static_cast<std::uint32_t>(std::lrint(angle * units_per_radian));
}

} // namespace pcl::kernels
