/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "scene/scene.h"
#include "scene/surface_samples.h"
#include "support/clouds.h"
#include "support/errors.h"

#include <pcl/features/inad.h>
#include <pcl/features/normal_3d_sweep.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/shape_back_projection.h>
#include <pcl/segmentation/shape_edge_detection.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace {

using namespace pcl;
using namespace pcl::test;
using Cloud = PointCloud<PointXYZ>;
using Labels = std::vector<std::uint32_t>;
using Likelihoods = std::vector<std::vector<float>>;

Cloud::Ptr
cloudOf(const scene::Scene& scene)
{
  const auto cloud = make_shared<Cloud>(scene.width, scene.height);
  for (std::size_t i = 0; i < cloud->size(); ++i) {
    (*cloud)[i].getVector3fMap() = Eigen::Map<const Eigen::Vector3f>(&scene.xyz[3 * i]);
  }
  cloud->is_dense = false;
  return cloud;
}

scene::Scene
cameraScene(std::uint64_t seed, scene::Noise noise = scene::Noise::Kinect)
{
  scene::SceneOptions options;
  options.seed = seed;
  options.noise = noise;
  return scene::generateScene(options);
}

scene::Scene
sampledScene(std::uint64_t seed)
{
  scene::SampleOptions options;
  options.seed = seed;
  options.objects = 2;
  return scene::sampleScene(options);
}

template <typename Detection>
Likelihoods
likelihoodsOf(Detection& detection, const Cloud::Ptr& cloud)
{
  detection.setInputCloud(cloud);
  Likelihoods likelihoods;
  detection.compute(likelihoods);
  return likelihoods;
}

std::vector<float>
edgesOf(const Cloud::Ptr& cloud, unsigned threads = 0)
{
  ShapeEdgeDetection<PointXYZ> detection;
  detection.setNumberOfThreads(threads);
  return likelihoodsOf(detection, cloud).at(0);
}

/** \brief F1 of one label against those of `others`; unknown counts as negative. */
double
f1(const std::vector<float>& likelihood,
   const Labels& truth,
   std::uint32_t label,
   std::uint32_t others)
{
  double hits = 0, misses = 0, false_alarms = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const bool is_found = likelihood[i] > 0.5f;
    hits += truth[i] == label && is_found ? 1 : 0;
    misses += truth[i] == label && !is_found ? 1 : 0;
    false_alarms += truth[i] == others && is_found ? 1 : 0;
  }
  return 2 * hits / (2 * hits + misses + false_alarms);
}

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
  for (PointXYZ& point : *large) {
    point.getVector3fMap() *= 1024.0f;
  }
  Indices order(cloud->size());
  std::iota(order.begin(), order.end(), 0);
  Random random(5);
  for (std::size_t i = order.size(); i > 1; --i) {
    std::swap(order[i - 1], order[random.index(i)]);
  }
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
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(expected[static_cast<std::size_t>((*indices)[i])], some[0][i]);
  }

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
  for (std::size_t i = 0; i < listed.size(); ++i) {
    same += (listed[i] > 0.5f) == (expected[i] > 0.5f) ? 1 : 0;
  }
  EXPECT_GE(static_cast<double>(same), 0.999 * static_cast<double>(listed.size()));
}

TEST(AdaptiveDetection, GivenRadiiMakeItThePapersMethod)
{
  ShapeEdgeDetection<PointXYZ> detection;
  EXPECT_TRUE(detection.isAdaptive());
  detection.setRadius(0.006);
  EXPECT_FALSE(detection.isAdaptive());
  ShapeEdgeDetection<PointXYZ> fixed;
  fixed.setRadiusMode(ShapeEdgeDetection<PointXYZ>::FIXED);
  EXPECT_FALSE(fixed.isAdaptive());
  EXPECT_EQ(0.015, fixed.getParameters().normal_radius);
  ShapeEdgeDetection<PointXYZ> paper;
  paper.setMode(ShapeEdgeDetection<PointXYZ>::PAPER);
  EXPECT_FALSE(paper.isAdaptive());
}

/** \brief A random point on a cube's surface, of side 1. */
SurfacePoint
onCube(Random& random)
{
  const std::size_t axis = random.index(3);
  Eigen::Vector3d p(random.uniform(), random.uniform(), random.uniform());
  Eigen::Vector3d n = Eigen::Vector3d::Zero();
  const double side = random.uniform() < 0.5 ? 0.0 : 1.0;
  p[static_cast<Eigen::Index>(axis)] = side;
  n[static_cast<Eigen::Index>(axis)] = 2.0 * side - 1.0;
  return {p, n};
}

TEST(EdgeTypes, CornersAreWhereCreasesMeet)
{
  Random random(81);
  const Surface cube = sampled(30000, random, onCube);
  ShapeEdgeDetection<PointXYZ> detection;
  detection.setInputCloud(toCloud<PointXYZ>(cube));
  Edges edges;
  detection.detect(edges);
  ASSERT_EQ(cube.size(), edges.types.size());
  ASSERT_GT(edges.creases.size(), 100U);
  std::size_t corners = 0, far_corners = 0, boundary = 0;
  for (std::size_t i = 0; i < cube.size(); ++i) {
    const Eigen::Array3d p = cube.position(i).array();
    const double to_corner = (p - p.round()).matrix().norm();
    corners += edges.types[i] == EdgeType::Corner ? 1 : 0;
    far_corners += edges.types[i] == EdgeType::Corner && to_corner > 0.1 ? 1 : 0;
    boundary += edges.types[i] == EdgeType::OpenBoundary ? 1 : 0;
  }
  EXPECT_GT(corners, 8U * 5U);
  EXPECT_LT(far_corners, corners / 10);
  EXPECT_LT(boundary, cube.size() / 100);
  std::size_t right_angles = 0;
  for (const CreasePoint& crease : edges.creases) {
    right_angles += std::abs(crease.angle - pi / 2) < 0.1 ? 1 : 0;
  }
  EXPECT_GT(static_cast<double>(right_angles),
            0.9 * static_cast<double>(edges.creases.size()));
}

