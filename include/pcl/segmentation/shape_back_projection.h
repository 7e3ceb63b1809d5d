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

/** \brief Classify points by back-projecting shape histograms.
 *
 * DEFAULT mode: the posteriors of "planar" and "curved", or of the classes of a model
 * made in DENSITY mode, from evidence averaged over the neighborhood without crossing
 * edges (see ShapeFieldEstimation).
 *
 * PAPER mode: with one class (by default an ideal plane) its likelihood L is the
 * histogram's value at the point's (mu, sigma) over its largest bin; the classes are
 * {name, "curved" or "other"} with likelihoods L and 1 - L, and a point belongs to the
 * first if L >= threshold. With several classes: the posterior of each; a point belongs
 * to the most probable. The paper's radii: normals and INAD over 25 mm.
 * \ingroup segmentation
 */
template <typename PointT, typename PointNT = pcl::Normal>
class ShapeBackProjection : public ShapeDetection<PointT, PointNT> {
public:
  using Ptr = shared_ptr<ShapeBackProjection<PointT, PointNT>>;
  using ConstPtr = shared_ptr<const ShapeBackProjection<PointT, PointNT>>;

  ShapeBackProjection()
  : ShapeDetection<PointT, PointNT>("ShapeBackProjection", INADParameters::surfaces())
  {}

  std::vector<std::string> getClasses() const override;

protected:
  void toClasses(const std::vector<float>& values, float* likelihoods) const override;

  std::size_t classOf(const float* likelihoods, std::size_t classes) const override;

  std::vector<std::vector<float>> likelihoodsOf(const ShapeField& field) const override;

  const ShapeModel&
  defaultModel() const override
  {
    return ShapeModel::defaultSurfaces();
  }

  std::string problemOfClasses(const ShapeModel& model) const override;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/segmentation/impl/shape_back_projection.hpp>
#endif
