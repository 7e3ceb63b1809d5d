/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "support/errors.h"
#include "support/random.h"

#include <pcl/segmentation/shape_ground_segmentation.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <numeric>

#include <scene/lidar.h>

// Other streets than those that the constants were chosen on. The floors are those that
// the method has to reach.
namespace {

using namespace pcl;

using Cloud = PointCloud<PointXYZ>;
using Ground = ShapeGroundSegmentation<PointXYZ>;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

scene::LidarScan
street(std::uint64_t seed, unsigned beams)
{
  scene::LidarOptions options;
  options.seed = seed;
  options.beams = beams;
  return scene::scanStreet(options);
}

Cloud::Ptr
cloudOf(const scene::LidarScan& scan)
{
  const auto cloud = make_shared<Cloud>();
  for (std::size_t i = 0; i < scan.xyz.size(); i += 3)
    cloud->emplace_back(scan.xyz[i], scan.xyz[i + 1], scan.xyz[i + 2]);
  return cloud;
}

std::vector<float>
likelihoodsOf(const Cloud::ConstPtr& cloud, unsigned threads = 0)
{
  Ground ground;
  ground.setInputCloud(cloud);
  ground.setNumberOfThreads(threads);
  std::vector<float> likelihoods;
  ground.compute(likelihoods);
  return likelihoods;
}

/** \brief F1 where the truth is 0 or 1. */
double
f1(const std::vector<float>& likelihoods, const std::vector<std::uint32_t>& truth)
{
  double right = 0.0, wrong = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (truth[i] <= 1) {
      const bool is_found = likelihoods.at(i) >= 0.5f;
      right += is_found && truth[i] == 1;
      wrong += is_found != (truth[i] == 1);
    }
  }
  return 2.0 * right / (2.0 * right + wrong);
}

