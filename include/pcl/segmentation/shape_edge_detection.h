/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/segmentation/shape_detection.h>

namespace pcl {

/** \brief Find the edges (creases: lines of high curvature) of an unorganized cloud.
 *
 * A point is an edge point as far as it is not planar at a small radius:
 * P(edge) = 1 - P(plane). The classes are {"edge", "planar"}; a point is an edge if
 * P(plane) < threshold. A model given with setModel() has one class, the plane.
 *
 * Defaults: normals over 15 mm, INAD over 6 mm.
 * \ingroup segmentation
 */
template <typename PointT, typename PointNT = pcl::Normal>
class ShapeEdgeDetection : public ShapeDetection<PointT, PointNT> {
public:
  using Ptr = shared_ptr<ShapeEdgeDetection<PointT, PointNT>>;
  using ConstPtr = shared_ptr<const ShapeEdgeDetection<PointT, PointNT>>;
  using ShapeDetection<PointT, PointNT>::segment;

  ShapeEdgeDetection()
  : ShapeDetection<PointT, PointNT>("ShapeEdgeDetection", INADParameters::edges())
  {}

  std::vector<std::string> getClasses() const override;

  /** \brief The edge points. */
  void segment(pcl::PointIndices& edges);

protected:
  std::string problemOfClasses(const ShapeModel& model) const override;

  void toClasses(const std::vector<float>& values, float* likelihoods) const override;

  std::size_t classOf(const float* likelihoods) const override;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/segmentation/impl/shape_edge_detection.hpp>
#endif
