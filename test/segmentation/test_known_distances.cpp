// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Parts of a cloud whose distances are known have what they have when distances are
// measured.

#include "measured_numbers.h"
#include "support/bits.h"
#include "support/errors.h"
#include "support/random.h"

#include <pcl/point_types.h>
#include <pcl/segmentation/cloud_reach.h>
#include <pcl/segmentation/known_parts.h>
#include <pcl/segmentation/shape_field_estimation.h>
#include <pcl/features/impl/neighborhoods.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace pcl;
using namespace pcl::test;

using Cloud = PointCloud<PointXYZ>;
constexpr float infinite = std::numeric_limits<float>::infinity();
constexpr unsigned numbers_of_threads[] = {1, 2, 3};

/** A strip of floor with a wall along it, 4 m long, and some points that are far from
 * the others. */
Cloud::Ptr
strip()
{
  Random random(6);
  const auto cloud = make_shared<Cloud>();
  const auto add = [&](double x, double y, double z) {
    const auto moved = [&](double value) {
      return static_cast<float>(value + 0.002 * random.normal());
    };
    cloud->emplace_back(moved(x), moved(y), moved(z));
  };
  constexpr double spacing = 0.02;
  for (double x = 0.0; x < 4.0; x += spacing)
    for (double v = 0.0; v < 0.6; v += spacing) {
      add(x, v, 0.0);
      add(x, 0.0, v);
    }
  for (double x = 0.1; x < 4.0; x += 0.25)
    add(x, 0.3, 0.5);
  return cloud;
}

std::vector<float>
distancesOf(const Cloud& cloud)
{
  return PartOfCloud(detail::xyzOf(cloud), std::vector<bool>(cloud.size(), true), 1)
      .measureDistances(std::numeric_limits<double>::infinity());
}

/** The points of the strip around its middle, which are its own within 0.5 m. */
class KnownDistances : public ::testing::Test {
protected:
  KnownDistances() : cloud(strip()), numbers(measuredNumbers(*cloud))
  {
    const CloudReach reach = reachOf(numbers, ShapeModel::defaultEdges());
    const double halo = std::max(reach.edges, reach.noise);
    const std::vector<float> all = distancesOf(*cloud);
    for (std::size_t i = 0; i < cloud->size(); ++i) {
      const PointXYZ& point = (*cloud)[i];
      const double off = std::abs(static_cast<double>(point.x) - 2.0);
      if (off > 0.5 + halo)
        continue;
      near->push_back(point);
      part.is_measured.push_back(off <= 0.5);
      const bool is_near = static_cast<double>(all[i]) <= reach.spacing;
      far += is_near ? 0 : 1;
      part.distances.push_back(is_near ? all[i] : infinite);
    }
    part.places = detail::xyzOf(*near);
    EXPECT_LT(near->size(), cloud->size());
    EXPECT_GT(far, 2);
  }

  std::vector<float>
  measuredEdges() const
  {
    ShapeFieldEstimation<PointXYZ> estimation;
    estimation.setInputCloud(near);
    estimation.setEdgesOnly(true);
    estimation.setCloudNumbers(numbers);
    ShapeField field;
    EXPECT_TRUE(estimation.compute(field));
    return field.edge_likelihood;
  }

  std::vector<float>
  ofOwn(const std::vector<float>& values) const
  {
    std::vector<float> own;
    for (std::size_t i = 0; i < part.is_measured.size(); ++i)
      if (part.is_measured[i])
        own.push_back(values[i]);
    return own;
  }

  const Cloud::Ptr cloud;
  const CloudNumbers numbers;
  const Cloud::Ptr near = make_shared<Cloud>();
  KnownPart part;
  int far = 0; ///< how many distances are beyond the reach
};

TEST_F(KnownDistances, GiveTheNoiseThatIsMeasuredWithoutThem)
{
  const NoiseMeasures expected = PartOfCloud(part.places, part.is_measured, 1)
                                     .measureNoise(numbers, cloud->size());
  EXPECT_GT(expected.variations.size(), 1000U);
  EXPECT_FALSE(expected.thicknesses.empty());
  for (const std::vector<float>& of_level : expected.angles)
    EXPECT_GT(of_level.size(), 50U);
  for (const unsigned threads : numbers_of_threads) {
    SCOPED_TRACE(threads);
    const NoiseMeasures found = measureNoise(part, numbers, cloud->size(), threads);
    EXPECT_TRUE(sameBits(found.variations, expected.variations));
    EXPECT_TRUE(sameBits(found.thicknesses, expected.thicknesses));
    EXPECT_GT(found.steps[0].all + found.steps[1].all, 0);
    for (std::size_t size = 0; size < expected.steps.size(); ++size) {
      EXPECT_EQ(found.steps[size].all, expected.steps[size].all);
      EXPECT_EQ(found.steps[size].bent, expected.steps[size].bent);
      EXPECT_EQ(found.steps[size].on_steps, expected.steps[size].on_steps);
      EXPECT_EQ(found.steps[size].thick, expected.steps[size].thick);
    }
    for (std::size_t level = 0; level < expected.angles.size(); ++level)
      EXPECT_TRUE(sameBits(found.angles[level], expected.angles[level])) << level;
  }
}

TEST_F(KnownDistances, GiveTheEdgesThatAreFoundWithoutThem)
{
  const std::vector<float> expected = ofOwn(measuredEdges());
  EXPECT_GT(
      std::count_if(expected.begin(), expected.end(), [](float e) { return e > 0.5f; }),
      100);
  for (const unsigned threads : numbers_of_threads) {
    SCOPED_TRACE(threads);
    const ShapeField found = edgesOf(part, near, numbers, threads);
    EXPECT_TRUE(found.isOf(near.get(), near->size()));
    EXPECT_TRUE(sameBits(ofOwn(found.edge_likelihood), expected));
  }
  // They count: wrong ones give other edges.
  KnownPart wrong = part;
  wrong.distances.assign(near->size(), 2.0f * static_cast<float>(numbers.distance));
  EXPECT_FALSE(
      sameBits(ofOwn(edgesOf(wrong, near, numbers, 1).edge_likelihood), expected));
}

class RefusedKnownParts : public KnownDistances {
protected:
  void
  expectRefusals(const std::string& count) const
  {
    const std::vector<std::string> parts{count,
                                         std::to_string(near->size()) + " places"};
    expectParts(
        exceptionOf<std::invalid_argument>([&] { edgesOf(part, near, numbers, 1); }),
        parts);
    expectParts(exceptionOf<std::invalid_argument>(
                    [&] { measureNoise(part, numbers, cloud->size(), 1); }),
                parts);
  }
};

TEST_F(RefusedKnownParts, HaveTooFewDistances)
{
  part.distances.pop_back();
  expectRefusals(std::to_string(near->size() - 1) + " distances");
}

TEST_F(RefusedKnownParts, HaveTooManyDistances)
{
  part.distances.push_back(1.0f);
  expectRefusals(std::to_string(near->size() + 1) + " distances");
}

TEST_F(RefusedKnownParts, DoNotSayOfEachPlaceWhetherItIsMeasured)
{
  part.is_measured.pop_back();
  expectRefusals(std::to_string(near->size() - 1) + " values of is_measured");
  expectParts(exceptionOf<std::invalid_argument>(
                  [&] { PartOfCloud(part.places, part.is_measured, 1); }),
              {std::to_string(near->size() - 1) + " values of is_measured"});
}

} // namespace
