/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "pipeline.h"

#include <pcl/features/inad.h>
#include <pcl/features/neighborhood_sweep.h>
#include <pcl/features/normal_3d_sweep.h>
#include <pcl/features/shape_histogram.h>

#include <numeric>

PipelineResult
runShape(const Cloud::ConstPtr& cloud, unsigned threads)
{
  pcl::NormalEstimationSweep<pcl::PointXYZ, pcl::Normal> estimation(threads);
  const auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  estimation.setInputCloud(cloud);
  estimation.setRadiusSearch(normal_radius);
  estimation.compute(*normals);

  PipelineResult result;
  pcl::INADEstimation<pcl::PointXYZ, pcl::Normal> inad_estimation(threads);
  inad_estimation.setInputCloud(cloud);
  inad_estimation.setInputNormals(normals);
  inad_estimation.setOutlierRate(outlier_rate);
  for (std::size_t r = 0; r < inad_radii.size(); ++r) {
    pcl::PointCloud<pcl::INAD> inad;
    inad_estimation.setRadiusSearch(inad_radii[r]);
    inad_estimation.compute(inad);
    pcl::ShapeHistogram histogram(bins, bins);
    histogram.add(inad);
    for (const pcl::INAD& value : inad) {
      result.mu[r].push_back(value.mu);
      result.sigma[r].push_back(value.sigma);
      result.likelihood[r].push_back(histogram.likelihood(value));
    }
  }
  return result;
}

std::uint64_t
countShapeNeighbors(const Cloud& cloud, unsigned threads)
{
  pcl::NeighborhoodSweep sweep(
      {&cloud[0].x, sizeof(cloud[0]) / sizeof(float), cloud.size()});
  sweep.setNumberOfThreads(threads);
  std::vector<std::uint32_t> counts(cloud.size());
  std::uint64_t total = 0;
  for (const double radius : inad_radii) {
    sweep.countNeighbors(pcl::NeighborhoodSize::ofRadius(radius), counts.data());
    total = std::accumulate(counts.begin(), counts.end(), total);
  }
  return total;
}
