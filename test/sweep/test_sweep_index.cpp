// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// An index that is shared changes the time, and nothing else.

#include "support/bits.h"
#include "support/heap_count.h"
#include "support/shapes.h"
#include "support/sweep.h"

#include <pcl/features/sweep_index.h>

#include <gtest/gtest.h>

#include <limits>
#include <thread>

namespace {

using namespace pcl;
using namespace pcl::test;

constexpr double radius = 0.1;

Surface
someSurface(unsigned seed)
{
  Random random(seed);
  Surface surface = sphere(4000, 1.0, random);
  surface.append(plane(2000, 2.0, random));
  surface.add({{0, 0, std::numeric_limits<double>::quiet_NaN()}, {0, 0, 1}});
  return surface;
}

NeighborhoodSweep
sweepOf(const Surface& surface, const SweepIndex::Ptr& index)
{
  NeighborhoodSweep sweep(surface.points());
  sweep.setIndex(index);
  return sweep;
}

/** \brief What a sweep computes in turn. */
std::vector<std::vector<float>>
resultsOf(const NeighborhoodSweep& sweep, const Surface& surface)
{
  std::vector<float> radii(sweep.size(), 0.08f);
  radii[0] = 0.2f;
  const auto of_radii = NeighborhoodSize::ofRadii(radii.data());
  std::vector<std::vector<float>> results;
  results.push_back(sweptNormals(sweep, NeighborhoodSize::ofRadius(radius)));
  for (const double r : {0.6 * radius, 2.0 * radius, 20.0 * radius}) {
    results.push_back(
        sweptINAD(sweep, NeighborhoodSize::ofRadius(r), surface.trueNormals()));
  }
  results.push_back(
      sweptINAD(sweep, NeighborhoodSize::ofNearest(12), surface.trueNormals()));
  results.push_back(sweptNormals(sweep, NeighborhoodSize::ofNearest(12)));
  results.push_back(sweptINAD(sweep, of_radii, surface.trueNormals()));
  results.push_back(sweptNormals(sweep, NeighborhoodSize::ofRadius(0.7 * radius)));
  const auto counts = sweptCounts(sweep, NeighborhoodSize::ofRadius(radius));
  results.emplace_back(counts.begin(), counts.end());
  results.emplace_back(sweep.size());
  sweep.computeDistanceToNearest(5, results.back().data());
  return results;
}

void
expectSameAsAlone(const Surface& surface, const SweepIndex::Ptr& index)
{
  const auto shared = resultsOf(sweepOf(surface, index), surface);
  const auto alone = resultsOf(sweepOf(surface, nullptr), surface);
  ASSERT_EQ(shared.size(), alone.size());
  for (std::size_t i = 0; i < alone.size(); ++i)
    EXPECT_TRUE(sameBits(shared[i], alone[i])) << "computation " << i;
}

std::vector<float>
inadOf(const Surface& surface, const SweepIndex::Ptr& index)
{
  return sweptINAD(sweepOf(surface, index),
                   NeighborhoodSize::ofRadius(radius),
                   surface.trueNormals());
}

/** \brief One computation, so that nothing but the points can be a reason to sort. */
void
expectSameINADAsAlone(const Surface& surface, const SweepIndex::Ptr& index)
{
  EXPECT_TRUE(sameBits(inadOf(surface, index), inadOf(surface, nullptr)));
}

TEST(SweepIndex, ResultsAreThoseWithoutIt)
{
  expectSameAsAlone(someSurface(1), std::make_shared<SweepIndex>());
}

TEST(SweepIndex, QueriesOfAnotherCloudAndSomePointsOnly)
{
  const Surface surface = someSurface(2), queries = someSurface(3);
  const auto index = std::make_shared<SweepIndex>();
  const std::vector<std::int32_t> some{5, 3, 4000, 3};
  const auto resultOf = [&](const SweepIndex::Ptr& shared) {
    NeighborhoodSweep sweep = sweepOf(surface, shared);
    const auto size = NeighborhoodSize::ofRadius(radius);
    std::vector<float> all = sweptINAD(sweep, size, surface.trueNormals());
    sweep.setQueryIndices(some.data(), some.size());
    const auto of_some = sweptINAD(sweep, size, surface.trueNormals());
    sweep.setQueries(queries.points());
    const auto of_others = sweptINAD(sweep, size, surface.trueNormals());
    all.insert(all.end(), of_some.begin(), of_some.end());
    all.insert(all.end(), of_others.begin(), of_others.end());
    return all;
  };
  EXPECT_TRUE(sameBits(resultOf(index), resultOf(nullptr)));
}

TEST(SweepIndex, SeesThatTheCloudIsAnother)
{
  const auto index = std::make_shared<SweepIndex>();
  expectSameINADAsAlone(someSurface(4), index);
  Surface surface = someSurface(5);
  expectSameINADAsAlone(surface, index);
  surface.add({{0.9, 0.9, 0}, {0, 0, 1}});
  expectSameINADAsAlone(surface, index);
  surface.xyz.resize(surface.xyz.size() - 300);
  surface.normals.resize(surface.xyz.size());
  expectSameINADAsAlone(surface, index);
  EXPECT_EQ(index->getSortCount(), 4U);
}

TEST(SweepIndex, SeesThatOnePointWasEditedInPlace)
{
  const auto index = std::make_shared<SweepIndex>();
  Surface surface = someSurface(6);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    expectSameINADAsAlone(surface, index);
    surface.xyz[3 * 1234 + axis] += 0.05f;
  }
  expectSameINADAsAlone(surface, index);
  EXPECT_EQ(index->getSortCount(), 4U);
}

