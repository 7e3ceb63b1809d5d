/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/segmentation/label_confidence.h>
#include <pcl/segmentation/shape_back_projection.h>

namespace pcl {

/** \brief Label the points of a cloud to train others with: planar, curved and edge, or
 * the classes of a model and edge, each with a confidence; void where it is low.
 *
 * Edges and surfaces are those of ShapeBackProjection::classify(). The confidence
 * estimates how probable it is that the label is right: see doc/labels.md. Labels are
 * numbers, 0 void, then the classes in the order of getClasses().
 *
 * Neighbors are found among all points of the input, also if indices are set.
 * Errors (those of ShapeBackProjection; a confidence out of [0, 1]; a model for which
 * ShapeBackProjection::isAdaptive() is false, or with a class called edge) are reported
 * by PCL_ERROR and give empty outputs. \ingroup segmentation
 */
template <typename PointT, typename PointNT = pcl::Normal>
class ShapeLabeling : public PCLBase<PointT> {
public:
  using Ptr = shared_ptr<ShapeLabeling<PointT, PointNT>>;
  using ConstPtr = shared_ptr<const ShapeLabeling<PointT, PointNT>>;
  using SearchPtr = typename pcl::search::Search<PointT>::Ptr;

  /** \brief Points of less confidence are void; in [0, 1], 0.9 by default
   * (detail::usual_confidence). With 0 every point has a label whose class is known. */
  void
  setConfidence(double confidence)
  {
    confidence_ = confidence;
  }

  double
  getConfidence() const
  {
    return confidence_;
  }

  /** \brief Other surfaces than planar and curved: a model of several classes made in
   * DENSITY mode. The confidence is calibrated for planar and curved ones. */
  void
  setModel(const ShapeModel& model)
  {
    detection_.setModel(model);
  }

  /** \brief Find neighbors with this instead of the much faster pcl::NeighborhoodSweep.
   * It is asked by several threads at once: one that does not allow that needs
   * setNumberOfThreads(1). */
  void
  setSearchMethod(const SearchPtr& search)
  {
    detection_.setSearchMethod(search);
  }

  /** \brief Work on means of points, see ShapeDetection::setResolution().
   * \param[in] metres between points; 0 (default) for the cloud's own */
  void
  setResolution(double metres)
  {
    detection_.setResolution(metres);
  }

  /** \param[in] threads 0 for all cores */
  void
  setNumberOfThreads(unsigned threads = 0)
  {
    threads_ = threads;
    detection_.setNumberOfThreads(threads);
  }

  /** \brief The names of the labels from 1 on. */
  std::vector<std::string> getClasses() const;

  /** \brief A label and its confidence for each index. */
  void label(PointLabels& labels);

private:
  /** \brief What is wrong with the input or the settings; empty if nothing is. */
  std::string findProblem() const;

  ShapeBackProjection<PointT, PointNT> detection_;
  double confidence_ = detail::usual_confidence;
  unsigned threads_ = 0;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/segmentation/impl/shape_labeling.hpp>
#endif
