/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "support/clouds.h"
#include "support/errors.h"

#include <pcl/segmentation/shape_back_projection.h>
#include <pcl/segmentation/shape_edge_detection.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

// Which settings go with which model, and what is refused.
namespace {

using namespace pcl;
using namespace pcl::test;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

ShapeHistogram
oneBin(std::size_t mu_bin, std::uint64_t count = 1)
{
  ShapeHistogram histogram;
  histogram.add(mu_bin, 0, count);
  return histogram;
}

/** \brief 100 points in a plane; INAD in bins 0 to 9 of mu, ten points each. */
template <typename Class>
class DetectionSettings : public testing::Test {
protected:
  DetectionSettings()
  {
    detection_.setInputCloud(toCloud<PointXYZ>(grid(10, 0.004)));
    inad_->resize(100);
    for (std::size_t i = 0; i < 100; ++i) {
      (*inad_)[i].mu =
          static_cast<float>((static_cast<double>(i / 10) + 0.5) * pi / 20);
    }
  }

  void
  expectRefused(std::vector<std::string> parts)
  {
    PointCloud<Intensity> first(3, 1);
    std::vector<std::vector<float>> likelihoods(3);
    std::vector<PointIndices> segments(3);
    const std::string name = std::is_same_v<Class, ShapeBackProjection<PointXYZ>>
                                 ? "ShapeBackProjection"
                                 : "ShapeEdgeDetection";
    parts.insert(parts.begin(), "[pcl::" + name + "::compute]");
    expectParts(errorsOf([&] { detection_.compute(first); }), parts);
    expectParts(errorsOf([&] { detection_.compute(likelihoods); }), parts);
    expectParts(errorsOf([&] { detection_.segment(segments); }), parts);
    EXPECT_TRUE(first.empty());
    EXPECT_TRUE(likelihoods.empty());
    EXPECT_TRUE(segments.empty());
  }

  /** \brief One value of each class for each bin of mu. */
  std::vector<std::vector<float>>
  expectAccepted()
  {
    std::vector<std::vector<float>> all, of_bins;
    EXPECT_EQ("", errorsOf([&] { detection_.compute(all); }));
    for (const auto& values : all) {
      EXPECT_EQ(100U, values.size());
      of_bins.emplace_back();
      for (std::size_t i = 5; i < values.size(); i += 10) {
        of_bins.back().push_back(values[i]);
      }
    }
    EXPECT_FALSE(all.empty());
    return of_bins;
  }

  std::vector<std::size_t>
  segmentSizes()
  {
    std::vector<PointIndices> segments;
    detection_.segment(segments);
    std::vector<std::size_t> sizes;
    for (const PointIndices& segment : segments) {
      sizes.push_back(segment.indices.size());
    }
    return sizes;
  }

