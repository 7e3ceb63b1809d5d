// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Some points of a cloud that stand for all, whatever their order.

#include "features/spacing/some_points.h"

#include "common/finite.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace pcl::detail {
namespace {

constexpr int significand_bits = std::numeric_limits<float>::digits - 1;
constexpr int exponent_bias = std::numeric_limits<float>::max_exponent - 1;

std::uint32_t
bitsOf(float value)
{
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

/** The exponent as it is stored: 0 for subnormal numbers. */
int
storedExponent(float value)
{
  return static_cast<int>(bitsOf(value) >> significand_bits & 0xffU);
}

/** As std::ilogb, which is a call. */
int
exponentOf(float value)
{
  const int stored = storedExponent(value);
  return stored > 0 ? stored - exponent_bias : std::ilogb(value);
}

/** The bits of value / 2^exponent: a smaller exponent if the number stays normal. */
std::uint32_t
bitsOfScaled(float value, int exponent)
{
  const int stored = storedExponent(value);
  if (stored > 0 && stored - exponent > 0)
    return bitsOf(value) - (static_cast<std::uint32_t>(exponent) << significand_bits);
  return bitsOf(std::scalbn(value, -exponent));
}

/** A number that is the same wherever the point stands in the cloud, and in units that
 * are a power of two times others: from the significands, and the exponents but for
 * what the coordinates have in common. */
std::uint32_t
hashOf(const float* point)
{
  int common = std::numeric_limits<int>::min();
  for (int i = 0; i < 3; ++i)
    if (point[i] != 0.0f)
      common = std::max(common, exponentOf(point[i]));
  std::uint32_t hash = 0x811c9dc5U; // FNV-1a, a word at a time, then mixed
  for (int i = 0; i < 3; ++i) {
    const std::uint32_t free_of_unit =
        point[i] == 0.0f ? 0 : bitsOfScaled(point[i], common);
    hash = (hash ^ free_of_unit) * 0x01000193U;
    hash ^= hash >> 15;
  }
  return hash * 0x85ebca6bU;
}

} // namespace

pcl::Indices
somePoints(const XYZView& points, std::size_t count)
{
  return somePoints(points, count, kernels::countFinite(points));
}

pcl::Indices
somePoints(const XYZView& points, std::size_t count, std::uint64_t of_points)
{
  const double share = static_cast<double>(count) / static_cast<double>(of_points);
  const auto below = static_cast<std::uint64_t>(std::min(1.0, share) * 4294967296.0);
  pcl::Indices chosen;
  for (std::size_t i = 0; i < points.size; ++i)
    if (kernels::isFinite(points[i]) && hashOf(points[i]) < below)
      chosen.push_back(static_cast<pcl::index_t>(i));
  return chosen;
}

} // namespace pcl::detail
