// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Per-point radii, k, queries that are other points, and what the point itself is.

#include "support/differences.h"
#include "support/kernel_targets.h"
#include "support/reference.h"
#include "support/shapes.h"
#include "support/sweep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace {

using namespace pcl;
using namespace pcl::test;

class SweepNeighborhoods : public testing::TestWithParam<std::string> {
protected:
  SweepNeighborhoods()
  {
    Random random(2);
    scene_ = mixedScene(3000, random);
    scene_.addNoise(0.0005, random);
  }

  /** \brief Counts, normals and INAD against the reference's neighbors. */
  void
  expectEqualToReference(const Surface& cloud,
                         const NeighborhoodSize& size,
                         const std::vector<Found>& found) const
  {
    const NeighborhoodSweep sweep(cloud.points());
    const auto counts = sweptCounts(sweep, size);
    const auto normals = sweptNormals(sweep, size);
    const XYZView true_normals = cloud.trueNormals();
    const auto inad = sweptINAD(sweep, size, true_normals);
    Differences angles, curvatures;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const Found others = without(found[i], i);
      ASSERT_EQ(others.size(), counts[i]) << "point " << i;
      const auto expected =
          referenceINAD(true_normals, vectorAt(true_normals, i), others, 2.0);
      angles.add(expected.mu, inad[2 * i]);
      angles.add(expected.sigma, inad[2 * i + 1]);
      curvatures.add(referenceNormal(cloud.points(), found[i]).curvature,
                     normals[4 * i + 3]);
    }
    EXPECT_GT(angles.known(), cloud.size());
    EXPECT_GE(angles.within(1e-5), 0.999);
    EXPECT_GE(angles.within(2e-6), 0.99);
    EXPECT_GE(curvatures.within(1e-6), 0.999);
  }

  std::vector<Found>
  nearestIn(const Surface& cloud, std::size_t k) const
  {
    std::vector<Found> found;
    for (std::size_t i = 0; i < cloud.size(); ++i)
      found.push_back(neighborsNearest(cloud.points(), cloud.points()[i], k));
    return found;
  }

  ForcedTarget target_{GetParam()};
  Surface scene_;
};

TEST_P(SweepNeighborhoods, RadiusOfEachPoint)
{
  Random random(3);
  std::vector<float> radii;
  std::vector<Found> found;
  for (std::size_t i = 0; i < scene_.size(); ++i) {
    radii.push_back(static_cast<float>(random.uniform(0.008, 0.04)));
    found.push_back(neighborsWithin(scene_.points(), scene_.points()[i], radii.back()));
  }
  expectEqualToReference(scene_, NeighborhoodSize::ofRadii(radii.data()), found);
}

TEST_P(SweepNeighborhoods, NearestPoints)
{
  for (const std::size_t k : {6U, 11U, 12U, 15U, 16U, 17U, 64U, 300U}) {
    SCOPED_TRACE(k);
    expectEqualToReference(
        scene_, NeighborhoodSize::ofNearest(k), nearestIn(scene_, k));
  }
}

TEST_P(SweepNeighborhoods, AllPointsAsNearest)
{
  Random random(4);
  const Surface cloud = sphere(300, 0.05, random);
  expectEqualToReference(
      cloud, NeighborhoodSize::ofNearest(cloud.size()), nearestIn(cloud, cloud.size()));
}

/** \brief Ties everywhere: which points are taken shows in the angles, as the true
 * normals are made random. */
TEST_P(SweepNeighborhoods, TiesOfNearestPointsGoToTheSmallerIndex)
{
  Random random(5);
  Surface cloud = grid(40, 0.001953125); // a power of two: distances tie exactly
  for (float& value : cloud.normals)
    value = static_cast<float>(random.uniform(-1, 1));
  for (const std::size_t k : {7U, 8U, 11U, 12U, 15U, 16U, 30U, 100U, 200U}) {
    SCOPED_TRACE(k);
    expectEqualToReference(cloud, NeighborhoodSize::ofNearest(k), nearestIn(cloud, k));
  }
}

TEST_P(SweepNeighborhoods, RadiusIsExclusive)
{
  const Surface cloud = grid(21, 0.0078125);
  const auto countAt = [&](double radius) {
    return sweptCounts(NeighborhoodSweep(cloud.points()),
                       NeighborhoodSize::ofRadius(radius))[220];
  };
  EXPECT_EQ(4U, countAt(0.0078125 * 1.0001));
  EXPECT_EQ(0U, countAt(0.0078125));
}

TEST_P(SweepNeighborhoods, IndicesSelectResults)
{
  const std::vector<std::int32_t> indices{2900, 0, 17, 17, 1500};
  NeighborhoodSweep some(scene_.points());
  const NeighborhoodSweep all(scene_.points());
  some.setQueryIndices(indices.data(), indices.size());
  for (const auto& size :
       {NeighborhoodSize::ofRadius(0.02), NeighborhoodSize::ofNearest(40)}) {
    const auto expected = sweptINAD(all, size, scene_.trueNormals());
    const auto result = sweptINAD(some, size, scene_.trueNormals());
    const auto counts = sweptCounts(some, size);
    const auto expected_counts = sweptCounts(all, size);
    ASSERT_EQ(2 * indices.size(), result.size());
    for (std::size_t i = 0; i < indices.size(); ++i) {
      const auto point = static_cast<std::size_t>(indices[i]);
      EXPECT_EQ(expected[2 * point], result[2 * i]);
      EXPECT_EQ(expected[2 * point + 1], result[2 * i + 1]);
      EXPECT_EQ(expected_counts[point], counts[i]);
    }
  }
}

