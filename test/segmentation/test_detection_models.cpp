// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The detectors with models of one and of several classes.

#include "detection_settings.h"

#include <gtest/gtest.h>

#include <cmath>

// What detections make of models with one class or several.
namespace {

using namespace pcl;
using namespace pcl::test;

ShapeHistogram
oneBin(std::size_t mu_bin, std::uint64_t count = 1)
{
  ShapeHistogram histogram;
  histogram.add(mu_bin, 0, count);
  return histogram;
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
