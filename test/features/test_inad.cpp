// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// INADEstimation gives what the sweep gives, whatever the cloud and its indices.

#include "support/clouds.h"
#include "support/differences.h"
#include "support/reference.h"
#include "support/sweep.h"

#include <pcl/features/inad.h>
#include <pcl/features/normal_3d_omp.h>
#include <pcl/search/kdtree.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace {

using namespace pcl;
using namespace pcl::test;

using Cloud = PointCloud<PointXYZ>;
using Estimation = INADEstimation<PointXYZ, Normal>;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr double radius = 0.02;

/** \brief Without a search method, and with one. */
class INADEstimationTest : public testing::TestWithParam<bool> {
protected:
  INADEstimationTest()
  {
    Random random(21);
    scene_ = mixedScene(4000, random);
    scene_.addNoise(0.0005, random);
    cloud_ = toCloud<PointXYZ>(scene_);
    normals_ = trueNormalsOf<Normal>(scene_);
    estimation_.setInputCloud(cloud_);
    estimation_.setInputNormals(normals_);
    estimation_.setRadiusSearch(radius);
    if (GetParam())
      estimation_.setSearchMethod(make_shared<search::KdTree<PointXYZ>>());
  }

  std::vector<float>
  compute()
  {
    estimation_.compute(output_);
    return valuesOf(output_);
  }

  std::vector<float>
  swept(double outlier_rate = 2.0) const
  {
    return sweptINAD(NeighborhoodSweep(scene_.points()),
                     NeighborhoodSize::ofRadius(radius),
                     scene_.trueNormals(),
                     outlier_rate);
  }

  static double
  shareWithin(const std::vector<float>& a,
              const std::vector<float>& b,
              double tolerance = 1e-6)
  {
    Differences differences;
    differences.add(a, b);
    return differences.within(tolerance);
  }

  Surface scene_;
  Cloud::Ptr cloud_;
  PointCloud<Normal>::Ptr normals_;
  Estimation estimation_{2};
  PointCloud<INAD> output_;
};

TEST_P(INADEstimationTest, IsThatOfTheSweep)
{
  cloud_->header.frame_id = "camera";
  EXPECT_GE(shareWithin(swept(), compute()), 0.999);
  EXPECT_TRUE(output_.is_dense);
  EXPECT_EQ("camera", output_.header.frame_id);
  EXPECT_EQ(cloud_->size(), output_.width);
}

TEST_P(INADEstimationTest, OutlierRate)
{
  EXPECT_EQ(2.0, estimation_.getOutlierRate());
  const auto with = compute();
  estimation_.setOutlierRate(0.0);
  const auto without = compute();
  EXPECT_EQ(1.0, shareWithin(swept(0.0), without));
  EXPECT_LT(shareWithin(with, without), 0.7);
}

TEST_P(INADEstimationTest, NearestPoints)
{
  estimation_.setRadiusSearch(0);
  estimation_.setKSearch(40);
  const auto expected = sweptINAD(NeighborhoodSweep(scene_.points()),
                                  NeighborhoodSize::ofNearest(40),
                                  scene_.trueNormals());
  EXPECT_GE(shareWithin(expected, compute()), 0.999);
}

TEST_P(INADEstimationTest, Indices)
{
  const auto all = compute();
  const auto indices = indicesOf({3999 - 1, 0, 5, 5, 2000});
  estimation_.setIndices(indices);
  const auto some = compute();
  ASSERT_EQ(indices->size(), output_.size());
  EXPECT_EQ(1U, output_.height);
  for (std::size_t i = 0; i < indices->size(); ++i) {
    const auto point = static_cast<std::size_t>((*indices)[i]);
    EXPECT_EQ(all[2 * point], some[2 * i]);
    EXPECT_EQ(all[2 * point + 1], some[2 * i + 1]);
  }
}

TEST_P(INADEstimationTest, NormalsBelongToTheSearchSurface)
{
  Random random(22);
  Surface queries = scene_;
  queries.addNoise(0.002, random);
  const auto far = make_shared<Cloud>(*toCloud<PointXYZ>(queries));
  far->push_back(PointXYZ(50, 50, 50));
  estimation_.setInputCloud(far);
  estimation_.setSearchSurface(cloud_);
  const auto inad = compute();
  ASSERT_EQ(far->size(), output_.size());
  Differences differences;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const float* query = queries.points()[i];
    const std::uint32_t nearest = neighborsNearest(scene_.points(), query, 1)[0];
    const ReferenceINAD expected =
        referenceINAD(scene_.trueNormals(),
                      scene_.normal(nearest),
                      neighborsWithin(scene_.points(), query, radius),
                      2.0);
    differences.add(expected.mu, inad[2 * i]);
    differences.add(expected.sigma, inad[2 * i + 1]);
  }
  EXPECT_GE(differences.within(1e-5), 0.999);
  EXPECT_TRUE(std::isnan(output_.back().mu));
  EXPECT_FALSE(output_.is_dense);
}