  Class detection_;
  PointCloud<INAD>::Ptr inad_ = make_shared<PointCloud<INAD>>();
};

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
  for (const double threshold : {-0.1, 1.1, nan}) {
    this->detection_.setThreshold(threshold);
    this->expectRefused(
        {"threshold is " + std::to_string(threshold), "0 to 1 is allowed"});
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
  this->expectRefused({"99 normals", "100 points", "one for each"});
  this->detection_.setInputNormals(nullptr);
  this->detection_.setInputINAD(make_shared<PointCloud<INAD>>(101, 1));
  this->expectRefused({"101 INAD", "100 points", "one for each"});
}

TYPED_TEST(DetectionSettings, Sizes)
{
  for (const double radius : {-0.01, nan, infinity}) {
    TypeParam detection = this->detection_;
    this->detection_.setRadius(radius);
    this->expectRefused({"radius is " + std::to_string(radius), "positive and finite"});
    this->detection_ = detection;
    this->detection_.setNormalRadius(radius);
    this->expectRefused({"radius is " + std::to_string(radius), "positive and finite"});
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

TYPED_TEST(DetectionSettings, SearchSurface)
{
  this->detection_.setSearchSurface(make_shared<PointCloud<PointXYZ>>());
  this->expectRefused({"the search surface is empty"});
}

TYPED_TEST(DetectionSettings, AnErrorDoesNotStick)
{
  this->detection_.setThreshold(7);
  this->expectRefused({"threshold is 7"});
  this->detection_.setThreshold(0.5);
  this->expectAccepted();
}

class BackProjectionModels : public DetectionSettings<ShapeBackProjection<PointXYZ>> {
protected:
  BackProjectionModels() { detection_.setInputINAD(inad_); }
};

TEST_F(BackProjectionModels, NamesOfClasses)
{
  using Names = std::vector<std::string>;
  EXPECT_EQ((Names{"planar", "curved"}), detection_.getClasses());
  ShapeModel model;
  model.add("tin", oneBin(2));
  detection_.setModel(model);
  EXPECT_EQ((Names{"tin", "other"}), detection_.getClasses());
  model.add("ball", oneBin(4));
  model.add("wall", oneBin(0));
  detection_.setModel(model);
  EXPECT_EQ((Names{"tin", "ball", "wall"}), detection_.getClasses());
}

TEST_F(BackProjectionModels, OneClassIsLookedUpAndCutAtTheThreshold)
{
  ShapeModel model;
  ShapeHistogram histogram = oneBin(2, 10);
  histogram.merge(oneBin(3, 4));
  model.add("tin", histogram);
  detection_.setModel(model);
  const auto values = expectAccepted();
  const std::vector<float> expected{0, 0, 1, 0.4f, 0, 0, 0, 0, 0, 0};
  EXPECT_EQ(expected, values[0]);
  EXPECT_FLOAT_EQ(0.6f, values[1][3]);
  EXPECT_EQ((std::vector<std::size_t>{10, 90}), segmentSizes());
  detection_.setThreshold(0.4 - 1e-6);
  EXPECT_EQ((std::vector<std::size_t>{20, 80}), segmentSizes());
  detection_.setThreshold(1);
  EXPECT_EQ((std::vector<std::size_t>{10, 90}), segmentSizes());
  detection_.setThreshold(0);
  EXPECT_EQ((std::vector<std::size_t>{100, 0}), segmentSizes());
}

TEST_F(BackProjectionModels, SeveralClassesGetPosteriors)
{
  ShapeModel model;
  ShapeHistogram wide = oneBin(1, 6);
  wide.merge(oneBin(2, 2));
  model.add("a", wide);
  model.add("b", oneBin(2, 5), 0.75);
  model.add("c", oneBin(7, 1));
  detection_.setModel(model);
  const auto values = expectAccepted();
  ASSERT_EQ(3U, values.size());
  EXPECT_EQ(1.0f, values[0][1]);
  EXPECT_FLOAT_EQ(0.25f, values[0][2]); // 2/8 against .75
  EXPECT_FLOAT_EQ(0.75f, values[1][2]);
  EXPECT_EQ(1.0f, values[2][7]);
  for (const std::size_t unknown_bin : {0, 3, 4, 5, 6, 8, 9}) {
    EXPECT_TRUE(std::isnan(values[0][unknown_bin])) << unknown_bin;
    EXPECT_TRUE(std::isnan(values[2][unknown_bin])) << unknown_bin;
  }
  EXPECT_EQ((std::vector<std::size_t>{10, 10, 10}), segmentSizes());
}

class EdgeModels : public DetectionSettings<ShapeEdgeDetection<PointXYZ>> {
protected:
  EdgeModels() { detection_.setInputINAD(inad_); }
};

TEST_F(EdgeModels, AnEdgeIsWhatIsNotPlanar)
{
  ShapeModel model(INADParameters::edges());
  ShapeHistogram plane = oneBin(0, 10);
  plane.merge(oneBin(1, 4));
  model.add("plane", plane);
  detection_.setModel(model);
  const auto values = expectAccepted();
  EXPECT_EQ(0.0f, values[0][0]);
  EXPECT_FLOAT_EQ(0.6f, values[0][1]);
  EXPECT_EQ(1.0f, values[0][2]);
  EXPECT_EQ((std::vector<std::size_t>{90, 10}), segmentSizes());
  detection_.setThreshold(0.4 - 1e-6);
  EXPECT_EQ((std::vector<std::size_t>{80, 20}), segmentSizes());
  PointIndices edges;
  detection_.segment(edges);
  EXPECT_EQ(80U, edges.indices.size());
}

TEST_F(EdgeModels, OneClassIsAllowed)
{
  ShapeModel model;
  model.add("plane", oneBin(0));
  model.add("tin", oneBin(2));
  detection_.setModel(model);
  expectRefused({"the model has 2 classes", "one, a plane"});
  PointIndices edges;
  edges.indices = {1, 2};
  errorsOf([&] { detection_.segment(edges); });
  EXPECT_TRUE(edges.indices.empty());
}

} // namespace
