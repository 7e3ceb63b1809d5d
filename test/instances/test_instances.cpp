// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Instances: independence of threads, order and unit, settings and their refusal.

#include "instance_scenes.h"
#include "support/errors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace {

using namespace pcl;
using namespace pcl::test;
using scene::Shape;

scene::SceneOptions
optionsOf(const std::vector<Shape>& shapes, unsigned objects)
{
  scene::SceneOptions options;
  options.seed = 31;
  options.objects = objects;
  options.shapes = shapes;
  return options;
}

scene::Scene
smallScene(const std::vector<Shape>& shapes, unsigned objects = 3)
{
  scene::SceneOptions options = optionsOf(shapes, objects);
  options.width = 320;
  options.height = 240;
  return scene::generateScene(options);
}

scene::Scene
fullScene(const std::vector<Shape>& shapes)
{
  return scene::generateScene(optionsOf(shapes, 3));
}

class Instances : public testing::TestWithParam<const char*> {};

TEST_P(Instances, DoNotDependOnThreadsOrOrderOrUnit)
{
  const Cloud::Ptr cloud = cloudOf(smallScene({}, 6));
  const Labels labels = instancesOf(cloud, GetParam(), 1);
  ASSERT_GE(*std::max_element(labels.begin(), labels.end()), 2U);
  EXPECT_EQ(labels, instancesOf(cloud, GetParam(), 3));

  const Indices order = shuffled(cloud->size());
  const Labels of_order = instancesOf(reordered(*cloud, order), GetParam());
  std::size_t same = 0;
  for (std::size_t k = 0; k < order.size(); ++k)
    same += labels[static_cast<std::size_t>(order[k])] == of_order[k] ? 1 : 0;
  EXPECT_GE(same, cloud->size() - cloud->size() / 1000);

  const auto large = make_shared<Cloud>(*cloud);
  for (PointXYZ& point : *large)
    point.getVector3fMap() *= 1024.0f;
  EXPECT_EQ(labels, instancesOf(large, GetParam()));
}

TEST_P(Instances, AreOfTheGivenIndicesOnly)
{
  const Cloud::Ptr cloud = cloudOf(smallScene({}, 6));
  const Labels all = instancesOf(cloud, GetParam());
  Indices half;
  for (std::size_t i = 0; i < cloud->size(); ++i)
    if (i % cloud->width < cloud->width / 2)
      half.push_back(static_cast<index_t>(i));
  ShapeInstanceSegmentation<PointXYZ> segmentation;
  segmentation.setInputCloud(cloud);
  segmentation.setIndices(indicesOf(half));
  segmentation.setClass(GetParam());
  std::vector<ShapeInstance> instances;
  segmentation.segment(instances);
  ASSERT_FALSE(instances.empty());
  for (const ShapeInstance& instance : instances) {
    EXPECT_TRUE(std::is_sorted(instance.indices.begin(), instance.indices.end()));
    EXPECT_TRUE(std::includes(
        half.begin(), half.end(), instance.indices.begin(), instance.indices.end()));
  }
}

INSTANTIATE_TEST_SUITE_P(AllClasses,
                         Instances,
                         testing::Values("curved", "planar", "object"));

TEST(Instances, AreSortedAndDisjointAndLargeEnough)
{
  const Cloud::Ptr cloud = cloudOf(smallScene({}, 6));
  ShapeInstanceSegmentation<PointXYZ> segmentation;
  segmentation.setInputCloud(cloud);
  segmentation.setClass("planar");
  std::vector<PointIndices> usual, large;
  segmentation.segment(usual);
  segmentation.setMinPoints(1000);
  segmentation.segment(large);
  ASSERT_FALSE(large.empty());
  EXPECT_LT(large.size(), usual.size());
  std::vector<bool> seen(cloud->size(), false);
  std::size_t previous = cloud->size();
  for (const PointIndices& instance : usual) {
    EXPECT_LE(instance.indices.size(), previous);
    EXPECT_GE(instance.indices.size(), 100U);
    previous = instance.indices.size();
    for (const index_t i : instance.indices) {
      EXPECT_FALSE(seen[static_cast<std::size_t>(i)]);
      seen[static_cast<std::size_t>(i)] = true;
    }
  }
  for (const PointIndices& instance : large)
    EXPECT_GE(instance.indices.size(), 1000U);
}

