/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/features/adaptive_radius.h>
#include <pcl/features/feature.h>
#include <pcl/features/sweep_index.h>
#include <pcl/pcl_shape_alignment.h>

#include <vector>

namespace pcl {

/** \brief Surface normals and curvatures, used as NormalEstimationOMP is.
 *
 * Same inputs, same results (normals within 1e-4 rad at the 99th percentile), but
 * without a search method the neighbors come from pcl::NeighborhoodSweep, which is much
 * faster than a tree; a method given with setSearchMethod() is used as it is, and
 * several threads call it at once: use setNumberOfThreads(1) with a search that is not
 * thread-safe.
 * Normals are flipped towards the viewpoint: the cloud's sensor origin, or
 * setViewPoint().
 *
 * Unlike NormalEstimationOMP, a point with fewer than five neighbors besides itself, or
 * with neighbors on a line or a point, has the normal NaN, and the output is then not
 * dense whatever the input says.
 *
 * The radius is in meters, or as setRadiusMode() says (see AdaptiveRadius).
 *
 * Bad settings (a null or empty cloud or search surface, one without a finite point, an
 * index out of range, both or neither of radius and k, a radius that is not positive
 * and finite, k above the number of finite points) are reported by PCL_ERROR and give
 * an empty output. \ingroup features
 */
template <typename PointInT, typename PointOutT>
class NormalEstimationSweep : public Feature<PointInT, PointOutT>,
                              public AdaptiveRadius,
                              public SweepIndexUser {
public:
  using Ptr = shared_ptr<NormalEstimationSweep<PointInT, PointOutT>>;
  using ConstPtr = shared_ptr<const NormalEstimationSweep<PointInT, PointOutT>>;
  using PointCloudOut = typename Feature<PointInT, PointOutT>::PointCloudOut;

  /** \param[in] threads 0 for all cores */
  explicit NormalEstimationSweep(unsigned threads = 0) : threads_(threads)
  {
    this->feature_name_ = "NormalEstimationSweep";
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

  /** \brief Flip the normals towards this point, meters, instead of the sensor origin.
   */
  void
  setViewPoint(float x, float y, float z)
  {
    viewpoint_ = Eigen::Vector3f(x, y, z);
    use_sensor_origin_ = false;
  }

  /** \brief The point that normals are flipped towards, meters. */
  void
  getViewPoint(float& x, float& y, float& z) const
  {
    const Eigen::Vector3f point = viewPoint();
    x = point.x();
    y = point.y();
    z = point.z();
  }

  /** \brief Flip the normals towards the cloud's sensor origin again, the default. */
  void
  useSensorOriginAsViewPoint()
  {
    use_sensor_origin_ = true;
  }

protected:
  bool initCompute() override;

private:
  void computeFeature(PointCloudOut& output) override;

  Eigen::Vector3f
  viewPoint() const
  {
    return use_sensor_origin_ && this->input_
               ? Eigen::Vector3f(this->input_->sensor_origin_.template head<3>())
               : viewpoint_;
  }

  Eigen::Vector3f viewpoint_ = Eigen::Vector3f::Zero();
  bool use_sensor_origin_ = true;
  unsigned threads_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/features/impl/normal_3d_sweep.hpp>
#endif
