// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The detectors with indices, search surfaces, organized clouds and threads.

#include "detector_test.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

// Other clouds, indices, search methods and threads: the same detection.
namespace {

using namespace pcl;
using namespace pcl::test;

TYPED_TEST_SUITE(ShapeDetectionTest, Detections);

TYPED_TEST(ShapeDetectionTest, SearchMethodChangesNothing)
{
  const auto swept = this->likelihoods();
  EXPECT_EQ(nullptr, this->detection_.getSearchMethod());
  this->detection_.setSearchMethod(make_shared<search::KdTree<PointXYZ>>());
  EXPECT_GE(this->shareOfEqual(swept[0], this->likelihoods()[0]), 0.999);
}

TYPED_TEST(ShapeDetectionTest, Indices)
{
  const auto all = this->likelihoods();
  const auto indices = indicesOf({7999, 8000, 3, 3, 4000});
  this->detection_.setIndices(indices);
  const auto expectSome = [&] {
    const auto some = this->likelihoods();
    ASSERT_EQ(indices->size(), some[0].size());
    for (const std::size_t i : {0, 2, 3, 4})
      EXPECT_EQ(all[0][static_cast<std::size_t>((*indices)[i])], some[0][i]);
    EXPECT_TRUE(std::isnan(some[0][1]));
    std::size_t found = 0;
    for (const PointIndices& segment : this->segments()) {
      for (const index_t i : segment.indices) {
        EXPECT_NE(8000, i);
        ++found;
      }
    }
    EXPECT_EQ(4U, found);
  };
  expectSome();
  this->detection_.setInputINAD(this->estimatedINAD());
  expectSome();
}

TYPED_TEST(ShapeDetectionTest, AllIndicesInAnotherOrder)
{
  const auto all = this->likelihoods();
  const auto backwards = make_shared<Indices>();
  for (std::size_t i = this->cloud_->size(); i > 0; --i)
    backwards->push_back(static_cast<index_t>(i - 1));
  const std::vector<float> expected(all[0].rbegin(), all[0].rend());
  this->detection_.setIndices(backwards);
  EXPECT_GE(this->shareOfEqual(expected, this->likelihoods()[0]), 1.0);
  this->detection_.setInputINAD(this->estimatedINAD());
  EXPECT_GE(this->shareOfEqual(expected, this->likelihoods()[0]), 0.999);
}

TYPED_TEST(ShapeDetectionTest, SearchSurface)
{
  const auto expected = this->likelihoods();
  const auto queries = make_shared<Cloud>();
  for (std::size_t i = 0; i < 8000; i += 10)
    queries->push_back((*this->cloud_)[i]);
  this->detection_.setInputCloud(queries);
  this->detection_.setSearchSurface(this->cloud_);
  const auto some = this->likelihoods();
  ASSERT_EQ(800U, some[0].size());
  for (std::size_t i = 0; i < 800; ++i)
    ASSERT_EQ(expected[0][10 * i], some[0][i]);
}

TYPED_TEST(ShapeDetectionTest, OrganizedCloudWithHoles)
{
  const auto image = depthImage<PointXYZ>(320, 240);
  for (std::size_t i = 0; i < image->size(); i += 11)
    (*image)[i].x = std::numeric_limits<float>::quiet_NaN();
  for (const bool is_dense : {true, false}) {
    image->is_dense = is_dense;
    this->detection_.setInputCloud(image);
    PointCloud<Intensity> first;
    this->detection_.compute(first);
    EXPECT_EQ(320U, first.width);
    EXPECT_EQ(240U, first.height);
    EXPECT_FALSE(first.is_dense);
    EXPECT_TRUE(std::isnan(first[11].intensity));
    EXPECT_EQ(TypeParam::plane_class == 0 ? 1.0f : 0.0f, first(20, 20).intensity);
  }
}

TYPED_TEST(ShapeDetectionTest, SecondComputeWithOtherData)
{
  this->likelihoods();
  Random random(72);
  const Surface flat = plane(3000, 0.1, random);
  this->detection_.setInputCloud(toCloud<PointXYZ>(flat));
  EXPECT_EQ(std::vector<float>(3000, 1.0f),
            this->likelihoods()[TypeParam::plane_class]);
}

TYPED_TEST(ShapeDetectionTest, NumberOfThreads)
{
  this->detection_.setNumberOfThreads(1);
  const auto one = this->likelihoods();
  for (const unsigned threads : {2U, 4U}) {
    this->detection_.setNumberOfThreads(threads);
    EXPECT_TRUE(sameBits(one[0], this->likelihoods()[0]));
  }
}

TYPED_TEST(ShapeDetectionTest, NearestPointsInsteadOfRadii)
{
  this->detection_.setModel(ShapeModel::idealPlane({0.0, 0.0, 30, 2.0}));
  EXPECT_EQ(30, this->detection_.getParameters().k);
  const auto classes = this->likelihoods();
  // In k mode the far points have neighbors.
  EXPECT_FALSE(std::isnan(classes[0][8000]));
}

} // namespace
