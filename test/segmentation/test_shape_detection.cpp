/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "support/clouds.h"
#include "support/counting_search.h"
#include "support/differences.h"

#include <pcl/features/inad.h>
#include <pcl/features/normal_3d_omp.h>
#include <pcl/segmentation/shape_back_projection.h>
#include <pcl/segmentation/shape_edge_detection.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

using namespace pcl;
using namespace pcl::test;

using Cloud = PointCloud<PointXYZ>;
using Likelihoods = std::vector<std::vector<float>>;

class BackProjectionOf : public ShapeBackProjection<PointXYZ> {
public:
  static INADParameters
  defaults()
  {
    return INADParameters::surfaces();
  }

  static constexpr std::size_t plane_class = 0;
};

class EdgesOf : public ShapeEdgeDetection<PointXYZ> {
public:
  static INADParameters
  defaults()
  {
    return INADParameters::edges();
  }

  static constexpr std::size_t plane_class = 1;
};

/** \brief What both detectors do alike: two planes at a right angle, and two points
 * that are too far away to have neighbors. */
template <typename Detection>
class ShapeDetectionTest : public testing::Test {
protected:
  ShapeDetectionTest()
  {
    Random random(71);
    surface_ = dihedral(8000, 90, 0.16, random);
    surface_.add(SurfacePoint{{5, 5, 5}, {0, 0, 1}});
    surface_.add(SurfacePoint{{-5, 5, 5}, {0, 0, 1}});
    cloud_ = toCloud<PointXYZ>(surface_);
    detection_.setInputCloud(cloud_);
    detection_.setMode(Detection::PAPER);
  }

  PointCloud<Normal>::Ptr
  estimatedNormals() const
  {
    NormalEstimationOMP<PointXYZ, Normal> estimation;
    estimation.setInputCloud(cloud_);
    estimation.setRadiusSearch(Detection::defaults().normal_radius);
    const auto normals = make_shared<PointCloud<Normal>>();
    estimation.compute(*normals);
    return normals;
  }

  PointCloud<INAD>::Ptr
  estimatedINAD() const
  {
    INADEstimation<PointXYZ, Normal> estimation;
    estimation.setInputCloud(cloud_);
    estimation.setInputNormals(estimatedNormals());
    estimation.setRadiusSearch(Detection::defaults().radius);
    const auto inad = make_shared<PointCloud<INAD>>();
    estimation.compute(*inad);
    return inad;
  }

  Likelihoods
  likelihoods()
  {
    Likelihoods result;
    detection_.compute(result);
    return result;
  }

  std::vector<PointIndices>
  segments()
  {
    std::vector<PointIndices> result;
    detection_.segment(result);
    return result;
  }

  static double
  shareOfEqual(const std::vector<float>& a, const std::vector<float>& b)
  {
    Differences differences;
    differences.add(a, b);
    return differences.within(1e-6);
  }

  Surface surface_;
  Cloud::Ptr cloud_;
  Detection detection_;
};

using Detections = testing::Types<BackProjectionOf, EdgesOf>;
TYPED_TEST_SUITE(ShapeDetectionTest, Detections);

TYPED_TEST(ShapeDetectionTest, ThePapersParametersAreTheDefaults)
{
  this->detection_.setMode(TypeParam::PAPER);
  EXPECT_EQ(TypeParam::PAPER, this->detection_.getMode());
  EXPECT_EQ("", this->detection_.getModel().disagreement(TypeParam::defaults()));
  EXPECT_EQ("",
            this->detection_.getModel().disagreement(this->detection_.getParameters()));
  EXPECT_EQ(10U, this->detection_.getModel().classes()[0].histogram.muBins());
}

TYPED_TEST(ShapeDetectionTest, PlanesAndTheirCrease)
{
  const auto classes = this->likelihoods();
  ASSERT_EQ(2U, classes.size());
  const double reach =
      TypeParam::defaults().radius + TypeParam::defaults().normal_radius;
  std::size_t near = 0, not_plane = 0;
  for (std::size_t i = 0; i + 2 < this->surface_.size(); ++i) {
    const Eigen::Vector3d p = this->surface_.position(i);
    const double away = std::hypot(p.y(), p.z());
    const float plane = classes[TypeParam::plane_class][i];
    ASSERT_FLOAT_EQ(1.0f, classes[0][i] + classes[1][i]);
    if (away > reach) {
      ASSERT_EQ(1.0f, plane) << i;
    }
    near += away < 0.002;
    not_plane += away < 0.002 && plane < 0.5f;
  }
  EXPECT_GT(near, 100U);
  EXPECT_GT(static_cast<double>(not_plane), 0.9 * static_cast<double>(near));
}