TEST_P(INADEstimationTest, CopyOfTheInputAsSearchSurfaceChangesNothing)
{
  const auto expected = compute();
  estimation_.setSearchSurface(make_shared<Cloud>(*cloud_));
  EXPECT_EQ(expected, compute());
}

TEST_P(INADEstimationTest, BadPointsWhateverTheCloudSaysOfItself)
{
  for (std::size_t i = 0; i < cloud_->size(); i += 7)
    (*cloud_)[i].y = i % 2 == 0 ? nan : std::numeric_limits<float>::infinity();
  std::vector<float> results[2];
  for (const bool is_dense : {false, true}) {
    cloud_->is_dense = is_dense;
    results[is_dense] = compute();
    EXPECT_FALSE(output_.is_dense);
    for (std::size_t i = 0; i < output_.size(); ++i) {
      ASSERT_EQ(i % 7 == 0, std::isnan(output_[i].mu)) << i;
      ASSERT_EQ(i % 7 == 0, std::isnan(output_[i].sigma)) << i;
    }
  }
  EXPECT_EQ(cloud_->size(), output_.size());
  EXPECT_EQ(shareWithin(results[0], results[1], 0.0), 1.0);
}

TEST_P(INADEstimationTest, PointsWithoutANormal)
{
  (*normals_)[3].normal_x = nan;
  compute();
  EXPECT_FALSE(output_.is_dense);
  EXPECT_TRUE(std::isnan(output_[3].mu));
  EXPECT_FALSE(std::isnan(output_[4].mu));
}

TEST_P(INADEstimationTest, SecondComputeWithOtherData)
{
  compute();
  Random random(23);
  scene_ = cylinder(3000, 0.03, 0.1, random);
  estimation_.setInputCloud(toCloud<PointXYZ>(scene_));
  estimation_.setInputNormals(trueNormalsOf<Normal>(scene_));
  EXPECT_GE(shareWithin(swept(), compute()), 0.999);
}

TEST_P(INADEstimationTest, SecondComputeOfACloudThatWasEditedInPlace)
{
  compute();
  Random random(24);
  scene_.addNoise(0.01, random);
  *cloud_ = *toCloud<PointXYZ>(scene_);
  EXPECT_GE(shareWithin(swept(), compute()), 0.999);
}

TEST_P(INADEstimationTest, SecondComputeWithoutTheSearchSurfaceOfTheFirst)
{
  const auto expected = compute();
  Random random(25);
  const Surface other = sphere(4000, 0.05, random);
  Estimation estimation;
  estimation.setSearchMethod(estimation_.getSearchMethod());
  estimation.setInputCloud(cloud_);
  estimation.setRadiusSearch(radius);
  estimation.setSearchSurface(toCloud<PointXYZ>(other));
  estimation.setInputNormals(trueNormalsOf<Normal>(other));
  estimation.compute(output_);
  EXPECT_LT(shareWithin(expected, valuesOf(output_)), 0.5);
  estimation.setSearchSurface(cloud_);
  estimation.setInputNormals(normals_);
  estimation.compute(output_);
  EXPECT_EQ(expected, valuesOf(output_));
}

TEST_P(INADEstimationTest, OrganizedOutput)
{
  const auto image = depthImage<PointXYZ>(64, 48);
  NormalEstimationOMP<PointXYZ, Normal> normals;
  normals.setInputCloud(image);
  normals.setRadiusSearch(0.05);
  normals.compute(*normals_);
  estimation_.setInputCloud(image);
  estimation_.setInputNormals(normals_);
  estimation_.setRadiusSearch(0.05);
  compute();
  EXPECT_EQ(64U, output_.width);
  EXPECT_EQ(48U, output_.height);
  EXPECT_LT(output_(1, 1).mu, 0.001f); // on the wall
  EXPECT_GT(output_(34, 23).mu, 0.2f); // on the ball
}

TEST_P(INADEstimationTest, OnePoint)
{
  estimation_.setInputCloud(toCloud<PointXYZ>(grid(1, 1)));
  estimation_.setInputNormals(trueNormalsOf<Normal>(grid(1, 1)));
  compute();
  ASSERT_EQ(1U, output_.size());
  EXPECT_TRUE(std::isnan(output_[0].mu) && std::isnan(output_[0].sigma));
  EXPECT_FALSE(output_.is_dense);
}

TEST_P(INADEstimationTest, FarPointsAreUnknown)
{
  for (const float far : {1e6f, 1e30f, -1e30f}) {
    cloud_->push_back(PointXYZ(far, far, far));
    normals_->push_back(Normal(0, 0, 1));
  }
  const auto expected = swept();
  auto inad = compute();
  EXPECT_FALSE(output_.is_dense);
  EXPECT_TRUE(std::all_of(
      inad.end() - 6, inad.end(), [](float value) { return std::isnan(value); }));
  inad.resize(expected.size());
  EXPECT_GE(shareWithin(expected, inad), 0.999);
}

INSTANTIATE_TEST_SUITE_P(, INADEstimationTest, testing::Bool(), [](const auto& test) {
  return test.param ? "KdTree" : "Sweep";
});

} // namespace
