// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Thousands of points at the same place: results are right, memory stays small.

#include "support/heap_count.h"
#include "support/kernel_targets.h"
#include "support/reference.h"
#include "support/shapes.h"
#include "support/sweep.h"
#include "sweep/block_sweep.h"

#include <gtest/gtest.h>

#include <algorithm>

// Thousands of points at the same place: results are right, and memory grows with the
// number of points, not of pairs.
namespace {

using namespace pcl;
using namespace pcl::test;

constexpr double radius = 0.012;

struct Heap {
  std::size_t first; ///< its members follow each other
  std::size_t size;
};

class SweepCoincident : public testing::TestWithParam<std::string> {
protected:
  SweepCoincident()
  {
    Random random(13);
    cloud_ = mixedScene(6000, random);
    cloud_.addNoise(0.0005, random);
    addHeap(20000, cloud_.position(100), random);
    addHeap(5000, cloud_.position(2500), random);
    addHeap(5000, cloud_.position(4500), random);
    addHeap(5000, {3, 3, 3}, random); // with nothing around
  }

  /** \brief With random normals, so that each point's angles are its own. */
  void
  addHeap(std::size_t size, const Eigen::Vector3d& place, Random& random)
  {
    heaps_.push_back({cloud_.size(), size});
    Surface heap = sphere(size, 1, random);
    for (std::size_t i = 0; i < size; ++i)
      cloud_.add({place, heap.normal(i)});
  }

  /** \brief Some points of each heap, and some between. */
  std::vector<std::int32_t>
  samples() const
  {
    std::vector<std::int32_t> points{0, 100, 101, 2500, 3333, 5999};
    for (const Heap& heap : heaps_)
      for (const std::size_t i : {std::size_t{0}, heap.size / 2, heap.size - 1})
        points.push_back(static_cast<std::int32_t>(heap.first + i));
    return points;
  }

  bool
  isAlone(std::size_t point) const
  {
    return point >= heaps_.back().first;
  }

  /** \brief All members of a heap have the same value, to the bit. */
  template <typename T>
  void
  expectSameInHeaps(const std::vector<T>& values, std::size_t stride) const
  {
    for (const Heap& heap : heaps_) {
      const T* first = &values[stride * heap.first];
      for (std::size_t i = 1; i < heap.size; ++i)
        ASSERT_EQ(0, std::memcmp(first, first + i * stride, stride * sizeof(T)));
    }
  }