TYPED_TEST(ShapeDetectionTest, OutputsAgree)
{
  this->cloud_->header.frame_id = "camera";
  const auto classes = this->likelihoods();
  PointCloud<Intensity> first;
  this->detection_.compute(first);
  const auto segments = this->segments();
  ASSERT_EQ(this->cloud_->size(), first.size());
  ASSERT_EQ(2U, segments.size());
  EXPECT_EQ("camera", first.header.frame_id);
  EXPECT_EQ("camera", segments[1].header.frame_id);
  EXPECT_FALSE(first.is_dense);
  Indices expected[2];
  for (std::size_t i = 0; i < first.size(); ++i) {
    const float plane = classes[TypeParam::plane_class][i];
    ASSERT_TRUE(first[i].intensity == classes[0][i] || std::isnan(plane));
    if (!std::isnan(plane)) {
      const std::size_t other = 1 - TypeParam::plane_class;
      expected[plane >= 0.5f ? TypeParam::plane_class : other].push_back(
          static_cast<index_t>(i));
    }
  }
  EXPECT_EQ(expected[0], segments[0].indices);
  EXPECT_EQ(expected[1], segments[1].indices);
  EXPECT_FALSE(expected[0].empty() || expected[1].empty());
}

TYPED_TEST(ShapeDetectionTest, PointsWithoutNeighborsAreUnknown)
{
  const auto classes = this->likelihoods();
  const auto segments = this->segments();
  for (const auto& values : classes) {
    EXPECT_TRUE(std::isnan(values[8000]) && std::isnan(values[8001]));
  }
  EXPECT_EQ(8000U, segments[0].indices.size() + segments[1].indices.size());
}

TYPED_TEST(ShapeDetectionTest, GivenNormalsAndGivenINAD)
{
  const auto estimated = this->likelihoods();
  this->detection_.setInputNormals(this->estimatedNormals());
  EXPECT_GE(this->shareOfEqual(estimated[0], this->likelihoods()[0]), 0.999);
  this->detection_.setInputNormals(nullptr);
  this->detection_.setInputINAD(this->estimatedINAD());
  EXPECT_GE(this->shareOfEqual(estimated[0], this->likelihoods()[0]), 0.999);
}

/** \brief Given normals and INAD are used, not replaced by better ones. */
TYPED_TEST(ShapeDetectionTest, WrongNormalsAndINADAreBelieved)
{
  const std::size_t size = this->cloud_->size();
  this->detection_.setInputNormals(
      make_shared<PointCloud<Normal>>(size, 1, Normal(0, 0, 1)));
  const auto flat = this->likelihoods()[TypeParam::plane_class];
  for (std::size_t i = 0; i < 8000; ++i) {
    ASSERT_EQ(1.0f, flat[i]) << i;
  }
  this->detection_.setInputINAD(
      make_shared<PointCloud<INAD>>(size, 1, INAD{0.5f, 0.5f}));
  EXPECT_EQ(std::vector<float>(size, 0.0f),
            this->likelihoods()[TypeParam::plane_class]);
}

TYPED_TEST(ShapeDetectionTest, OnlyWhatIsMissingIsEstimated)
{
  const auto search = make_shared<CountingSearch>();
  const std::size_t size = this->cloud_->size();
  this->detection_.setSearchMethod(search);
  this->likelihoods();
  EXPECT_EQ(2 * size, search->radius_calls);
  this->detection_.setInputNormals(this->estimatedNormals());
  this->likelihoods();
  EXPECT_EQ(3 * size, search->radius_calls);
  this->detection_.setInputINAD(this->estimatedINAD());
  this->likelihoods();
  EXPECT_EQ(3 * size, search->radius_calls);
  EXPECT_EQ(search, this->detection_.getSearchMethod());
}

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
    for (const std::size_t i : {0, 2, 3, 4}) {
      EXPECT_EQ(all[0][static_cast<std::size_t>((*indices)[i])], some[0][i]);
    }
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
  for (std::size_t i = this->cloud_->size(); i > 0; --i) {
    backwards->push_back(static_cast<index_t>(i - 1));
  }
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
  for (std::size_t i = 0; i < 8000; i += 10) {
    queries->push_back((*this->cloud_)[i]);
  }
  this->detection_.setInputCloud(queries);
  this->detection_.setSearchSurface(this->cloud_);
  const auto some = this->likelihoods();
  ASSERT_EQ(800U, some[0].size());
  for (std::size_t i = 0; i < 800; ++i) {
    ASSERT_EQ(expected[0][10 * i], some[0][i]);
  }
}

TYPED_TEST(ShapeDetectionTest, OrganizedCloudWithHoles)
{
  const auto image = depthImage<PointXYZ>(320, 240);
  for (std::size_t i = 0; i < image->size(); i += 11) {
    (*image)[i].x = std::numeric_limits<float>::quiet_NaN();
  }
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

TEST(ShapeEdgeDetection, EdgesAreTheFirstClass)
{
  Random random(73);
  ShapeEdgeDetection<PointXYZ> detection;
  detection.setInputCloud(toCloud<PointXYZ>(dihedral(8000, 90, 0.16, random)));
  EXPECT_EQ((std::vector<std::string>{"edge", "planar"}), detection.getClasses());
  std::vector<PointIndices> classes;
  detection.segment(classes);
  PointIndices edges;
  detection.segment(edges);
  EXPECT_EQ(classes[0].indices, edges.indices);
  EXPECT_FALSE(edges.indices.empty());
}

} // namespace
