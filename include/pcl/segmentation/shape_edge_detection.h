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

/** \brief All that is known about the edges of a cloud. \ingroup segmentation */
struct Edges {
  std::vector<float> likelihood;    ///< one for each index, NaN unknown
  std::vector<EdgeType> types;      ///< one for each index
  std::vector<CreasePoint> creases; ///< of the whole cloud
};

/** \brief Find the edges (creases: lines of high curvature) of an unorganized cloud.
 *
 * DEFAULT mode: points whose INAD speaks for an edge fit two planes to their
 * neighborhood and vote for where these meet; an edge point is near a place that enough
 * votes agree on (see ShapeFieldEstimation). A model given with setModel() has two
 * classes, the first of which is the edge.
 *
 * PAPER mode: a point is an edge point to the degree that it is not planar at a small
 * radius, P(edge) = 1 - P(plane), and a model has one class, the plane; the paper's
 * radii are 15 mm for normals and 6 mm for INAD.
 *
 * The classes are {"edge", "planar"}; a point is an edge if its second likelihood is
 * below the threshold.
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

  /** \brief DEFAULT mode: edges, what kind each is, and where creases run, in one go.
   * Open boundaries are looked for here only. \param[out] edges empty after an error */
  void detect(Edges& edges);

  /** \brief Where creases run, as lines, the longest first: creaseLines() of what
   * detect() gave. \return none after an error, a crease point that is not finite */
  std::vector<CreaseLine> linesOf(const Edges& edges) const;

protected:
  std::string problemOfClasses(const ShapeModel& model) const override;

  void toClasses(const std::vector<float>& values, float* likelihoods) const override;

  std::size_t classOf(const float* likelihoods, std::size_t classes) const override;

  bool
  edgesOnly() const override
  {
    return true;
  }

  std::vector<std::vector<float>> likelihoodsOf(const ShapeField& field) const override;

  const ShapeModel&
  defaultModel() const override
  {
    return ShapeModel::defaultEdges();
  }
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/segmentation/impl/shape_edge_detection.hpp>
#endif
