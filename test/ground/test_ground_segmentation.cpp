// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Ground of simple stages, and refused input.

#include "ground_truth.h"
#include "support/errors.h"
#include "support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

using namespace pcl;
using namespace pcl::test;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

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

TEST(GroundSegmentation, WithoutALaserCellsAreSquares)
{
  const Stage stage(30.0, 3.0, 0.8);
  EXPECT_GE(f1(likelihoodsOf(stage.cloud), stage.truth), 0.99);
}

TEST(GroundSegmentation, ACurbIsGroundATableIsNot)
{
  const Stage curb(10.0, 4.0, 0.15);
  const std::vector<float> all = likelihoodsOf(curb.cloud);
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

TEST(GroundSegmentation, TheHeightOfTheSensorTellsTheLevel)
{
  Stage levels(10.0, 6.0, 3.0); // a large deck, 3 m above what is around it
  for (PointXYZ& p : *levels.cloud)
    p.z -= 4.5f;
  Ground ground;
  ground.setInputCloud(levels.cloud);
  std::vector<float> likelihoods;
  ground.setSensorHeight(4.5f);
  ground.compute(likelihoods);
  EXPECT_GE(f1(likelihoods, levels.truth), 0.99);
  ground.setSensorHeight(1.5f);
  ground.compute(likelihoods);
  for (std::uint32_t& truth : levels.truth)
    truth = 1 - truth;
  EXPECT_GE(f1(likelihoods, levels.truth), 0.99);
}

TEST(GroundSegmentation, ALargerCeilingIsNoGround)
{
  // A floor and, where none is seen, the ceiling, above the sensor.
  Stage room(10.0, 8.0, 3.0);
  for (PointXYZ& p : *room.cloud)
    p.z -= 2.0f;
  EXPECT_GE(f1(likelihoodsOf(room.cloud), room.truth), 0.99);
}

TEST(GroundSegmentation, APlaceCountsOnce)
{
  const Stage stage(30.0, 3.0, 0.8);
  const std::vector<float> once = likelihoodsOf(stage.cloud);
  const auto often = make_shared<Cloud>();
  for (int i = 0; i < 3; ++i)
    *often += *stage.cloud;
  const PointXYZ hot = (*stage.cloud)[100];
  often->points.insert(often->end(), 50000, hot);
  often->width = static_cast<std::uint32_t>(often->size());
  const std::vector<float> repeated = likelihoodsOf(often);
  for (std::size_t i = 0; i < often->size(); ++i)
    ASSERT_EQ(repeated[i], once[i < 3 * once.size() ? i % once.size() : 100]) << i;
}

TEST(GroundSegmentation, FillersAreUnknownAndChangeNothing)
{
  const Stage stage(30.0, 3.0, 0.8);
  for (const float sensor_z : {0.0f, 1.5f}) {
    const auto cloud = make_shared<Cloud>(*stage.cloud);
    cloud->sensor_origin_ = Eigen::Vector4f(0.0f, 0.0f, sensor_z, 0.0f);
    const std::vector<float> without = likelihoodsOf(cloud);
    for (int i = 0; i < 4000; ++i)
      cloud->emplace_back(0.0f, 0.0f, i % 2 == 0 ? 0.0f : sensor_z);
    const std::vector<float> with = likelihoodsOf(cloud);
    for (std::size_t i = 0; i < cloud->size(); ++i) {
      if (i < without.size())
        ASSERT_EQ(with[i], without[i]) << i;
      else
        ASSERT_TRUE(std::isnan(with[i])) << i;
    }
  }
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

TEST(GroundSegmentation, EverySetterHasItsGetter)
{
  Ground ground;
  EXPECT_TRUE(ground.getUp() == Eigen::Vector3f(0.0f, 0.0f, 1.0f));
  EXPECT_EQ(ground.getMaxSlope(), 0.35f);
  EXPECT_EQ(ground.getMaxStep(), 0.2f);
  EXPECT_EQ(ground.getThreshold(), 0.5f);
  EXPECT_EQ(ground.getSensorHeight(), 0.0f);
  EXPECT_EQ(ground.getNumberOfThreads(), 0U);
  ground.setUp({0.0f, -1.0f, 0.0f});
  ground.setMaxSlope(0.1f);
  ground.setMaxStep(0.3f);
  ground.setThreshold(0.7f);
  ground.setSensorHeight(1.2f);
  ground.setNumberOfThreads(3);
  EXPECT_TRUE(ground.getUp() == Eigen::Vector3f(0.0f, -1.0f, 0.0f));
  EXPECT_EQ(ground.getMaxSlope(), 0.1f);
  EXPECT_EQ(ground.getMaxStep(), 0.3f);
  EXPECT_EQ(ground.getThreshold(), 0.7f);
  EXPECT_EQ(ground.getSensorHeight(), 1.2f);
  EXPECT_EQ(ground.getNumberOfThreads(), 3U);
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
  ground_.setThreshold(0.5f);
  for (const float height : {-1.0f, nan}) {
    ground_.setSensorHeight(height);
    expectRefused("sensor_height is ");
  }
}

TEST_F(BadGround, Indices)
{
  ground_.setInputCloud(cloud_);
  ground_.setIndices(make_shared<pcl::Indices>(1, 30000));
  expectRefused("index 30000 is out of range: the cloud has 30000 points");
}

} // namespace