  ForcedTarget target_{GetParam()};
  Surface cloud_;
  std::vector<Heap> heaps_;
};

TEST_P(SweepCoincident, CountsAndNormalsWithinARadius)
{
  const NeighborhoodSweep sweep(cloud_.points());
  const auto size = NeighborhoodSize::ofRadius(radius);
  const auto counts = sweptCounts(sweep, size);
  const auto normals = sweptNormals(sweep, size);
  expectSameInHeaps(counts, 1);
  expectSameInHeaps(normals, 4);
  for (const std::int32_t sample : samples()) {
    const auto i = static_cast<std::size_t>(sample);
    SCOPED_TRACE(i);
    const Found found = neighborsWithin(cloud_.points(), cloud_.points()[i], radius);
    EXPECT_EQ(found.size() - 1, counts[i]);
    if (isAlone(i)) {
      EXPECT_TRUE(std::isnan(normals[4 * i]));
      continue;
    }
    const auto expected = referenceNormal(cloud_.points(), found);
    const auto normal = vectorAt({normals.data(), 4, cloud_.size()}, i);
    EXPECT_LT(acuteAngle(expected.normal, normal), 1e-4);
    EXPECT_NEAR(expected.curvature, normals[4 * i + 3], 1e-5);
  }
}

TEST_P(SweepCoincident, AnglesWithinARadius)
{
  const XYZView true_normals = cloud_.trueNormals();
  const auto inad = sweptINAD(NeighborhoodSweep(cloud_.points()),
                              NeighborhoodSize::ofRadius(radius),
                              true_normals);
  for (const std::int32_t sample : samples()) {
    const auto i = static_cast<std::size_t>(sample);
    SCOPED_TRACE(i);
    if (isAlone(i)) {
      EXPECT_TRUE(std::isnan(inad[2 * i]));
      continue;
    }
    const Found found = neighborsWithin(cloud_.points(), cloud_.points()[i], radius);
    const auto expected =
        referenceINAD(true_normals, vectorAt(true_normals, i), without(found, i), 2.0);
    EXPECT_NEAR(expected.mu, inad[2 * i], 2e-6);
    EXPECT_NEAR(expected.sigma, inad[2 * i + 1], 2e-6);
  }
}

/** \brief Where the normals of a heap are equal, too, its points have one result. */
TEST_P(SweepCoincident, AnglesOfEqualNormalsWithinARadius)
{
  std::vector<float> normals;
  for (std::size_t i = 0; i < cloud_.size(); ++i)
    for (int axis = 0; axis < 3; ++axis)
      normals.push_back(cloud_.trueNormals()[i][axis]);
  for (const Heap& heap : heaps_)
    for (std::size_t i = 3 * heap.first; i < 3 * (heap.first + heap.size); ++i)
      normals[i] = i % 3 == 2 ? 1.0f : 0.0f;
  const XYZView view{normals.data(), 3, cloud_.size()};
  for (const auto& size :
       {NeighborhoodSize::ofRadius(radius), NeighborhoodSize::ofNearest(20300)}) {
    const auto inad = sweptINAD(NeighborhoodSweep(cloud_.points()), size, view);
    expectSameInHeaps(inad, 2);
    for (const std::int32_t sample : samples()) {
      const auto i = static_cast<std::size_t>(sample);
      SCOPED_TRACE(i);
      const Found found =
          size.k > 0 ? neighborsNearest(cloud_.points(), cloud_.points()[i], size.k)
                     : neighborsWithin(cloud_.points(), cloud_.points()[i], radius);
      if (squaredDistance(cloud_.points()[found.back()], cloud_.points()[i]) == 0.0f &&
          (size.k > 0 || isAlone(i))) {
        EXPECT_TRUE(std::isnan(inad[2 * i]));
        continue;
      }
      const auto expected =
          referenceINAD(view, vectorAt(view, i), without(found, i), 2.0);
      EXPECT_NEAR(expected.mu, inad[2 * i], 2e-6);
      EXPECT_NEAR(expected.sigma, inad[2 * i + 1], 2e-6);
    }
  }
}

/** \brief The cost is linear: each place is visited a few times, whatever its points.
 */
TEST(SweepRepeats, PlacesAreVisitedOnceAndTheirPointsGetTheResult)
{
  constexpr std::size_t heap = 50000;
  std::vector<float> points(3 * heap, 1.0f);
  for (const float other : {0.5f, 0.9f, 1.1f, 1.5f})
    points.insert(points.end(), {other, 1.0f, 1.0f});
  const std::size_t size = points.size() / 3;
  const kernels::RowIndex index =
      kernels::buildRowIndex({points.data(), 3, size}, nullptr, size, 4.0, 2);
  const kernels::BlockSweep sweep{index, index, NeighborhoodSize::ofRadius(0.2)};
  std::vector<int> visits(size, 0);
  sweep.forEachBlock(1, [&](const kernels::SweepBlock& block, const std::uint32_t* at) {
    for (std::size_t i = 0; i < block.size; ++i)
      ++visits[at[i]];
  });
  EXPECT_LT(std::count(visits.begin(), visits.end(), 1), 64);
  sweep.forEachRepeat([&](std::size_t i, std::size_t same) {
    ++visits[i];
    EXPECT_TRUE(std::equal(&points[3 * i], &points[3 * i] + 3, &points[3 * same]));
  });
  EXPECT_EQ(static_cast<std::ptrdiff_t>(size),
            std::count(visits.begin(), visits.end(), 1));
}

/** \brief Fewer than a heap has, as many, and more. */
TEST_P(SweepCoincident, NearestPoints)
{
  const std::vector<std::int32_t> points = samples();
  NeighborhoodSweep sweep(cloud_.points());
  sweep.setQueryIndices(points.data(), points.size());
  for (const std::size_t k : {40U, 5000U, 5100U, 20300U}) {
    SCOPED_TRACE(k);
    std::vector<float> distances(points.size());
    sweep.computeDistanceToNearest(k, distances.data());
    const auto inad =
        sweptINAD(sweep, NeighborhoodSize::ofNearest(k), cloud_.trueNormals());
    for (std::size_t s = 0; s < points.size(); ++s) {
      const auto i = static_cast<std::size_t>(points[s]);
      SCOPED_TRACE(i);
      const Found found = neighborsNearest(cloud_.points(), cloud_.points()[i], k);
      const float d2 =
          squaredDistance(cloud_.points()[found.back()], cloud_.points()[i]);
      EXPECT_EQ(std::sqrt(d2), distances[s]);
      if (d2 == 0.0f) {
        EXPECT_TRUE(std::isnan(inad[2 * s]));
        continue;
      }
      const auto expected = referenceINAD(cloud_.trueNormals(),
                                          vectorAt(cloud_.trueNormals(), i),
                                          without(found, i),
                                          2.0);
      EXPECT_NEAR(expected.mu, inad[2 * s], 2e-6);
      EXPECT_NEAR(expected.sigma, inad[2 * s + 1], 2e-6);
    }
  }
}

/** \brief Lists of the neighbors of these queries would take 400 MB. */
TEST_P(SweepCoincident, MemoryDoesNotGrowWithPairs)
{
  std::vector<std::int32_t> points;
  for (std::size_t i = heaps_[0].first; i < heaps_[1].first; i += 4)
    points.push_back(static_cast<std::int32_t>(i));
  std::vector<float> results(4 * points.size());
  const auto expectFewBytes = [&](const auto& compute) {
    const std::ptrdiff_t bytes = peakBytesOf([&] {
      NeighborhoodSweep sweep(cloud_.points());
      sweep.setNumberOfThreads(1);
      sweep.setQueryIndices(points.data(), points.size());
      compute(sweep);
    });
    EXPECT_LT(bytes, static_cast<std::ptrdiff_t>(56 * cloud_.size() + 2000000));
  };
  const auto size = NeighborhoodSize::ofRadius(radius);
  expectFewBytes([&](const NeighborhoodSweep& sweep) {
    sweep.computeNormals(size, results.data(), results.data() + 3, 4);
  });
  expectFewBytes([&](const NeighborhoodSweep& sweep) {
    sweep.computeINAD(size, cloud_.trueNormals(), 2.0, results.data());
  });
  points.resize(64);
  expectFewBytes([&](const NeighborhoodSweep& sweep) {
    const auto nearest = NeighborhoodSize::ofNearest(20300);
    sweep.computeINAD(nearest, cloud_.trueNormals(), 2.0, results.data());
  });
}

INSTANTIATE_TEST_SUITE_P(Targets,
                         SweepCoincident,
                         testing::ValuesIn(kernelTargets()),
                         TargetName());

} // namespace
