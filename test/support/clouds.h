// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Clouds for tests, and results of the library's classes in vectors.

#pragma once

#include "support/bits.h"
#include "support/shapes.h"

#include <pcl/features/inad_point.h>
#include <pcl/memory.h>
#include <pcl/pcl_base.h>
#include <pcl/point_cloud.h>

#include <cmath>
#include <vector>

namespace pcl {
namespace test {

template <typename PointT>
typename pcl::PointCloud<PointT>::Ptr
toCloud(const Surface& surface)
{
  const auto cloud = pcl::make_shared<pcl::PointCloud<PointT>>();
  for (std::size_t i = 0; i < surface.size(); ++i) {
    PointT point;
    point.getVector3fMap() = surface.position(i).cast<float>();
    cloud->push_back(point);
  }
  return cloud;
}

template <typename PointNT>
typename pcl::PointCloud<PointNT>::Ptr
trueNormalsOf(const Surface& surface)
{
  const auto normals = pcl::make_shared<pcl::PointCloud<PointNT>>();
  for (std::size_t i = 0; i < surface.size(); ++i) {
    PointNT normal;
    normal.getNormalVector3fMap() = surface.normal(i).cast<float>();
    normals->push_back(normal);
  }
  return normals;
}

inline pcl::IndicesPtr
indicesOf(const pcl::Indices& indices)
{
  return pcl::IndicesPtr(new pcl::Indices(indices));
}

/** \brief mu and sigma of all points in one vector. */
inline std::vector<float>
valuesOf(const pcl::PointCloud<pcl::INAD>& cloud)
{
  std::vector<float> values;
  for (const pcl::INAD& inad : cloud)
    values.insert(values.end(), {inad.mu, inad.sigma});
  return values;
}

/** \brief Normals and curvatures of all points in one vector. */
template <typename PointNT>
std::vector<float>
normalValuesOf(const pcl::PointCloud<PointNT>& cloud)
{
  std::vector<float> values;
  for (const PointNT& n : cloud)
    values.insert(values.end(), {n.normal_x, n.normal_y, n.normal_z, n.curvature});
  return values;
}

/** \brief What a depth camera sees of a plane with a ball in front of it: organized,
 * with the projection of a pinhole camera. */
template <typename PointT>
typename pcl::PointCloud<PointT>::Ptr
depthImage(unsigned width, unsigned height)
{
  const auto cloud = pcl::make_shared<pcl::PointCloud<PointT>>(width, height);
  const Eigen::Vector3d center(0.02, -0.01, 0.7);
  constexpr double ball_radius = 0.08;
  for (unsigned v = 0; v < height; ++v) {
    for (unsigned u = 0; u < width; ++u) {
      const Eigen::Vector3d ray(
          (u + 0.5 - width / 2.0) / width, (v + 0.5 - height / 2.0) / width, 1);
      const double wall = 0.8 / (1 + 0.3 * ray.x() + 0.2 * ray.y());
      const double along = ray.dot(center) / ray.squaredNorm();
      const double under =
          ball_radius * ball_radius - (along * ray - center).squaredNorm();
      const double ball = along - std::sqrt(std::max(0.0, under)) / ray.norm();
      (*cloud)(u, v).getVector3fMap() =
          (ray * (under > 0 ? ball : wall)).template cast<float>();
    }
  }
  return cloud;
}

} // namespace test
} // namespace pcl
