// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Some points of a cloud, chosen by their significands and exponents.

#include "features/spacing/some_points.h"
#include "support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

namespace {

using namespace pcl;

template <typename To, typename From>
To
bitsAs(From from)
{
  To to{};
  static_assert(sizeof to == sizeof from);
  std::memcpy(&to, &from, sizeof to);
  return to;
}

/** The hash of a point's place, by the standard library's functions. */
std::uint32_t
hashOf(const float* p)
{
  int common = std::numeric_limits<int>::min();
  for (int i = 0; i < 3; ++i)
    if (p[i] != 0.0f)
      common = std::max(common, std::ilogb(p[i]));
  std::uint32_t hash = 0x811c9dc5U;
  for (int i = 0; i < 3; ++i) {
    const float free_of_unit = p[i] == 0.0f ? 0.0f : std::scalbn(p[i], -common);
    hash = (hash ^ bitsAs<std::uint32_t>(free_of_unit)) * 0x01000193U;
    hash ^= hash >> 15;
  }
  return hash * 0x85ebca6bU;
}

TEST(SomePoints, AreThoseOfTheStandardFunctionsForAllFloats)
{
  // Of all exponents, so that subnormal numbers occur, and results that are.
  test::Random random(3);
  std::vector<float> xyz;
  const std::vector<float> special{0.0f,
                                   -0.0f,
                                   1.0f,
                                   std::numeric_limits<float>::max(),
                                   std::numeric_limits<float>::min(),
                                   std::numeric_limits<float>::denorm_min()};
  for (const float x : special)
    for (const float y : special)
      for (const float z : special)
        xyz.insert(xyz.end(), {x, -y, z});
  for (int i = 0; i < 60000; ++i)
    xyz.push_back(
        bitsAs<float>(static_cast<std::uint32_t>(random.uniform(0.0, 0x1p32))));
  const XYZView points{xyz.data(), 3, xyz.size() / 3};
  pcl::Indices expected;
  for (std::size_t i = 0; i < points.size; ++i)
    if (std::all_of(
            points[i], points[i] + 3, [](float v) { return std::isfinite(v); }) &&
        hashOf(points[i]) < 0x80000000U)
      expected.push_back(static_cast<index_t>(i));
  EXPECT_GT(expected.size(), 9000u);
  EXPECT_EQ(expected, detail::somePoints(points, 1, 2));
}

} // namespace
