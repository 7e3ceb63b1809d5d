/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "detection_scenes.h"
#include "support/errors.h"

#include <pcl/common/point_tests.h>
#include <pcl/segmentation/shape_labeling.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

// Labels for training on scenes with truth. The floors are what the labels are for: of
// those kept .99 right, .80 of the points kept; of each class precision .95, recall .5.
namespace {

using namespace pcl;
using namespace pcl::test;

constexpr std::uint32_t planar = 1, curved = 2, edge = 3;

PointLabels
labelsOf(const Cloud::ConstPtr& cloud, double confidence = -1.0, unsigned threads = 0)
{
  ShapeLabeling<PointXYZ> labeling;
  labeling.setInputCloud(cloud);
  labeling.setNumberOfThreads(threads);
  if (confidence >= 0.0) {
    labeling.setConfidence(confidence);
  }
  PointLabels labels;
  labeling.label(labels);
  return labels;
}

/** \brief Planar 1, curved 2, edge 3; 0 where the truth leaves it open. */
Labels
truthOf(const scene::Scene& scene)
{
  Labels truth(scene.edge.size(), 0);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (scene.edge[i] == scene::EdgeCrease) {
      truth[i] = edge;
    }
    else if (scene.edge[i] == scene::EdgeNot && scene.surface[i] <= curved) {
      truth[i] = scene.surface[i];
    }
  }
  return truth;
}

struct Quality {
  double points = 0, kept = 0, right = 0;
  std::array<double, 4> truths{}, labelled{}, hits{};

  void
  add(const Labels& truth, const PointLabels& labels)
  {
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const std::uint32_t label = labels.labels[i];
      if (truth[i] == 0) {
        continue;
      }
      points += 1;
      truths[truth[i]] += 1;
      kept += label != 0 ? 1 : 0;
      labelled[label] += 1;
      hits[label] += label == truth[i] ? 1 : 0;
    }
    right = hits[planar] + hits[curved] + hits[edge];
  }

  void
  expectGood() const
  {
    EXPECT_GE(right / kept, 0.99);
    EXPECT_GE(kept / points, 0.80);
    for (const std::uint32_t label : {planar, curved, edge}) {
      EXPECT_GE(hits[label] / labelled[label], 0.95) << "label " << label;
      EXPECT_GE(hits[label] / truths[label], 0.5) << "label " << label;
    }
  }
};

TEST(ShapeLabeling, KeepsRightLabelsOfCameraScenes)
{
  Quality all;
  for (const std::uint64_t seed : {71, 72, 73}) {
    const scene::Scene scene = cameraScene(seed);
    all.add(truthOf(scene), labelsOf(cloudOf(scene)));
  }
  all.expectGood();
}

TEST(ShapeLabeling, ConfidenceIsTheShareOfRightLabels)
{
  std::array<double, 5> limits{0.0, 0.7, 0.9, 0.97, 1.01};
  std::array<double, 4> count{}, sum{}, right{};
  for (const std::uint64_t seed : {76, 77}) {
    const scene::Scene scene = cameraScene(seed);
    const Labels truth = truthOf(scene);
    const PointLabels labels = labelsOf(cloudOf(scene), 0.0);
    for (std::size_t i = 0; i < truth.size(); ++i) {
      if (truth[i] == 0 || labels.labels[i] == 0) {
        continue;
      }
      const auto bin = static_cast<std::size_t>(
          std::upper_bound(limits.begin(), limits.end(), labels.confidence[i]) -
          limits.begin() - 1);
      count[bin] += 1;
      sum[bin] += labels.confidence[i];
      right[bin] += labels.labels[i] == truth[i] ? 1 : 0;
    }
  }
  for (std::size_t bin = 0; bin < count.size(); ++bin) {
    ASSERT_GT(count[bin], 100);
    EXPECT_NEAR(right[bin] / count[bin], sum[bin] / count[bin], 0.15) << bin;
    if (bin > 0) {
      EXPECT_GT(right[bin] / count[bin], right[bin - 1] / count[bin - 1]);
    }
  }
}

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
    for (std::size_t i = 0; i < labels_.labels.size(); ++i) {
      different += labels.at(i) != labels_.labels[i] ? 1 : 0;
    }
    return different;
  }

  static Cloud::Ptr cloud_; // organized, with NaN
  static PointLabels labels_;
};

Cloud::Ptr OneScene::cloud_;
PointLabels OneScene::labels_;

TEST_F(OneScene, OneLabelAPointAndVoidBelowTheConfidence)
{
  ASSERT_EQ(labels_.labels.size(), cloud_->size());
  ASSERT_EQ(labels_.confidence.size(), cloud_->size());
  for (std::size_t i = 0; i < cloud_->size(); ++i) {
    ASSERT_LE(labels_.labels[i], edge);
    ASSERT_EQ(labels_.labels[i] != 0,
              labels_.confidence[i] >= static_cast<float>(detail::usual_confidence));
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
  for (PointXYZ& point : *large) {
    point.getVector3fMap() *= 1024.0f;
  }
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
  for (const auto& of : two.classes()) {
    three.add(of.name == "planar" ? "flat" : "round", of.histogram, of.prior);
  }
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
  expect([](Labeling& l) { l.setConfidence(1.5); }, "0 to 1 is allowed");
  expect([](Labeling& l) { l.setConfidence(std::numeric_limits<double>::quiet_NaN()); },
         "0 to 1 is allowed");
  expect([](Labeling& l) { l.setIndices(pcl::make_shared<Indices>(1, 1 << 20)); },
         std::to_string(1 << 20));
  expect([](Labeling& l) { l.setModel(ShapeModel::idealPlane(INADParameters())); },
         "several classes");
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
