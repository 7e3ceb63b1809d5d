// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The default mode: accuracy, independence of unit, order and threads, its settings.

#include "detection_scenes.h"
#include "support/errors.h"

#include <pcl/search/kdtree.h>
#include <pcl/segmentation/shape_back_projection.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace {

using namespace pcl;
using namespace pcl::test;

TEST(AdaptiveDetection, EdgesOfADepthCamera)
{
  const scene::Scene scene = cameraScene(21);
  EXPECT_GE(f1(edgesOf(cloudOf(scene)), scene.edge, 1, 0), 0.90);
}

TEST(AdaptiveDetection, EdgesOfExactSurfaces)
{
  const scene::Scene scene = sampledScene(22);
  EXPECT_GE(f1(edgesOf(cloudOf(scene)), scene.edge, 1, 0), 0.80);
}

TEST(AdaptiveDetection, PlanarAndCurvedSurfaces)
{
  const scene::Scene scene = cameraScene(23);
  ShapeBackProjection<PointXYZ> projection;
  const auto likelihoods = likelihoodsOf(projection, cloudOf(scene));
  ASSERT_EQ((std::vector<std::string>{"planar", "curved"}), projection.getClasses());
  EXPECT_GE(f1(likelihoods[0], scene.surface, 1, 2), 0.99);
  EXPECT_GE(f1(likelihoods[1], scene.surface, 2, 1), 0.92);
}

TEST(AdaptiveDetection, TheUnitTheOrderAndTheThreadsDoNotMatter)
{
  const auto cloud = cloudOf(sampledScene(24));
  const std::vector<float> expected = edgesOf(cloud, 1);
  EXPECT_TRUE(sameBits(expected, edgesOf(cloud, 3)));

  const auto large = pcl::make_shared<Cloud>(*cloud);
  for (PointXYZ& point : *large)
    point.getVector3fMap() *= 1024.0f;
  Indices order(cloud->size());
  std::iota(order.begin(), order.end(), 0);
  Random random(5);
  for (std::size_t i = order.size(); i > 1; --i)
    std::swap(order[i - 1], order[random.index(i)]);
  const auto shuffled = pcl::make_shared<Cloud>(*cloud, order);
  const std::vector<float> of_large = edgesOf(large);
  const std::vector<float> of_shuffled = edgesOf(shuffled);
  std::size_t same_large = 0, same_shuffled = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto from = static_cast<std::size_t>(order[i]);
    same_large += std::abs(of_large[i] - expected[i]) < 1e-3f ? 1 : 0;
    same_shuffled += std::abs(of_shuffled[i] - expected[from]) < 1e-3f ? 1 : 0;
  }
  EXPECT_GE(static_cast<double>(same_large), 0.998 * static_cast<double>(order.size()));
  EXPECT_GE(static_cast<double>(same_shuffled),
            0.998 * static_cast<double>(order.size()));
}

TEST(AdaptiveDetection, IndicesAnotherInputAndASearchMethod)
{
  const auto cloud = cloudOf(sampledScene(25));
  const std::vector<float> expected = edgesOf(cloud);
  ShapeEdgeDetection<PointXYZ> detection;
  const auto indices = indicesOf({7, 3, 3, 1000});
  detection.setInputCloud(cloud);
  detection.setIndices(indices);
  Likelihoods some;
  detection.compute(some);
  ASSERT_EQ(4U, some.at(0).size());
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_EQ(expected[static_cast<std::size_t>((*indices)[i])], some[0][i]);

  const auto queries = make_shared<Cloud>();
  queries->push_back((*cloud)[7]);
  queries->push_back(PointXYZ(9, 9, 9));
  ShapeEdgeDetection<PointXYZ> other;
  other.setSearchSurface(cloud);
  const auto of_queries = likelihoodsOf(other, queries);
  EXPECT_EQ(expected[7], of_queries[0][0]);
  EXPECT_TRUE(std::isnan(of_queries[0][1]));

  ShapeEdgeDetection<PointXYZ> searched;
  searched.setSearchMethod(make_shared<search::KdTree<PointXYZ>>(false));
  const auto listed = likelihoodsOf(searched, cloud)[0];
  std::size_t same = 0;
  for (std::size_t i = 0; i < listed.size(); ++i)
    same += (listed[i] > 0.5f) == (expected[i] > 0.5f) ? 1 : 0;
  EXPECT_GE(static_cast<double>(same), 0.999 * static_cast<double>(listed.size()));
}

