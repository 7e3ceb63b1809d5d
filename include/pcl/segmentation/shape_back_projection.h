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

/** \brief All that is known about the surfaces of a cloud, one entry for each index;
 * creases are those of the whole cloud.
 * \ingroup segmentation */
struct Surfaces {
  std::vector<std::vector<float>> likelihoods; ///< of every class; NaN unknown
  std::vector<float> edge_likelihood;          ///< NaN unknown
  pcl::PointCloud<pcl::Normal> normals;        ///< towards the origin; NaN unknown
  std::vector<float> spacings;                 ///< see AdaptiveRadius, metres
  double noise = 0.0;                          ///< of the cloud, in spacings, 0 to 0.3
  std::vector<CreasePoint> creases;
};

/** \brief With which radius surfaces may curve to be told from planes by the default
 * model: 20 local spacings (of a ball 25), where that is the median. Larger ones are
 * planar. See ShapeDetection::setResolution(). \return metres, 0 if no spacing is known
 * \ingroup segmentation */
PCL_SHAPE_EXPORTS float largestCurvedRadius(const Surfaces& surfaces);

/** \brief Classify points by back-projecting shape histograms.
 *
 * By default (isAdaptive()): the posteriors of "planar" and "curved", or of the classes
 * of a model made in DENSITY mode, from evidence averaged over the neighborhood without
 * crossing edges; radii follow the density.
 *
 * In PAPER mode, or with radii: with one class (by default an ideal plane) its
 * likelihood L is the histogram's value at the point's (mu, sigma) over its largest
 * bin; the classes are {name, "curved" or "other"} with likelihoods L and 1 - L, and a
 * point belongs to the first if L >= threshold. With several classes: the posterior of
 * each; a point belongs to the most probable.
 *
 * The paper's radii: normals and INAD over 25 mm.
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

  /** \brief The model of edges that evidence does not cross, instead of
   * ShapeModel::defaultEdges(): two classes made in DENSITY mode, an edge and the rest.
   * Without isAdaptive() no edges are looked for, and it is an error. */
  void
  setEdgeModel(const ShapeModel& model)
  {
    edge_model_ = model;
  }

  /** \brief The likelihoods of every class, in the order of getClasses(), with the
   * edges, normals and spacings that they were found with, in one go.
   * \param[out] surfaces empty after an error: those of compute(), and settings with
   * which isAdaptive() is false */
  void classify(Surfaces& surfaces);

protected:
  std::string problemOfClasses(const ShapeModel& model) const override;

  void toClasses(const std::vector<float>& values, float* likelihoods) const override;

  std::size_t classOf(const float* likelihoods) const override;

  const ShapeModel&
  defaultModel() const override
  {
    return ShapeModel::defaultSurfaces();
  }

  std::vector<float> adaptiveLikelihoods(const detail::AdaptiveInput& input,
                                         std::vector<float>& spacings) const override;

private:
  std::optional<ShapeModel> edge_model_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/segmentation/impl/shape_back_projection.hpp>
#endif
