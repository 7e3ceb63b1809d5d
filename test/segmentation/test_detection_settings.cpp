// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Settings that contradict each other are refused with a message.

#include "detection_settings.h"

#include <gtest/gtest.h>

#include <limits>

// Which settings go with which model, and what is refused.
namespace {

using namespace pcl;
using namespace pcl::test;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

using Classes =
    testing::Types<ShapeBackProjection<PointXYZ>, ShapeEdgeDetection<PointXYZ>>;
TYPED_TEST_SUITE(DetectionSettings, Classes);

TYPED_TEST(DetectionSettings, RadiiThatDisagreeWithTheModel)
{
  this->detection_.setModel(ShapeModel::idealPlane({0.02, 0.01, 0, 2.0}));
  this->expectAccepted();
  this->detection_.setRadius(0.01);
  this->detection_.setNormalRadius(0.02);
  this->expectAccepted();
  this->detection_.setRadius(0.012);
  this->expectRefused({"radius 0.012 m", "0.01 m", "setIgnoreModelParameters(true)"});
  this->detection_.setIgnoreModelParameters(true);
  this->expectAccepted();
  EXPECT_EQ(0.012, this->detection_.getParameters().radius);
  this->detection_.setIgnoreModelParameters(false);
  this->detection_.setRadius(0.01);
  this->detection_.setNormalRadius(0.03);
  this->expectRefused({"normal radius 0.03 m", "0.02 m"});
}

TYPED_TEST(DetectionSettings, KAndOutlierRateThatDisagreeWithTheModel)
{
  this->detection_.setModel(ShapeModel::idealPlane({0.02, 0.01, 0, 2.0}));
  this->detection_.setOutlierRate(1.5);
  this->expectRefused({"outlier rate 1.5", "made with 2"});
  this->detection_.setOutlierRate(2.0);
  this->detection_.setKSearch(12);
  this->expectRefused({"k 12", "made with 0"});
}

TYPED_TEST(DetectionSettings, OneRadiusInsteadOfTheModelsK)
{
  this->detection_.setModel(ShapeModel::idealPlane({0.0, 0.0, 12, 2.0}));
  this->detection_.setRadius(0.013);
  this->expectRefused({"radius 0.013 m", "made with 0", "k 0", "made with 12"});
  this->detection_.setIgnoreModelParameters(true);
  this->expectAccepted();
  const INADParameters parameters = this->detection_.getParameters();
  EXPECT_EQ(0, parameters.k);
  EXPECT_EQ(0.013, parameters.radius);
  EXPECT_EQ(0.013, parameters.normal_radius);
}

TYPED_TEST(DetectionSettings, GivenINADOfOtherRadii)
{
  this->detection_.setModel(ShapeModel::idealPlane({0.02, 0.01, 0, 2.0}));
  this->detection_.setInputINAD(this->inad_);
  this->expectAccepted();
  this->detection_.setRadius(0.03);
  this->expectRefused({"radius 0.03 m", "0.01 m"});
}

TYPED_TEST(DetectionSettings, WithoutAModelAnyRadiiWillDo)
{
  this->detection_.setRadius(0.013);
  this->detection_.setNormalRadius(0.014);
  this->expectAccepted();
  EXPECT_EQ(0.013, this->detection_.getParameters().radius);
  EXPECT_EQ(0.014, this->detection_.getParameters().normal_radius);
}

TYPED_TEST(DetectionSettings, Threshold)
{
  for (const auto mode : {TypeParam::PAPER, TypeParam::DEFAULT}) {
    this->detection_.setMode(mode);
    for (const auto& [threshold, text] :
         {std::pair(-0.1, "-0.1"), std::pair(1.1, "1.1"), std::pair(nan, "nan")}) {
      this->detection_.setThreshold(threshold);
      this->expectRefused({std::string("threshold is ") + text, "must be 0 to 1"});
    }
  }
}

TYPED_TEST(DetectionSettings, ModelWithoutAClass)
{
  this->detection_.setModel(ShapeModel());
  this->expectRefused({"the model has no class", "add() at least one"});
}

TYPED_TEST(DetectionSettings, GivenNormalsAndINADOfAnotherSize)
{
  this->detection_.setInputNormals(make_shared<PointCloud<Normal>>(99, 1));
  for (const auto mode : {TypeParam::DEFAULT, TypeParam::PAPER}) {
    this->detection_.setMode(mode);
    this->expectRefused({"99 normals", "100 points", "one for each"});
  }
  this->detection_.setInputNormals(nullptr);
  this->detection_.setInputINAD(make_shared<PointCloud<INAD>>(101, 1));
  this->expectRefused({"101 INAD", "100 points", "one for each"});
}

TYPED_TEST(DetectionSettings, Sizes)
{
  for (const auto& [radius, text] :
       {std::pair(-0.01, "-0.01"), std::pair(nan, "nan"), std::pair(infinity, "inf")}) {
    const std::string given = std::string("radius is ") + text;
    TypeParam detection = this->detection_;
    this->detection_.setRadius(radius);
    this->expectRefused({given, "positive and finite"});
    this->detection_ = detection;
    this->detection_.setNormalRadius(radius);
    this->expectRefused({given, "positive and finite"});
    this->detection_ = detection;
  }
  this->detection_.setKSearch(101);
  this->expectRefused({"k is 101", "1 to 100"});
  this->detection_.setKSearch(-1);
  this->expectRefused({"k is -1", "1 to 100"});
  this->detection_.setKSearch(12);
  this->detection_.setRadius(0.01);
  this->expectRefused({"both radius", "k (12)"});
}

TYPED_TEST(DetectionSettings, OutlierRate)
{
  this->detection_.setOutlierRate(-1);
  this->expectRefused({"outlier rate is -1", "0 (no rejection)"});
}

TYPED_TEST(DetectionSettings, CloudsAndIndices)
{
  const TypeParam usual = this->detection_;
  for (const auto mode : {TypeParam::PAPER, TypeParam::DEFAULT}) {
    this->detection_ = usual;
    this->detection_.setMode(mode);
    this->detection_.setIndices(indicesOf({3, 100}));
    this->expectRefused({"index 100", "position 1", "0 to 99"});
    this->detection_.setInputCloud(make_shared<PointCloud<PointXYZ>>());
    this->expectRefused({"the input cloud is empty"});
    const PointXYZ bad(0, std::numeric_limits<float>::infinity(), 0);
    this->detection_.setInputCloud(make_shared<PointCloud<PointXYZ>>(100, 1, bad));
    this->expectRefused({"the input cloud has no finite point"});
    this->detection_.setInputCloud(nullptr);
    this->expectRefused({"no input cloud is set", "setInputCloud()"});
  }
}

TYPED_TEST(DetectionSettings, SearchSurface)
{
  this->detection_.setSearchSurface(make_shared<PointCloud<PointXYZ>>());
  for (const auto mode : {TypeParam::PAPER, TypeParam::DEFAULT}) {
    this->detection_.setMode(mode);
    this->expectRefused({"the search surface is empty"});
  }
}

TYPED_TEST(DetectionSettings, AnErrorDoesNotStick)
{
  for (const auto mode : {TypeParam::PAPER, TypeParam::DEFAULT}) {
    this->detection_.setMode(mode);
    this->detection_.setThreshold(7);
    this->expectRefused({"threshold is 7"});
    this->detection_.setThreshold(0.5);
    this->expectAccepted();
  }
}

} // namespace