TEST_P(SweepNeighborhoods, NormalsOfFewQueriesAreThoseOfFullBlocks)
{
  Random random(7);
  Surface far = mixedScene(100000, random);
  for (float& coordinate : far.xyz)
    coordinate += 50.0f;
  // All points: more than one lane adds up in 32 bits.
  const NeighborhoodSize all = NeighborhoodSize::ofRadius(20.0);
  std::vector<std::int32_t> full(64), few{9, 40};
  std::iota(full.begin(), full.end(), 300);
  for (std::int32_t& query : few)
    query = full[static_cast<std::size_t>(query)];
  NeighborhoodSweep of_full(far.points()), of_few(far.points());
  of_full.setQueryIndices(full.data(), full.size());
  of_few.setQueryIndices(few.data(), few.size());
  ASSERT_EQ(far.size() - 1, sweptCounts(of_few, all)[0]);
  const auto expected = sweptNormals(of_full, all);
  const auto normals = sweptNormals(of_few, all);
  for (std::size_t i = 0; i < few.size(); ++i)
    for (std::size_t value = 0; value < 4; ++value)
      EXPECT_EQ(expected[4 * static_cast<std::size_t>(few[i] - full[0]) + value],
                normals[4 * i + value]);
}

TEST_P(SweepNeighborhoods, OtherQueriesHaveTheNormalOfTheNearestSurfacePoint)
{
  Random random(6);
  Surface queries = scene_;
  queries.addNoise(0.002, random);
  NeighborhoodSweep sweep(scene_.points());
  sweep.setQueries(queries.points());
  const auto inad =
      sweptINAD(sweep, NeighborhoodSize::ofRadius(0.02), scene_.trueNormals());
  const auto counts = sweptCounts(sweep, NeighborhoodSize::ofRadius(0.02));
  Differences angles;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const float* query = queries.points()[i];
    const Found found = neighborsWithin(scene_.points(), query, 0.02);
    ASSERT_EQ(found.size(), counts[i]);
    const std::uint32_t nearest = neighborsNearest(scene_.points(), query, 1)[0];
    const auto expected = referenceINAD(
        scene_.trueNormals(), vectorAt(scene_.trueNormals(), nearest), found, 2.0);
    angles.add(expected.mu, inad[2 * i]);
    angles.add(expected.sigma, inad[2 * i + 1]);
  }
  EXPECT_GE(angles.within(1e-5), 0.999);
}

TEST_P(SweepNeighborhoods, EqualQueriesLeaveOutTheirTwinOnce)
{
  const Surface queries = scene_;
  NeighborhoodSweep other(scene_.points());
  other.setQueries(queries.points());
  const NeighborhoodSweep own(scene_.points());
  const auto size = NeighborhoodSize::ofRadius(0.02);
  EXPECT_EQ(sweptCounts(own, size), sweptCounts(other, size));
  EXPECT_EQ(sweptINAD(own, size, scene_.trueNormals()),
            sweptINAD(other, size, scene_.trueNormals()));
}

TEST_P(SweepNeighborhoods, CoincidentPointsCount)
{
  Surface twice = scene_;
  twice.append(scene_);
  const auto size = NeighborhoodSize::ofRadius(0.02);
  const auto single = sweptCounts(NeighborhoodSweep(scene_.points()), size);
  const auto doubled = sweptCounts(NeighborhoodSweep(twice.points()), size);
  for (std::size_t i = 0; i < scene_.size(); ++i)
    ASSERT_EQ(2 * single[i] + 1, doubled[i]);
  std::vector<Found> found;
  for (std::size_t i = 0; i < twice.size(); ++i)
    found.push_back(neighborsWithin(twice.points(), twice.points()[i], 0.02));
  expectEqualToReference(twice, size, found);
}

TEST_P(SweepNeighborhoods, OutlierRatesThatRejectMost)
{
  const NeighborhoodSweep sweep(scene_.points());
  const XYZView normals = scene_.trueNormals();
  constexpr double radius = 0.05;
  for (const double rate : {0.5, 1.0, 3.0}) {
    const auto inad =
        sweptINAD(sweep, NeighborhoodSize::ofRadius(radius), normals, rate);
    Differences angles;
    for (std::size_t i = 0; i < scene_.size(); ++i) {
      const Found others =
          without(neighborsWithin(scene_.points(), scene_.points()[i], radius), i);
      const auto expected = referenceINAD(normals, vectorAt(normals, i), others, rate);
      angles.add(expected.mu, inad[2 * i]);
      angles.add(expected.sigma, inad[2 * i + 1]);
    }
    EXPECT_GE(angles.within(2e-6), 0.99) << rate;
  }
}

/** \brief Angles of 0 and one unit (2^-23 rad): no whole unit is within a tenth of the
 * deviation from the mean. Nothing is kept then, and all angles count. */
TEST_P(SweepNeighborhoods, NoAngleInTheKeptRange)
{
  Random random(5);
  Surface wall = plane(2000, 0.1, random);
  for (std::size_t i = 0; i < wall.size(); i += 2)
    wall.normals[3 * i] = 1.3e-7f;
  const NeighborhoodSweep sweep(wall.points());
  const auto size = NeighborhoodSize::ofRadius(0.02);
  const auto all = sweptINAD(sweep, size, wall.trueNormals(), 0.0);
  EXPECT_GT(*std::max_element(all.begin(), all.end()), 1e-8f);
  for (const double rate : {0.1, 0.3})
    EXPECT_EQ(sweptINAD(sweep, size, wall.trueNormals(), rate), all) << rate;
}

INSTANTIATE_TEST_SUITE_P(Targets,
                         SweepNeighborhoods,
                         testing::ValuesIn(kernelTargets()),
                         TargetName());

} // namespace
