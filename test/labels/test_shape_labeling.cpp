// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Labels and confidences, and refused input.

#include "labeling_scenes.h"
#include "support/errors.h"

#include <pcl/common/point_tests.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace {

using namespace pcl;
using namespace pcl::test;

class OneScene : public testing::Test {
protected:
  static void
  SetUpTestSuite()
  {
    scene::SceneOptions options;
    options.seed = 79;
    options.width = 320;
    options.height = 240;
    cloud_ = cloudOf(scene::generateScene(options));
    labels_ = labelsOf(cloud_);
  }

  static void
  TearDownTestSuite()
  {
    cloud_.reset();
    labels_ = PointLabels();
  }

  static std::size_t
  differences(const Labels& labels)
  {
    std::size_t different = 0;
    for (std::size_t i = 0; i < labels_.labels.size(); ++i)
      different += labels.at(i) != labels_.labels[i] ? 1 : 0;
    return different;
  }

  static Cloud::Ptr cloud_; // organized, with NaN
  static PointLabels labels_;
};

Cloud::Ptr OneScene::cloud_;
PointLabels OneScene::labels_;

constexpr auto default_confidence =
    static_cast<float>(ShapeLabeling<PointXYZ>::default_confidence);

TEST_F(OneScene, OneLabelAPointAndVoidBelowTheConfidence)
{
  ASSERT_EQ(labels_.labels.size(), cloud_->size());
  ASSERT_EQ(labels_.confidence.size(), cloud_->size());
  for (std::size_t i = 0; i < cloud_->size(); ++i) {
    ASSERT_LE(labels_.labels[i], edge);
    ASSERT_EQ(labels_.labels[i] != 0, labels_.confidence[i] >= default_confidence);
    if (!isFinite((*cloud_)[i])) {
      ASSERT_EQ(labels_.confidence[i], 0.0f);
    }
  }
}

TEST_F(OneScene, LessConfidenceKeepsTheSameAndMore)
{
  const PointLabels all = labelsOf(cloud_, 0.0);
  EXPECT_EQ(all.confidence, labels_.confidence);
  std::size_t more = 0;
  for (std::size_t i = 0; i < cloud_->size(); ++i) {
    if (labels_.labels[i] != 0) {
      ASSERT_EQ(all.labels[i], labels_.labels[i]);
    }
    more += all.labels[i] != 0 && labels_.labels[i] == 0 ? 1 : 0;
  }
  EXPECT_GT(more, 0u);
}

TEST_F(OneScene, ThreadsDoNotMatter)
{
  for (const unsigned threads : {1u, 3u}) {
    const PointLabels labels = labelsOf(cloud_, -1.0, threads);
    EXPECT_EQ(labels.labels, labels_.labels);
    EXPECT_EQ(labels.confidence, labels_.confidence);
  }
}

TEST_F(OneScene, NeitherDoesTheUnitOfLength)
{
  const auto large = pcl::make_shared<Cloud>(*cloud_);
  for (PointXYZ& point : *large)
    point.getVector3fMap() *= 1024.0f;
  EXPECT_LE(differences(labelsOf(large).labels), cloud_->size() / 1000);
}

TEST_F(OneScene, OrderHardlyMatters)
{
  const auto reversed = pcl::make_shared<Cloud>(*cloud_);
  std::reverse(reversed->begin(), reversed->end());
  PointLabels labels = labelsOf(reversed);
  std::reverse(labels.labels.begin(), labels.labels.end());
  EXPECT_LE(differences(labels.labels), cloud_->size() / 1000);
}

TEST_F(OneScene, IndicesPickLabels)
{
  const auto indices = pcl::make_shared<Indices>(Indices{40000, 17, 40000, 52345});
  ShapeLabeling<PointXYZ> labeling;
  labeling.setInputCloud(cloud_);
  labeling.setIndices(indices);
  PointLabels labels;
  labeling.label(labels);
  ASSERT_EQ(labels.labels.size(), indices->size());
  for (std::size_t i = 0; i < indices->size(); ++i) {
    const auto index = static_cast<std::size_t>((*indices)[i]);
    EXPECT_EQ(labels.labels[i], labels_.labels[index]);
    EXPECT_EQ(labels.confidence[i], labels_.confidence[index]);
  }
}

