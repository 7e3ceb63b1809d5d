// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Angles between unit vectors, and exact statistics over them.

#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace pcl::kernels {

/** \brief Integers of twice the size, for sums and products that need them. */
__extension__ using Wide = unsigned __int128;
__extension__ using SignedWide = __int128;

/** \brief Q, the minimax polynomial of 2 asin(sqrt(t) / 2) = sqrt(t) Q(t), lowest
 * degree first. */
constexpr float angle_polynomial[] = {1.000000898e+00f,
                                      4.165096783e-02f,
                                      4.766297369e-03f,
                                      5.256729479e-04f,
                                      3.057683521e-04f,
                                      -8.097935841e-05f,
                                      2.884860886e-05f};

/** \brief The acute angle between two unit vectors with squared chord t in [0, 2]. The
 * error is below 1e-7 rad, and near 0 relative, where acos of a float is wrong by 5e-4
 * rad. */
inline float
angleOfChord(float t)
{
  float sum = angle_polynomial[6];
  for (int i = 5; i >= 0; --i)
    sum = sum * t + angle_polynomial[i];
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

/** \brief Mean and standard deviation of angles, in units. */
struct Spread {
  double mean;
  double sd;
};

/** \brief The squares of this many angles, of 24 bits each, have a sum of 64 bits. */
constexpr std::uint64_t max_for_64_bits = 1u << 15;

/** \brief From exact sums over at most max_for_64_bits angles. The squares are taken
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
    if (count <= max_for_64_bits)
      return spreadOf(count, sum, static_cast<std::uint64_t>(squares));
    const auto n = static_cast<double>(count);
    const Wide scaled = count * squares - Wide{sum} * sum;
    return {static_cast<double>(sum) / n, std::sqrt(static_cast<double>(scaled)) / n};
  }
};

/** \brief Rounding must not reject angles that are all alike. */
constexpr double rejection_margin = 1.0 + 1e-5;

/** \brief The angles that outlier rejection keeps: |a - mean| <= c sd times the margin.
 */
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
  if (outlier_rate == 0.0 || spread.sd == 0.0)
    return {};
  const double width = outlier_rate * spread.sd * rejection_margin;
  constexpr double max = std::numeric_limits<std::int32_t>::max();
  return {static_cast<std::int32_t>(std::ceil(std::max(0.0, spread.mean - width))),
          static_cast<std::int32_t>(std::floor(std::min(max, spread.mean + width)))};
}

} // namespace pcl::kernels
