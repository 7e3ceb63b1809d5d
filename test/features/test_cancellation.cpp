// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A computation ends soon after its scope is canceled, and else is not changed.

#include "common/parallel.h"

#include <pcl/features/cancellation.h>
#include <pcl/features/neighborhood_sweep.h>

#include <gtest/gtest.h>

#include <vector>

namespace {

TEST(Cancellation, LeavesTheRestOfALoopOut)
{
  std::atomic<bool> is_canceled{false};
  std::atomic<int> done{0};
  const pcl::CancellationScope scope(is_canceled);
  EXPECT_THROW(pcl::kernels::parallelFor(100000,
                                         2,
                                         [&](std::size_t) {
                                           if (++done >= 10)
                                             is_canceled = true;
                                         }),
               pcl::Canceled);
  // The other thread may have begun one more.
  EXPECT_LE(done, 11);
}

TEST(Cancellation, IsOfTheThreadOfTheScopeOnly)
{
  const std::atomic<bool> is_canceled{true};
  int done = 0;
  {
    const pcl::CancellationScope scope(is_canceled);
    EXPECT_THROW(pcl::kernels::parallelFor(1, 1, [&](std::size_t) { ++done; }),
                 pcl::Canceled);
    EXPECT_EQ(done, 0);
    const std::atomic<bool> is_inner_canceled{false};
    const pcl::CancellationScope inner(is_inner_canceled);
    pcl::kernels::parallelFor(1, 1, [&](std::size_t) { ++done; });
    EXPECT_EQ(done, 1);
  }
  pcl::kernels::parallelFor(1, 1, [&](std::size_t) { ++done; });
  EXPECT_EQ(done, 2);
}

TEST(Cancellation, EndsTheSweepAndLetsItBeUsedAgain)
{
  const std::vector<float> points = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
  const pcl::NeighborhoodSweep sweep({points.data(), 3, 4});
  std::vector<std::uint32_t> counts(4, 7);
  {
    const std::atomic<bool> is_canceled{true};
    const pcl::CancellationScope scope(is_canceled);
    EXPECT_THROW(
        sweep.countNeighbors(pcl::NeighborhoodSize::ofRadius(1.1), counts.data()),
        pcl::Canceled);
  }
  sweep.countNeighbors(pcl::NeighborhoodSize::ofRadius(1.1), counts.data());
  EXPECT_EQ(counts, std::vector<std::uint32_t>(4, 2));
}

} // namespace