TEST_F(OneScene, AModelsClassesComeBeforeEdges)
{
  const ShapeModel& two = ShapeModel::defaultSurfaces();
  ShapeModel three(two.parameters());
  three.setSmoothing(two.smoothing());
  three.setFloor(two.floor());
  for (const auto& of : two.classes())
    three.add(of.name == "planar" ? "flat" : "round", of.histogram, of.prior);
  three.add("rare", two.classes().back().histogram, 1e-6);
  ShapeLabeling<PointXYZ> labeling;
  labeling.setModel(three);
  EXPECT_EQ(labeling.getClasses(),
            (std::vector<std::string>{"flat", "round", "rare", "edge"}));
  labeling.setInputCloud(cloud_);
  PointLabels labels;
  labeling.label(labels);
  const auto count = [&](std::uint32_t label) {
    return std::count(labels.labels.begin(), labels.labels.end(), label);
  };
  EXPECT_GT(count(1), 10000);
  EXPECT_GT(count(4), 100);
  EXPECT_EQ(count(3), 0);
  EXPECT_EQ(count(5), 0);
}

TEST_F(OneScene, ConfidenceFollowsTheNamesOfClasses)
{
  const ShapeModel& usual = ShapeModel::defaultSurfaces();
  const auto confidencesWith = [&](const char* first, const char* second) {
    ShapeModel model(usual.parameters());
    model.setSmoothing(usual.smoothing());
    model.setFloor(usual.floor());
    model.add(first, usual.classes()[0].histogram, usual.classes()[0].prior);
    model.add(second, usual.classes()[1].histogram, usual.classes()[1].prior);
    ShapeLabeling<PointXYZ> labeling;
    labeling.setModel(model);
    labeling.setConfidence(0.0);
    labeling.setInputCloud(cloud_);
    PointLabels labels;
    labeling.label(labels);
    return labels;
  };
  EXPECT_EQ(labels_.confidence, confidencesWith("planar", "curved").confidence);
  // Neither is planar and curved, so that both take the likelihoods of the model alone.
  const PointLabels half_named = confidencesWith("planar", "round");
  const PointLabels named = confidencesWith("flat", "round");
  std::size_t flat = 0, others_differ = 0, flat_differ = 0;
  for (std::size_t i = 0; i < named.labels.size(); ++i) {
    const bool is_flat = named.labels[i] == 1;
    flat += is_flat ? 1 : 0;
    const bool differs = named.confidence[i] != half_named.confidence[i];
    flat_differ += is_flat && differs ? 1 : 0;
    others_differ += !is_flat && differs ? 1 : 0;
  }
  EXPECT_GT(flat, 10000U);
  EXPECT_GT(flat_differ, flat / 2);
  EXPECT_EQ(0U, others_differ);
}

TEST_F(OneScene, BadSettingsAreRefused)
{
  const auto refusal = [&](const auto& prepare) {
    ShapeLabeling<PointXYZ> labeling;
    labeling.setInputCloud(cloud_);
    prepare(labeling);
    PointLabels labels{{1}, {1.0f}};
    const std::string error = errorsOf([&] { labeling.label(labels); });
    EXPECT_TRUE(labels.labels.empty() && labels.confidence.empty());
    return error;
  };
  using Labeling = ShapeLabeling<PointXYZ>;
  const auto expect = [&](const auto& prepare, const std::string& words) {
    const std::string error = refusal(prepare);
    EXPECT_NE(error.find(words), std::string::npos) << error;
    EXPECT_NE(error.find("[pcl::ShapeLabeling::label]"), std::string::npos) << error;
  };
  expect([](Labeling& l) { l.setInputCloud(nullptr); }, "setInputCloud");
  expect([](Labeling& l) { l.setInputCloud(pcl::make_shared<Cloud>()); }, "empty");
  expect([](Labeling& l) { l.setConfidence(1.5); }, "it must be 0 to 1");
  expect([](Labeling& l) { l.setConfidence(std::numeric_limits<double>::quiet_NaN()); },
         "it must be 0 to 1");
  expect([](Labeling& l) { l.setIndices(pcl::make_shared<Indices>(1, 1 << 20)); },
         std::to_string(1 << 20));
  expect([](Labeling& l) { l.setModel(ShapeModel::idealPlane(INADParameters())); },
         "DENSITY mode");
  ShapeModel one(ShapeModel::defaultSurfaces().parameters());
  one.add("planar", ShapeModel::defaultSurfaces().classes()[0].histogram);
  expect([&](Labeling& l) { l.setModel(one); }, "has 1 classes: use one with several");
  expect([](Labeling& l) { l.setModel(ShapeModel::defaultEdges()); }, "edge");
}

TEST(ShapeLabeling, AFewPointsAreVoid)
{
  const auto cloud = pcl::make_shared<Cloud>();
  cloud->push_back(PointXYZ(0, 0, 1));
  cloud->push_back(PointXYZ(1, 0, 1));
  EXPECT_EQ(labelsOf(cloud).labels, (Labels{0, 0}));
}

} // namespace