TEST(AdaptiveDetection, GivenRadiiNeedThePapersMethod)
{
  using Detection = ShapeEdgeDetection<PointXYZ>;
  const auto cloud = cloudOf(sampledScene(3));
  Detection detection;
  EXPECT_EQ(Detection::DEFAULT, detection.getMode());
  detection.setRadius(0.006);
  EXPECT_EQ(Detection::DEFAULT, detection.getMode());
  Likelihoods found(1);
  expectParts(errorsOf([&] { found = likelihoodsOf(detection, cloud); }),
              {"a radius is set", "setMode(PAPER)"});
  EXPECT_TRUE(found.empty());
  detection.setMode(Detection::PAPER);
  EXPECT_EQ("", errorsOf([&] { found = likelihoodsOf(detection, cloud); }));
  EXPECT_EQ(2U, found.size());
  Detection fixed;
  fixed.setMode(Detection::PAPER);
  fixed.setRadiusMode(Detection::FIXED);
  EXPECT_EQ(0.015, fixed.getParameters().normal_radius);
}

ShapeField::Ptr
fieldOf(ShapeFieldEstimation<PointXYZ>& estimation, const Cloud::Ptr& cloud)
{
  const auto field = make_shared<ShapeField>();
  estimation.setInputCloud(cloud);
  EXPECT_TRUE(estimation.compute(*field));
  return field;
}

TEST(AdaptiveDetection, SurfacesInOneGoAreThoseOfBothDetectors)
{
  const auto cloud = cloudOf(cameraScene(20));
  const auto some = make_shared<Indices>();
  for (index_t i = 0; i < static_cast<index_t>(cloud->size()); i += 7)
    some->push_back(i);
  ShapeBackProjection<PointXYZ> detection;
  detection.setIndices(some);
  const Likelihoods expected = likelihoodsOf(detection, cloud);
  ShapeFieldEstimation<PointXYZ> estimation;
  estimation.setIndices(some);
  const ShapeField::Ptr field = fieldOf(estimation, cloud);
  const std::vector<float> edges = edgesOf(cloud);
  ASSERT_EQ(field->likelihoods.size(), 2u);
  ASSERT_EQ(field->normals.size(), cloud->size());
  ASSERT_EQ(field->spacings.size(), cloud->size());
  ASSERT_EQ(field->edge_likelihood.size(), cloud->size());
  std::size_t known = 0, with_edges = 0;
  for (std::size_t i = 0; i < some->size(); ++i) {
    const auto at = static_cast<std::size_t>((*some)[i]);
    const bool is_known = !std::isnan(expected[0][i]);
    EXPECT_EQ(std::isnan(field->likelihoods[0][at]), !is_known);
    EXPECT_EQ(std::isnan(field->edge_likelihood[at]), std::isnan(edges[at]));
    if (!is_known)
      continue;
    ++known;
    EXPECT_EQ(field->likelihoods[0][at], expected[0][i]);
    EXPECT_EQ(field->likelihoods[1][at], expected[1][i]);
    // A surface is known where the neighborhood of an edge is too small, too.
    if (std::isnan(edges[at]))
      continue;
    EXPECT_EQ(field->edge_likelihood[at], edges[at]);
    ++with_edges;
    EXPECT_NEAR(field->normals[at].norm(), 1.0f, 1e-5f);
    EXPECT_LT(field->normals[at].dot((*cloud)[at].getVector3fMap()), 0.0f);
    EXPECT_GT(field->spacings[at], 0.0f);
  }
  EXPECT_GT(known, some->size() / 2);
  EXPECT_GT(with_edges, known * 99 / 100);
}