TEST(SweepIndex, SeesThatAnotherPointIsFinite)
{
  const auto index = std::make_shared<SweepIndex>();
  Surface surface = someSurface(7);
  expectSameINADAsAlone(surface, index);
  std::swap(surface.xyz.back(), surface.xyz[3 * 1234 + 2]);
  expectSameINADAsAlone(surface, index);
  surface.xyz[3 * 1234 + 2] = 1.0f;
  expectSameINADAsAlone(surface, index);
  EXPECT_EQ(index->getSortCount(), 3U);
}

TEST(SweepIndex, SortsOnceForNormalsAndINADOverTwoRadii)
{
  const Surface surface = someSurface(8);
  const auto index = std::make_shared<SweepIndex>();
  const NeighborhoodSweep sweep = sweepOf(surface, index);
  sweptNormals(sweep, NeighborhoodSize::ofRadius(0.3));
  for (const double r : {0.2, 0.6})
    sweptINAD(sweep, NeighborhoodSize::ofRadius(r), surface.trueNormals());
  EXPECT_EQ(index->getSortCount(), 1U);
}

TEST(SweepIndex, NormalsOverOneRadiusHaveRowsOfTheirOwn)
{
  const Surface surface = someSurface(13);
  const auto index = std::make_shared<SweepIndex>();
  const NeighborhoodSweep sweep = sweepOf(surface, index);
  sweptINAD(sweep, NeighborhoodSize::ofRadius(0.4), surface.trueNormals());
  const auto size = NeighborhoodSize::ofRadius(0.3);
  EXPECT_TRUE(sameBits(sweptNormals(sweep, size),
                       sweptNormals(sweepOf(surface, nullptr), size)));
}

TEST(SweepIndex, SortsAnewWhereRowsWouldBeFarTooNarrow)
{
  const Surface surface = someSurface(9);
  const auto index = std::make_shared<SweepIndex>();
  const NeighborhoodSweep sweep = sweepOf(surface, index);
  for (const double r : {radius, 100.0 * radius})
    sweptINAD(sweep, NeighborhoodSize::ofRadius(r), surface.trueNormals());
  EXPECT_EQ(index->getSortCount(), 2U);
}

TEST(SweepIndex, ClearFreesItsMemory)
{
  const Surface surface = someSurface(10);
  const auto index = std::make_shared<SweepIndex>();
  inadOf(surface, index);
  const HeapCount count;
  index->clear();
  EXPECT_LT(count.inUse(), -static_cast<std::ptrdiff_t>(16 * surface.size()));
  expectSameINADAsAlone(surface, index);
}

TEST(SweepIndex, TwoThreadsMayShareIt)
{
  const Surface one = someSurface(11), other = someSurface(12);
  const auto index = std::make_shared<SweepIndex>();
  std::thread concurrent([&] { expectSameAsAlone(one, index); });
  expectSameAsAlone(other, index);
  concurrent.join();
}

} // namespace
