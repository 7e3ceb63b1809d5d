// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What both detectors do with planes and their crease, given normals and given INAD.

#include "detector_test.h"
#include "support/counting_search.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace pcl;
using namespace pcl::test;

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
  for (const auto& values : classes)
    EXPECT_TRUE(std::isnan(values[8000]) && std::isnan(values[8001]));
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
  for (std::size_t i = 0; i < 8000; ++i)
    ASSERT_EQ(1.0f, flat[i]) << i;
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