TEST(AdaptiveDetection, AFieldNeedsTheDefaultMode)
{
  const auto cloud = cloudOf(sampledScene(3));
  ShapeFieldEstimation<PointXYZ> estimation;
  ShapeBackProjection<PointXYZ> detection;
  detection.setShapeField(fieldOf(estimation, cloud));
  EXPECT_EQ(2U, likelihoodsOf(detection, cloud).size());
  detection.setRadius(0.02);
  EXPECT_TRUE(likelihoodsOf(detection, cloud).empty());
  detection.setMode(ShapeBackProjection<PointXYZ>::PAPER);
  EXPECT_TRUE(likelihoodsOf(detection, cloud).empty());
  detection.setShapeField(nullptr);
  EXPECT_EQ(2U, likelihoodsOf(detection, cloud).size());
}

TEST(AdaptiveDetection, AnErrorGivesAnEmptyField)
{
  ShapeFieldEstimation<PointXYZ> estimation;
  ShapeField field;
  field.noise = 1.0;
  field.normals.resize(3);
  field.likelihoods.resize(2);
  expectParts(errorsOf([&] { EXPECT_FALSE(estimation.compute(field)); }),
              {"[pcl::ShapeFieldEstimation::compute]", "no input cloud is set"});
  EXPECT_TRUE(field.likelihoods.empty());
  EXPECT_TRUE(field.normals.empty());
  EXPECT_EQ(field.noise, 0.0);
}

TEST(AdaptiveDetection, SurfacesMayHaveAnEdgeModelOfTheirOwn)
{
  const auto cloud = cloudOf(sampledScene(26));
  const auto surfacesWith = [&](const ShapeModel& model) {
    ShapeFieldEstimation<PointXYZ> estimation;
    estimation.setEdgeModel(model);
    ShapeBackProjection<PointXYZ> projection;
    projection.setShapeField(fieldOf(estimation, cloud));
    return likelihoodsOf(projection, cloud).at(0);
  };
  ShapeBackProjection<PointXYZ> usual;
  const Likelihoods expected = likelihoodsOf(usual, cloud);
  EXPECT_TRUE(sameBits(expected.at(0), surfacesWith(ShapeModel::defaultEdges())));
  // With the classes exchanged, faces are the edges.
  const ShapeModel& edges = ShapeModel::defaultEdges();
  ShapeModel exchanged(edges.parameters());
  exchanged.setSmoothing(edges.smoothing());
  exchanged.setFloor(edges.floor());
  exchanged.add("edge", edges.classes()[1].histogram);
  exchanged.add("rest", edges.classes()[0].histogram);
  EXPECT_FALSE(sameBits(expected[0], surfacesWith(exchanged)));
}

TEST(AdaptiveDetection, BadEdgeModelsAreRefused)
{
  const auto cloud = cloudOf(sampledScene(26));
  const auto refuse = [&](const ShapeModel& model,
                          const std::vector<std::string>& parts) {
    ShapeFieldEstimation<PointXYZ> estimation;
    estimation.setInputCloud(cloud);
    estimation.setEdgeModel(model);
    ShapeField field;
    expectParts(errorsOf([&] { EXPECT_FALSE(estimation.compute(field)); }), parts);
    EXPECT_TRUE(field.edge_likelihood.empty());
    ShapeEdgeDetection<PointXYZ> detection;
    detection.setModel(model);
    Likelihoods found;
    expectParts(errorsOf([&] { found = likelihoodsOf(detection, cloud); }), parts);
    EXPECT_TRUE(found.empty());
  };
  const ShapeModel& edges = ShapeModel::defaultEdges();
  ShapeModel one(edges.parameters());
  one.add("edge", edges.classes()[0].histogram);
  refuse(one, {"edge model", "1 classes", "two"});
  refuse(ShapeModel::idealPlane(INADParameters::edges()), {"edge model", "DENSITY"});
  ShapeModel meters{INADParameters::edges()};
  meters.add("edge", edges.classes()[0].histogram);
  meters.add("rest", edges.classes()[1].histogram);
  refuse(meters, {"edge model", "DENSITY"});
}

} // namespace