TEST(EdgeTypes, TheRimOfASheetIsAnOpenBoundary)
{
  Random random(82);
  const Surface sheet = plane(10000, 1.0, random);
  ShapeEdgeDetection<PointXYZ> detection;
  detection.setInputCloud(toCloud<PointXYZ>(sheet));
  Edges edges;
  detection.detect(edges);
  std::size_t rim = 0, on_rim = 0, inside = 0, on_inside = 0;
  for (std::size_t i = 0; i < sheet.size(); ++i) {
    const Eigen::Vector3d p = sheet.position(i);
    const double to_rim =
        std::min(std::min(p.x(), 1.0 - p.x()), std::min(p.y(), 1.0 - p.y()));
    ASSERT_NE(EdgeType::Crease, edges.types[i]);
    const bool is_boundary = edges.types[i] == EdgeType::OpenBoundary;
    rim += to_rim < 0.002 ? 1 : 0; // a tenth of the spacing
    on_rim += to_rim < 0.002 && is_boundary ? 1 : 0;
    inside += to_rim > 0.03 ? 1 : 0;
    on_inside += to_rim > 0.03 && is_boundary ? 1 : 0;
  }
  EXPECT_GT(static_cast<double>(on_rim), 0.95 * static_cast<double>(rim));
  EXPECT_LT(static_cast<double>(on_inside), 0.01 * static_cast<double>(inside));
}

TEST(EdgeTypes, NeedTheDefaultMode)
{
  ShapeEdgeDetection<PointXYZ> detection;
  detection.setInputCloud(toCloud<PointXYZ>(grid(10, 0.004)));
  detection.setRadius(0.01);
  Edges edges;
  expectParts(errorsOf([&] { detection.detect(edges); }),
              {"detect", "DEFAULT", "radii"});
  EXPECT_TRUE(edges.types.empty());
}

Surface
torus(std::size_t count, Random& random)
{
  constexpr double large = 0.05, small = 0.02;
  return sampled(count, random, [](Random& r) {
    for (;;) {
      const double u = r.uniform(0, 2 * pi), v = r.uniform(0, 2 * pi);
      const double radius = large + small * std::cos(v);
      if (r.uniform(0, large + small) > radius) {
        continue; // as much of each piece as it is large
      }
      const Eigen::Vector3d n(
          std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v));
      const Eigen::Vector3d p(
          radius * std::cos(u), radius * std::sin(u), small * std::sin(v));
      return SurfacePoint{p, n};
    }
  });
}

/** \brief A histogram of a whole surface, as pcl_shape_histogram makes it. */
ShapeHistogram
histogramOf(const Surface& surface, const INADParameters& parameters)
{
  const auto cloud = toCloud<PointXYZ>(surface);
  NormalEstimationSweep<PointXYZ, Normal> normal_estimation;
  normal_estimation.setInputCloud(cloud);
  normal_estimation.setRadiusMode(parameters.radius_mode);
  normal_estimation.setRadiusSearch(parameters.normal_radius);
  const auto normals = make_shared<PointCloud<Normal>>();
  normal_estimation.compute(*normals);
  INADEstimation<PointXYZ, Normal> estimation;
  estimation.setInputCloud(cloud);
  estimation.setInputNormals(normals);
  estimation.setRadiusMode(parameters.radius_mode);
  estimation.setRadiusSearch(parameters.radius);
  PointCloud<INAD> inad;
  estimation.compute(inad);
  ShapeHistogram histogram(40, 40, pi / 3, pi / 6);
  histogram.add(inad);
  return histogram;
}

TEST(AdaptiveDetection, AnySurfaceCanBeASample)
{
  Random random(83);
  INADParameters parameters;
  parameters.normal_radius = 2.0;
  parameters.radius = 3.0;
  parameters.radius_mode = AdaptiveRadius::DENSITY;
  ShapeModel model(parameters);
  model.setSmoothing(1.0);
  model.setFloor(3e-4);
  constexpr double density = 250000; // per square metre
  const auto points = [](double area) {
    return static_cast<std::size_t>(density * area);
  };
  model.add("torus", histogramOf(torus(points(0.0395), random), parameters));
  ShapeHistogram others = histogramOf(plane(points(0.04), 0.2, random), parameters);
  others.merge(histogramOf(sphere(points(0.0804), 0.08, random), parameters));
  model.add("other", others);

  Surface scene = torus(points(0.0395), random);
  const std::size_t torus_points = scene.size();
  Surface ball = sphere(points(0.0804), 0.08, random);
  ball.move(Eigen::Isometry3d(Eigen::Translation3d(0.4, 0, 0)));
  scene.append(ball);
  Surface sheet = plane(points(0.04), 0.2, random);
  sheet.move(Eigen::Isometry3d(Eigen::Translation3d(-0.5, 0, 0)));
  scene.append(sheet);

  ShapeBackProjection<PointXYZ> projection;
  projection.setModel(model);
  const auto likelihoods = likelihoodsOf(projection, toCloud<PointXYZ>(scene));
  Labels truth(scene.size(), 0);
  std::fill_n(truth.begin(), torus_points, 1U);
  EXPECT_GE(f1(likelihoods.at(0), truth, 1, 0), 0.95);
}

} // namespace
