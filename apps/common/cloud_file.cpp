/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "cloud_file.h"

#include "errors.h"

#include <pcl/common/point_tests.h>

#include <algorithm>

namespace pcl::app {

pcl::PointCloud<pcl::PointXYZ>::Ptr
pointsOf(const CloudFile& cloud)
{
  const std::vector<float> x = floatsOf(cloud, "x");
  const std::vector<float> y = floatsOf(cloud, "y");
  const std::vector<float> z = floatsOf(cloud, "z");
  pcl::PointCloud<pcl::PointXYZ>::Ptr points(
      new pcl::PointCloud<pcl::PointXYZ>(cloud.blob.width, cloud.blob.height));
  for (std::size_t i = 0; i < x.size(); ++i)
    (*points)[i] = pcl::PointXYZ(x[i], y[i], z[i]);
  const auto& v = cloud.viewpoint;
  points->sensor_origin_ = Eigen::Vector4f(v[0], v[1], v[2], 0.0f);
  points->sensor_orientation_ = Eigen::Quaternionf(v[3], v[4], v[5], v[6]);
  const std::size_t finite = countFinite(*points);
  if (finite == 0)
    throw InputError(cloud.path + ": none of its " + std::to_string(points->size()) +
                     " points is finite: allowed is a cloud with at least one");
  points->is_dense = finite == points->size();
  return points;
}

std::size_t
countFinite(const pcl::PointCloud<pcl::PointXYZ>& points)
{
  return static_cast<std::size_t>(
      std::count_if(points.begin(), points.end(), [](const pcl::PointXYZ& point) {
        return pcl::isXYZFinite(point);
      }));
}

pcl::PointCloud<pcl::Normal>::Ptr
normalsOf(const CloudFile& cloud)
{
  const std::vector<float> x = floatsOf(cloud, "normal_x");
  const std::vector<float> y = floatsOf(cloud, "normal_y");
  const std::vector<float> z = floatsOf(cloud, "normal_z");
  pcl::PointCloud<pcl::Normal>::Ptr normals(
      new pcl::PointCloud<pcl::Normal>(cloud.blob.width, cloud.blob.height));
  normals->is_dense = false;
  for (std::size_t i = 0; i < x.size(); ++i)
    (*normals)[i] = pcl::Normal(x[i], y[i], z[i]);
  if (findField(cloud, "curvature")) {
    const std::vector<float> curvature = floatsOf(cloud, "curvature");
    for (std::size_t i = 0; i < curvature.size(); ++i)
      (*normals)[i].curvature = curvature[i];
  }
  return normals;
}

} // namespace pcl::app
