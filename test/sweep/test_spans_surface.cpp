// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Whether offsets spread over a surface, in whatever order they come.

#include "sweep/portable/neighborhood.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace {

struct Offset {
  float dx, dy, dz, d2;
};

Offset
offset(float x, float y)
{
  return {x, y, 0.0f, x * x + y * y};
}

/** \brief Of this y, and as long as (1, 0, 0). */
Offset
asLongAsOne(float y)
{
  float x = 1.0f;
  while (offset(x, y).d2 > 1.0f)
    x = std::nextafter(x, 0.0f);
  return offset(x, y);
}

TEST(SpansSurface, EquallyLongOffsetsInAnyOrderSayTheSame)
{
  // The last one is near the first one's line, but not near the second one's.
  std::vector<Offset> offsets{offset(1.0f, 0.0f),
                              asLongAsOne(0.0009f),
                              offset(0.5f, 0.0f),
                              offset(0.9f, -5e-4f)};
  ASSERT_EQ(offsets[0].d2, offsets[1].d2);
  const bool spans = pcl::kernels::spansSurface(offsets);
  std::swap(offsets[0], offsets[1]);
  EXPECT_EQ(spans, pcl::kernels::spansSurface(offsets));
}

TEST(SpansSurface, OffsetsSpreadOverASurfaceBesideTheLongestOnesLine)
{
  using pcl::kernels::spansSurface;
  EXPECT_FALSE(spansSurface(std::vector<Offset>{}));
  EXPECT_FALSE(spansSurface(std::vector<Offset>(3, offset(0, 0))));
  EXPECT_FALSE(spansSurface(std::vector<Offset>{offset(1, 0), offset(-0.5f, 9e-4f)}));
  EXPECT_TRUE(spansSurface(std::vector<Offset>{offset(1, 0), offset(-0.5f, 1.1e-3f)}));
}

} // namespace
