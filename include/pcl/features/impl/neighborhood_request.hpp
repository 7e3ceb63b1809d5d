/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/features/neighborhood_sweep.h>
#include <pcl/point_cloud.h>
#include <pcl/types.h>

#include <cstddef>
#include <functional>
#include <string>

namespace pcl::detail {

/** \brief Where neighbors are looked for, and how. */
struct NeighborhoodRequest {
  XYZView input;
  XYZView surface;
  const pcl::Indices* indices = nullptr; ///< of the input
  double radius = 0.0;                   ///< metres, 0 if k is given
  int k = 0;                             ///< 0 if the radius is given
};

/** \brief What is wrong with a request: names the parameter, its value, and what is
 * allowed. Empty if nothing is. */
PCL_SHAPE_EXPORTS std::string problemOf(const NeighborhoodRequest& request);

/** \brief As above, for one value per surface point. */
PCL_SHAPE_EXPORTS std::string problemOfNormals(std::size_t normals,
                                               std::size_t surface);

PCL_SHAPE_EXPORTS std::string problemOfOutlierRate(double rate);

PCL_SHAPE_EXPORTS bool allFinite(const XYZView& points);

PCL_SHAPE_EXPORTS std::size_t countFinite(const XYZView& points);

/** \brief body(begin, end) for consecutive parts of [0, count).
 * \param[in] threads 0 for all cores */
PCL_SHAPE_EXPORTS void
forEachPart(std::size_t count,
            unsigned threads,
            const std::function<void(std::size_t, std::size_t)>& body);

/** \brief The coordinates of a cloud, in place. */
template <typename PointT>
XYZView
xyzOf(const pcl::PointCloud<PointT>& cloud)
{
  static_assert(sizeof(PointT) % sizeof(float) == 0, "points must be rows of floats");
  return {cloud.empty() ? nullptr : &cloud[0].x,
          sizeof(PointT) / sizeof(float),
          cloud.size()};
}

/** \brief The normals of a cloud, in place. */
template <typename PointNT>
XYZView
normalsOf(const pcl::PointCloud<PointNT>& cloud)
{
  static_assert(sizeof(PointNT) % sizeof(float) == 0, "points must be rows of floats");
  return {cloud.empty() ? nullptr : &cloud[0].normal_x,
          sizeof(PointNT) / sizeof(float),
          cloud.size()};
}

} // namespace pcl::detail
