// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Models made from a sample of any surface.

#include "detection_scenes.h"
#include "features/noise/noise_level.h"

#include <pcl/features/inad.h>
#include <pcl/features/normal_3d_sweep.h>
#include <pcl/segmentation/shape_back_projection.h>
#include <pcl/features/impl/neighborhoods.hpp>

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
      if (r.uniform(0, large + small) > radius)
        continue; // as much of each piece as it is large
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
  constexpr double density = 250000; // per square meter
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

std::vector<float>
likelihoodsWith(const INADParameters& parameters,
                const ShapeHistogram& histogram,
                const Cloud::Ptr& cloud)
{
  ShapeModel model(parameters);
  model.add("ball", histogram);
  ShapeBackProjection<PointXYZ> projection;
  projection.setMode(ShapeBackProjection<PointXYZ>::PAPER);
  projection.setModel(model);
  return likelihoodsOf(projection, cloud).at(0);
}

TEST(AdaptiveDetection, RadiiOfOneClassGrowWithNoise)
{
  Random random(84);
  // So dense that its noise tilts normals by more than it turns in larger radii.
  const Surface ball = sphere(40000, 0.08, random);
  const auto cloud = toCloud<PointXYZ>(ball);
  for (PointXYZ& point : *cloud) {
    point.x += static_cast<float>(random.uniform(-1e-3, 1e-3));
    point.y += static_cast<float>(random.uniform(-1e-3, 1e-3));
    point.z += static_cast<float>(random.uniform(-1e-3, 1e-3));
  }
  INADParameters small;
  small.normal_radius = small.radius = 1.5;
  small.radius_mode = AdaptiveRadius::DENSITY;
  INADParameters growing = small;
  growing.normal_radius_noise = 4.0;
  growing.radius_noise = 6.0;
  const INADParameters grown =
      detail::withNoiseOfCloud(growing, detail::xyzOf(*cloud), 1);
  ASSERT_GT(grown.radius, 1.1 * small.radius);
  const ShapeHistogram histogram = histogramOf(ball, small);
  const auto expected = likelihoodsWith(grown, histogram, cloud);
  EXPECT_TRUE(sameBits(expected, likelihoodsWith(growing, histogram, cloud)));
  EXPECT_FALSE(sameBits(expected, likelihoodsWith(small, histogram, cloud)));
}

} // namespace