TEST(Instances, ObjectsAreSortedByShape)
{
  const std::vector<ShapeInstance> boxes =
      describedIn(cloudOf(fullScene({Shape::Box})), "object");
  ASSERT_EQ(3U, boxes.size());
  for (const ShapeInstance& box : boxes) {
    EXPECT_GE(box.shares.at(0), 0.9f) << "planar";
    EXPECT_NEAR(1.0f, box.shares[0] + box.shares[1], 1e-6f);
  }
  const std::vector<ShapeInstance> balls =
      describedIn(cloudOf(fullScene({Shape::Sphere})), "object");
  ASSERT_EQ(3U, balls.size());
  for (const ShapeInstance& ball : balls)
    EXPECT_GE(ball.shares.at(1), 0.9f) << "curved";
}

TEST(Instances, CentroidIsTheMeanOfThePoints)
{
  const Cloud::Ptr cloud = cloudOf(smallScene({Shape::Cylinder}));
  for (const ShapeInstance& instance : describedIn(cloud, "curved")) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const index_t i : instance.indices)
      sum += (*cloud)[i].getVector3fMap().cast<double>();
    sum /= static_cast<double>(instance.indices.size());
    EXPECT_LT((sum.cast<float>() - instance.centroid).norm(), 1e-5f);
  }
}

TEST(Instances, BadSettingsAreRefused)
{
  const Cloud::Ptr cloud = cloudOf(smallScene({Shape::Box}, 1));
  const auto errorOf = [&](const auto& set) {
    ShapeInstanceSegmentation<PointXYZ> segmentation;
    segmentation.setInputCloud(cloud);
    set(segmentation);
    std::vector<ShapeInstance> instances(1);
    const std::string error =
        errorsOf([&] { EXPECT_FALSE(segmentation.segment(instances)); });
    EXPECT_TRUE(instances.empty());
    return error;
  };
  using Segmentation = ShapeInstanceSegmentation<PointXYZ>;
  expectParts(
      errorOf([](Segmentation& s) { s.setClass("round"); }),
      {"[pcl::ShapeInstanceSegmentation::segment]", "'round'", "planar, curved"});
  expectParts(errorOf([](Segmentation& s) { s.setThresholds(0.4, 0.6); }),
              {"thresholds", "low <= high", "must hold"});
  expectParts(errorOf([](Segmentation& s) {
                s.setThresholds(std::numeric_limits<double>::quiet_NaN(), 0.5);
              }),
              {"thresholds", "must hold"});
  expectParts(errorOf([](Segmentation& s) { s.setMinPoints(0); }),
              {"0", "must be 1 or more"});
  expectParts(errorOf([](Segmentation& s) { s.setModel(ShapeModel::idealPlane()); }),
              {"DENSITY", "use one that was"});
  expectParts(errorOf([](Segmentation& s) { s.setInputCloud(nullptr); }),
              {"no input cloud"});
  expectParts(errorOf([](Segmentation& s) {
                const auto unknown = make_shared<Cloud>(1, 1);
                unknown->front().x = std::numeric_limits<float>::quiet_NaN();
                s.setInputCloud(unknown);
              }),
              {"no finite point"});
}

TEST(Instances, AModelOfOnesOwnHasItsOwnClasses)
{
  ShapeModel model = ShapeModel::defaultSurfaces();
  ShapeInstanceSegmentation<PointXYZ> segmentation;
  segmentation.setModel(model);
  segmentation.setInputCloud(cloudOf(smallScene({Shape::Cylinder})));
  for (const ShapeModel::Class& of : model.classes()) {
    segmentation.setClass(of.name);
    std::vector<PointIndices> instances;
    segmentation.segment(instances);
    EXPECT_FALSE(instances.empty()) << of.name;
  }
}

TEST(Instances, ConvexAndConcaveAreSeenFromTheViewPoint)
{
  const Cloud::Ptr cloud = cloudOf(smallScene({Shape::Box}));
  const auto seenFrom = [&](float x, float y, float z) {
    ShapeInstanceSegmentation<PointXYZ> segmentation;
    segmentation.setInputCloud(cloud);
    segmentation.setClass("object");
    segmentation.setViewPoint(x, y, z);
    std::vector<PointIndices> instances;
    EXPECT_TRUE(segmentation.segment(instances));
    return labelsOf(instances, cloud->size());
  };
  const Labels usual = instancesOf(cloud, "object");
  const Eigen::Vector4f& origin = cloud->sensor_origin_;
  EXPECT_EQ(usual, seenFrom(origin.x(), origin.y(), origin.z()));
  EXPECT_NE(usual, seenFrom(origin.x(), origin.y(), origin.z() + 100.0f));
}

} // namespace
