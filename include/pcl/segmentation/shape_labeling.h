/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/features/shape_model.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/shape_field_estimation.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pcl {

/** \brief A label for each point. \ingroup segmentation */
struct PointLabels {
  std::vector<std::uint32_t> labels; ///< 0 void, else the class, from 1 on
  std::vector<float> confidence;     ///< of the likeliest label, 0 to 1; 0 unknown
};

/** \brief Label the points of a cloud to train others with: planar, curved and edge, or
 * the classes of a model and edge, each with a confidence; void where it is low.
 *
 * Edges and surfaces are those of ShapeFieldEstimation. The confidence estimates how
 * probable it is that the label is right: see doc/labels.md. Labels are numbers, 0
 * void, then the classes in the order of getClasses().
 *
 * Neighbors are found among all points of the input, also if indices are set.
 * Errors (those of ShapeFieldEstimation; a field of another cloud or without classes; a
 * confidence out of [0, 1]; a model with a class called edge) are reported
 * by PCL_ERROR and give empty outputs. \ingroup segmentation
 */
template <typename PointT>
class ShapeLabeling : public ShapeFieldUser<PointT> {
public:
  using Ptr = shared_ptr<ShapeLabeling<PointT>>;
  using ConstPtr = shared_ptr<const ShapeLabeling<PointT>>;

  /** \brief The confidence from which labels are kept: see doc/labels.md. */
  static constexpr double default_confidence = 0.95;

  /** \brief Points of less confidence are void; in [0, 1], 0.95 by default. With 0
   * every point has a label whose class is known. */
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
    this->estimation_.setSurfaceModel(model);
  }

  const ShapeModel&
  getModel() const
  {
    return this->estimation_.getSurfaceModel();
  }

  /** \brief The names of the labels from 1 on. */
  std::vector<std::string> getClasses() const;

  /** \brief A label and its confidence for each index. */
  void label(PointLabels& labels);

private:
  double confidence_ = default_confidence;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/segmentation/impl/shape_labeling.hpp>
#endif
