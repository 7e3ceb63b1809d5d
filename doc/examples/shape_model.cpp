/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include <pcl/features/inad.h>
#include <pcl/features/normal_3d_sweep.h>
#include <pcl/features/shape_model.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/shape_back_projection.h>

#include <cmath>
#include <iostream>
#include <random>

// A model of two surfaces, made from samples of them. Usage: shape_model model.json
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

constexpr double radius = 0.025; // metres, of the neighborhoods

/** A plane of 0.4 x 0.4 m, 3 mm between points. */
Cloud::Ptr
samplePlane()
{
  const auto cloud = pcl::make_shared<Cloud>();
  for (int i = 0; i < 400; i += 3) {
    for (int j = 0; j < 400; j += 3) {
      cloud->emplace_back(
          0.001f * static_cast<float>(i), 0.001f * static_cast<float>(j), 1.0f);
    }
  }
  return cloud;
}

/** A cylinder of the given radius (metres), 0.2 m long. */
Cloud::Ptr
sampleCylinder(float cylinder_radius)
{
  const auto cloud = pcl::make_shared<Cloud>();
  std::mt19937 random(1);
  const auto uniform = [&random] {
    return static_cast<float>(random()) / 4294967296.f;
  };
  for (int i = 0; i < 20000; ++i) {
    const float angle = 6.2831853f * uniform();
    cloud->emplace_back(cylinder_radius * std::cos(angle),
                        cylinder_radius * std::sin(angle),
                        0.2f * uniform());
  }
  return cloud;
}

// [histogram]
pcl::ShapeHistogram
histogramOf(const Cloud::ConstPtr& sample)
{
  const auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  pcl::NormalEstimationSweep<pcl::PointXYZ, pcl::Normal> normal_estimation;
  normal_estimation.setInputCloud(sample);
  normal_estimation.setRadiusSearch(radius);
  normal_estimation.compute(*normals);

  pcl::PointCloud<pcl::INAD> inad;
  pcl::INADEstimation<pcl::PointXYZ, pcl::Normal> inad_estimation;
  inad_estimation.setInputCloud(sample);
  inad_estimation.setInputNormals(normals);
  inad_estimation.setRadiusSearch(radius);
  inad_estimation.compute(inad);

  pcl::ShapeHistogram histogram(40, 40); // bins over 0 to pi/2 of mu and of sigma
  histogram.add(inad);
  return histogram;
}
// [histogram]

} // namespace

int
main(int argc, char** argv)
{
  if (argc != 2) {
    std::cerr << "usage: shape_model model.json\n";
    return 1;
  }

  // [model]
  pcl::ShapeModel model({radius, radius, 0, 2.0}); // radii, k, outlier rate
  model.add("plane", histogramOf(samplePlane()));
  model.add("cylinder", histogramOf(sampleCylinder(0.04f)));
  model.save(argv[1]);

  pcl::ShapeBackProjection<pcl::PointXYZ> surfaces;
  surfaces.setModel(pcl::ShapeModel::load(argv[1]));
  surfaces.setInputCloud(sampleCylinder(0.045f));
  std::vector<pcl::PointIndices> classes;
  surfaces.segment(classes);
  // [model]

  const std::vector<std::string> names = surfaces.getClasses();
  for (std::size_t c = 0; c < classes.size(); ++c)
    std::cout << names[c] << ": " << classes[c].indices.size() << " points\n";
  return classes.size() == 2 && classes[1].indices.size() > classes[0].indices.size()
             ? 0
             : 1;
}
