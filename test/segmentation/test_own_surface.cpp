/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "detection_scenes.h"

#include <pcl/features/inad.h>
#include <pcl/features/normal_3d_sweep.h>
#include <pcl/segmentation/shape_back_projection.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace pcl;
using namespace pcl::test;

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