bool
sameBits(const std::vector<float>& a, const std::vector<float>& b)
{
  return a.size() == b.size() &&
         std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

/** \brief A level square with another one above a part of it, both sampled at random.
 */
struct Stage {
  Cloud::Ptr cloud = make_shared<Cloud>();
  std::vector<std::uint32_t> truth;

  Stage(double half_width, double top_half_width, double top_height)
  {
    test::Random random(5);
    for (int i = 0; i < 30000; ++i) {
      const double x = random.uniform(-half_width, half_width);
      const double y = random.uniform(-half_width, half_width);
      const bool is_top = std::max(std::abs(x), std::abs(y)) < top_half_width;
      cloud->emplace_back(static_cast<float>(x),
                          static_cast<float>(y),
                          static_cast<float>(is_top ? top_height : 0.0));
      truth.push_back(is_top ? 0 : 1);
    }
  }
};

class Streets : public testing::TestWithParam<unsigned> {};

TEST_P(Streets, GroundIsFound)
{
  for (std::uint64_t seed = 301; seed < 305; ++seed) {
    const scene::LidarScan scan = street(seed, GetParam());
    EXPECT_GE(f1(likelihoodsOf(cloudOf(scan)), scan.ground), 0.97) << seed;
  }
}

TEST_P(Streets, PavementsAreAndRoofsAreNot)
{
  std::size_t pavements = 0, found_pavements = 0, level = 0, found_level = 0;
  for (std::uint64_t seed = 311; seed < 321; ++seed) {
    const scene::LidarScan scan = street(seed, GetParam());
    const std::vector<float> likelihoods = likelihoodsOf(cloudOf(scan));
    for (std::size_t i = 0; i < scan.size(); ++i) {
      const bool is_found = likelihoods[i] >= 0.5f;
      if (scan.ground[i] == 1 && std::abs(scan.xyz[3 * i + 1]) > 8.0f) {
        ++pavements;
        found_pavements += is_found;
      }
      if (scan.ground[i] == 0 && scan.normals[3 * i + 2] > 0.9f) {
        ++level;
        found_level += is_found;
      }
    }
  }
  ASSERT_GT(pavements, 500U);
  EXPECT_GE(static_cast<double>(found_pavements), 0.9 * static_cast<double>(pavements));
  ASSERT_GT(level, 20U) << "bonnets, boxes";
  EXPECT_LE(static_cast<double>(found_level), 0.02 * static_cast<double>(level));
}

TEST_P(Streets, OrderAndThreadsDoNotMatter)
{
  const Cloud::Ptr cloud = cloudOf(street(321, GetParam()));
  std::vector<std::size_t> order(cloud->size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  test::Random random(3);
  for (std::size_t i = order.size(); i > 1; --i)
    std::swap(order[i - 1], order[random.index(i)]);
  const auto shuffled = make_shared<Cloud>();
  for (const std::size_t i : order)
    shuffled->push_back((*cloud)[i]);

  const std::vector<float> one = likelihoodsOf(cloud, 1), two = likelihoodsOf(cloud, 2);
  EXPECT_TRUE(sameBits(one, two));
  const std::vector<float> other = likelihoodsOf(shuffled, 1);
  std::vector<float> sorted(one.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    sorted[order[i]] = other[i];
  EXPECT_TRUE(sameBits(one, sorted));
}

TEST_P(Streets, UpMayBeAnyDirectionAndTheSensorAnywhere)
{
  const scene::LidarScan scan = street(322, GetParam());
  const Cloud::Ptr cloud = cloudOf(scan);
  // A camera's frame: z forward, y down.
  for (PointXYZ& p : *cloud)
    p = PointXYZ(30.0f - p.y, -4.0f - p.z, 7.0f + p.x);
  cloud->sensor_origin_ = Eigen::Vector4f(30.0f, -4.0f, 7.0f, 0.0f);
  Ground ground;
  ground.setUp({0.0f, -2.0f, 0.0f});
  ground.setInputCloud(cloud);
  std::vector<float> likelihoods;
  ground.compute(likelihoods);
  EXPECT_GE(f1(likelihoods, scan.ground), 0.97);
}

TEST_P(Streets, ATiltedSensorFindsTheSame)
{
  constexpr double streets = 4.0;
  double level = 0.0, tilted = 0.0;
  for (std::uint64_t seed = 323; seed < 327; ++seed) {
    const scene::LidarScan scan = street(seed, GetParam());
    const Cloud::Ptr cloud = cloudOf(scan);
    const double level_f1 = f1(likelihoodsOf(cloud), scan.ground);
    const Eigen::AngleAxisf tilt(0.1f, Eigen::Vector3f(1.0f, 1.0f, 0.0f).normalized());
    for (PointXYZ& p : *cloud)
      p.getVector3fMap() = tilt * p.getVector3fMap();
    const double tilted_f1 = f1(likelihoodsOf(cloud), scan.ground);
    if (GetParam() == 64U) {
      EXPECT_GE(tilted_f1, 0.97) << seed;
      EXPECT_NEAR(tilted_f1, level_f1, 0.01) << seed;
    }
    level += level_f1 / streets;
    tilted += tilted_f1 / streets;
  }
  EXPECT_GE(tilted, 0.97);
  EXPECT_NEAR(tilted, level, 0.01);
}

TEST_P(Streets, FarOutliersDoNotSpoilIt)
{
  const scene::LidarScan scan = street(324, GetParam());
  const Cloud::Ptr cloud = cloudOf(scan);
  const double without = f1(likelihoodsOf(cloud), scan.ground);
  for (const float far : {1e6f, -1e9f, 3e15f})
    cloud->emplace_back(far, -far, far);
  const double with = f1(likelihoodsOf(cloud), scan.ground);
  EXPECT_GE(with, 0.97);
  EXPECT_NEAR(with, without, 0.002);
}

INSTANTIATE_TEST_SUITE_P(Beams, Streets, testing::Values(64U, 16U));

TEST(GroundSegmentation, WithoutALaserCellsAreSquares)
{
  const Stage stage(30.0, 3.0, 0.8);
  EXPECT_GE(f1(likelihoodsOf(stage.cloud), stage.truth), 0.99);
}

TEST(GroundSegmentation, AKerbIsGroundATableIsNot)
{
  const Stage kerb(10.0, 4.0, 0.15);
  const std::vector<float> all = likelihoodsOf(kerb.cloud);
  const auto found =
      std::count_if(all.begin(), all.end(), [](float l) { return l >= 0.5f; });
  EXPECT_GE(static_cast<double>(found), 0.97 * static_cast<double>(all.size()));

  const Stage table(10.0, 4.0, 0.7);
  EXPECT_GE(f1(likelihoodsOf(table.cloud), table.truth), 0.99);
}

TEST(GroundSegmentation, TheStepIsASetting)
{
  const Stage table(10.0, 4.0, 0.15);
  Ground ground;
  ground.setInputCloud(table.cloud);
  ground.setMaxStep(0.05f);
  std::vector<float> likelihoods;
  ground.compute(likelihoods);
  EXPECT_GE(f1(likelihoods, table.truth), 0.99);
}

TEST(GroundSegmentation, AWallIsNoGround)
{
  const auto wall = make_shared<Cloud>();
  test::Random random(7);
  for (int i = 0; i < 5000; ++i)
    wall->emplace_back(static_cast<float>(random.uniform(-5.0, 5.0)),
                       4.0f,
                       static_cast<float>(random.uniform(0.0, 3.0)));
  Ground ground;
  ground.setInputCloud(wall);
  PointIndices found;
  ground.segment(found);
  EXPECT_TRUE(found.indices.empty());
}

TEST(GroundSegmentation, IndicesAndPointsThatAreNotFinite)
{
  const Stage stage(30.0, 3.0, 0.8);
  const auto indices = make_shared<Indices>();
  for (std::size_t i = 0; i < stage.cloud->size(); i += 2)
    indices->push_back(static_cast<index_t>(i));
  (*stage.cloud)[4].x = nan;
  stage.cloud->is_dense = false;
  Ground ground;
  ground.setInputCloud(stage.cloud);
  ground.setIndices(indices);
  std::vector<float> likelihoods;
  ground.compute(likelihoods);
  ASSERT_EQ(likelihoods.size(), indices->size());
  EXPECT_TRUE(std::isnan(likelihoods[2]));
  EXPECT_EQ(std::count_if(likelihoods.begin(),
                          likelihoods.end(),
                          [](float l) { return std::isnan(l); }),
            1);
  PointIndices found;
  ground.segment(found);
  ASSERT_GT(found.indices.size(), 13000U);
  for (const index_t index : found.indices) {
    ASSERT_EQ(index % 2, 0);
    ASSERT_NE(index, 4);
  }
}

TEST(GroundSegmentation, FewPointsAndPointsAtOnePlace)
{
  for (const std::size_t size : {1U, 2U, 5U, 1000U}) {
    const auto cloud = make_shared<Cloud>();
    cloud->points.assign(size, PointXYZ(1.0f, 2.0f, 3.0f));
    cloud->width = static_cast<std::uint32_t>(size);
    cloud->height = 1;
    const std::vector<float> likelihoods = likelihoodsOf(cloud);
    ASSERT_EQ(likelihoods.size(), size);
    EXPECT_EQ(std::count(likelihoods.begin(), likelihoods.end(), 0.0f),
              static_cast<std::ptrdiff_t>(size));
  }
}

class BadGround : public testing::Test {
protected:
  void
  expectRefused(const std::string& words)
  {
    std::vector<float> likelihoods(3);
    PointIndices found;
    found.indices.resize(3);
    const std::string message = test::errorsOf([&] {
      ground_.compute(likelihoods);
      ground_.segment(found);
    });
    test::expectParts(message, {"[pcl::ShapeGroundSegmentation::compute] ", words});
    EXPECT_TRUE(likelihoods.empty());
    EXPECT_TRUE(found.indices.empty());
  }

  Cloud::Ptr cloud_ = Stage(5.0, 1.0, 0.5).cloud;
  Ground ground_;
};

TEST_F(BadGround, NoCloud) { expectRefused("setInputCloud()"); }

TEST_F(BadGround, NoPoint)
{
  ground_.setInputCloud(make_shared<Cloud>());
  expectRefused("no finite point");
  ground_.setInputCloud(make_shared<Cloud>(10, 1, PointXYZ(nan, 0.0f, 0.0f)));
  expectRefused("no finite point");
}

TEST_F(BadGround, Settings)
{
  ground_.setInputCloud(cloud_);
  ground_.setUp(Eigen::Vector3f::Zero());
  expectRefused("up is (");
  ground_.setUp({nan, 0.0f, 1.0f});
  expectRefused("up is (");
  ground_.setUp({0.0f, 0.0f, 1.0f});
  for (const float slope : {0.0f, -1.0f, 1.6f, nan}) {
    ground_.setMaxSlope(slope);
    expectRefused("max_slope is ");
  }
  ground_.setMaxSlope(0.3f);
  for (const float step : {0.0f, -1.0f, nan}) {
    ground_.setMaxStep(step);
    expectRefused("max_step is ");
  }
  ground_.setMaxStep(0.2f);
  ground_.setThreshold(1.1f);
  expectRefused("threshold is ");
}

TEST_F(BadGround, Indices)
{
  ground_.setInputCloud(cloud_);
  ground_.setIndices(make_shared<pcl::Indices>(1, 30000));
  expectRefused("index 30000: 0 to 29999 is allowed");
}

} // namespace
