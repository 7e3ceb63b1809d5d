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
#include <pcl/pcl_shape_alignment.h>
#include <pcl/point_types.h>

#include <Eigen/Core>

#include <vector>

namespace pcl {

/** \brief What counts as ground. \ingroup segmentation */
struct GroundParameters {
  Eigen::Vector3f up = Eigen::Vector3f::UnitZ(); ///< roughly; of any length but 0
  float max_slope = 0.35f;                       ///< of the ground, radians: 20 degrees
  float max_step = 0.2f;      ///< that ground continues over, meters: a high curb
  float threshold = 0.5f;     ///< the likelihood from which a point is ground
  float sensor_height = 0.0f; ///< above the ground, meters; 0 unknown
};

/** \brief Find the ground in a vehicle's laser scan: road, pavement, yards.
 *
 * The lowest surface in each of a few thousand cells is back-projected to a plane by
 * the angles between its normal and its neighbors'. Level and planar ones that connect,
 * also over a curb, are the ground; a point belongs to it if it lies on the ground of
 * its cell or of one nearby. Cells follow the density: around a spinning laser they
 * grow with the range, elsewhere they are squares of some eight points. doc/ground.md
 * has the steps.
 *
 * The sensor is at the cloud's sensor_origin_, and ground is below it if it is in or
 * near the cloud; what hangs above the ground, such as a ceiling or a bridge, is none.
 * Points at the same place count once. Points with NaN, and fillers for rays that did
 * not return (many points at 0 or at the sensor), have the likelihood NaN and are not
 * ground. Errors (no cloud, no finite point, bad settings) are reported by
 * PCL_ERROR and give empty outputs; a cloud without ground gives a warning.
 *
 * compute() and segment() silence PCL's console in the whole process while they run
 * RANSAC, which logs rejected samples as errors. Several may run at the same time, but
 * what other threads report meanwhile is not printed, and a verbosity level that they
 * set is lost.
 * \ingroup segmentation
 */
template <typename PointT>
class ShapeGroundSegmentation : public PCLBase<PointT> {
public:
  using Ptr = shared_ptr<ShapeGroundSegmentation<PointT>>;
  using ConstPtr = shared_ptr<const ShapeGroundSegmentation<PointT>>;

  /** \param[in] up where up is, roughly; of any length but 0. (0, 0, 1) by default */
  void
  setUp(const Eigen::Vector3f& up)
  {
    parameters_.up = up;
  }

  const Eigen::Vector3f&
  getUp() const
  {
    return parameters_.up;
  }

  /** \param[in] angle the steepest ground against its plane in the large, or up where
   * that is no steeper than half of this; radians, below pi / 2; 20 degrees
   * by default */
  void
  setMaxSlope(float angle)
  {
    parameters_.max_slope = angle;
  }

  float
  getMaxSlope() const
  {
    return parameters_.max_slope;
  }

  /** \param[in] step the highest curb that ground continues over, meters; 0.2 by
   * default. What stands out by more than half of it is not ground, whatever the noise.
   */
  void
  setMaxStep(float step)
  {
    parameters_.max_step = step;
  }

  float
  getMaxStep() const
  {
    return parameters_.max_step;
  }

  /** \brief The likelihood from which a point is ground, 0 to 1; 0.5 by default. */
  void
  setThreshold(float threshold)
  {
    parameters_.threshold = threshold;
  }

  float
  getThreshold() const
  {
    return parameters_.threshold;
  }

  /** \brief How high the sensor is above the ground, meters, to two steps; 0, the
   * default, if that is not known: ground is below a sensor that is in or near the
   * cloud. Needed where several levels are below it, as on a bridge. */
  void
  setSensorHeight(float height)
  {
    parameters_.sensor_height = height;
  }

  float
  getSensorHeight() const
  {
    return parameters_.sensor_height;
  }

  /** \param[in] threads 0 for all cores */
  void
  setNumberOfThreads(unsigned threads = 0)
  {
    threads_ = threads;
  }

  unsigned
  getNumberOfThreads() const
  {
    return threads_;
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
  GroundParameters parameters_;
  unsigned threads_ = 0;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/segmentation/impl/shape_ground_segmentation.hpp>
#endif
