/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "support/clouds.h"
#include "support/heap_count.h"
#include "support/shapes.h"
#include "support/sweep.h"

#include <pcl/features/sweep_index.h>

#include <gtest/gtest.h>

#include <limits>
#include <thread>

// An index that is shared changes the time, and nothing else.
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
  for (std::size_t i = 0; i < alone.size(); ++i) {
    EXPECT_TRUE(sameBits(shared[i], alone[i])) << "computation " << i;
  }
}

/** \brief Heap that a computation of INAD uses, beside what was there before. */
std::ptrdiff_t
bytesOfINAD(const Surface& surface, const SweepIndex::Ptr& index)
{
  std::vector<float> mu_sigma(2 * surface.size());
  return peakBytesOf([&] {
    sweepOf(surface, index)
        .computeINAD(NeighborhoodSize::ofRadius(radius),
                     surface.trueNormals(),
                     2.0,
                     mu_sigma.data());
  });
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
  expectSameAsAlone(someSurface(4), index);
  expectSameAsAlone(someSurface(5), index);
  Surface smaller = someSurface(5);
  smaller.xyz.resize(smaller.xyz.size() - 30);
  smaller.normals.resize(smaller.xyz.size());
  expectSameAsAlone(smaller, index);
}

TEST(SweepIndex, SeesThatOnePointWasEditedInPlace)
{
  const auto index = std::make_shared<SweepIndex>();
  Surface surface = someSurface(6);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    expectSameAsAlone(surface, index);
    surface.xyz[3 * 1234 + axis] += 0.05f;
  }
  expectSameAsAlone(surface, index);
  // As many finite points as before.
  std::swap(surface.xyz[2], surface.xyz[3 * 6000 + 2]);
  expectSameAsAlone(surface, index);
}

TEST(SweepIndex, IsNotSortedAgainForAnotherComputation)
{
  const Surface surface = someSurface(7);
  const auto index = std::make_shared<SweepIndex>();
  const std::ptrdiff_t first = bytesOfINAD(surface, index);
  const std::ptrdiff_t second = bytesOfINAD(surface, index);
  const auto coordinates_and_order = static_cast<std::ptrdiff_t>(16 * surface.size());
  EXPECT_LT(second, first - coordinates_and_order);
}

TEST(SweepIndex, ClearFreesItsMemory)
{
  const Surface surface = someSurface(8);
  const auto index = std::make_shared<SweepIndex>();
  bytesOfINAD(surface, index);
  const std::ptrdiff_t before = heapInUse();
  index->clear();
  EXPECT_LT(heapInUse(), before - static_cast<std::ptrdiff_t>(16 * surface.size()));
  expectSameAsAlone(surface, index);
}

TEST(SweepIndex, TwoThreadsMayShareIt)
{
  const Surface one = someSurface(9), other = someSurface(10);
  const auto index = std::make_shared<SweepIndex>();
  std::thread concurrent([&] { expectSameAsAlone(one, index); });
  expectSameAsAlone(other, index);
  concurrent.join();
}

} // namespace
