/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/PointIndices.h>
#include <pcl/pcl_base.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/ground_detection.h>

#include <Eigen/Core>

#include <vector>

namespace pcl {

/** \brief Find the ground in a vehicle's laser scan: road, pavement, yards.
 *
 * The lowest surface in each of a few thousand cells is back-projected to a plane by
 * the angles between its normal and its neighbors'. Level and planar ones that connect,
 * also over a kerb, are the ground; a point belongs to it if it is on one near. Cells
 * follow the density: around a spinning laser they grow with the range, elsewhere they
 * are squares with some eight points. doc/ground.md has the steps.
 *
 * The sensor is at the cloud's sensor_origin_. Points with NaN have the likelihood NaN
 * and are no ground. Errors (no cloud, no finite point, bad settings) are reported by
 * PCL_ERROR and give empty outputs; a cloud without ground gives a warning.
 *
 * While RANSAC runs in compute() and segment(), PCL's console is silent in the whole
 * process, for samples that it rejects are errors to PCL. Several may run at the same
 * time; but what other threads report meanwhile is not printed, and a verbosity level
 * that they set is lost.
 * \ingroup segmentation
 */
template <typename PointT>
class ShapeGroundSegmentation : public PCLBase<PointT> {
public:
  using Ptr = shared_ptr<ShapeGroundSegmentation<PointT>>;
  using ConstPtr = shared_ptr<const ShapeGroundSegmentation<PointT>>;

  /** \param[in] up where up is, roughly; of any length. (0, 0, 1) by default */
  void
  setUp(const Eigen::Vector3f& up)
  {
    parameters_.up = {up.x(), up.y(), up.z()};
  }

  /** \param[in] angle the steepest ground towards up, radians, below pi / 2; 20 degrees
   * by default */
  void
  setMaxSlope(float angle)
  {
    parameters_.max_slope = angle;
  }

  /** \param[in] step the highest kerb that ground continues over, metres (0.2). What
   * stands out by more than half of it is no ground, whatever the noise. */
  void
  setMaxStep(float step)
  {
    parameters_.max_step = step;
  }

  /** \brief The likelihood from which a point is ground, in [0, 1]; 0.5 by default. */
  void
  setThreshold(float threshold)
  {
    threshold_ = threshold;
  }

  /** \param[in] threads 0 for all cores */
  void
  setNumberOfThreads(unsigned threads = 0)
  {
    threads_ = threads;
  }

  const GroundParameters&
  getParameters() const
  {
    return parameters_;
  }

  /** \brief The likelihood of ground, one for each index; NaN is unknown. */
  void compute(std::vector<float>& likelihood);

  /** \brief The points of the ground; there may be none.
   * \return false after an error message, for bad input or a bad setting */
  bool segment(pcl::PointIndices& ground);

private:
  std::string findProblem();

  GroundParameters parameters_;
  float threshold_ = 0.5f;
  unsigned threads_ = 0;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/segmentation/impl/shape_ground_segmentation.hpp>
#endif
