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
#include <pcl/features/inad_point.h>
#include <pcl/features/sweep_index.h>
#include <pcl/pcl_shape_alignment.h>

namespace pcl {

/** \brief The inter normal angle difference (INAD) of each point: mean and standard
 * deviation of the angles between its normal and the normals of its neighbors.
 *
 * With a_ij = acos |n_i . n_j| in [0, pi/2] over the neighbors j of point i, without i
 * itself: mu_i = mean a_ij, sigma_i = sqrt(mean (a_ij - mu_i)^2), then both once more
 * over the a_ij with |a_ij - mu_i| <= c sigma_i (Kumar, Behera and Venkatesh, "Shape
 * Back-Projection in 3D Scenes"). The result is independent of the signs of the
 * normals, of rotation and of translation. On a plane it is (0, 0).
 *
 * Without a search method the neighbors come from pcl::NeighborhoodSweep, which is much
 * faster than a tree; a method given with setSearchMethod() is used as it is, and
 * several threads call it at once: use setNumberOfThreads(1) with a search that is not
 * thread-safe.
 * Normals belong to the search surface (setSearchSurface(), else the input). NaN where
 * the point or its normal is not finite, or with fewer than five neighbors, or where
 * these lie on a line through the point or at one place; the output is then not dense.
 *
 * The radius is in meters, or as setRadiusMode() says (see AdaptiveRadius).
 *
 * Bad settings (a null or empty cloud or search surface, one without a finite point,
 * normals of another number than the surface's points, an index out of range, both or
 * neither of radius and k, a radius that is not positive and finite, k above the number
 * of finite points, an outlier rate that is negative or not finite) are reported by
 * PCL_ERROR and give an empty output.
 *
 * \ingroup features
 */
template <typename PointInT, typename PointNT, typename PointOutT = pcl::INAD>
class INADEstimation : public FeatureFromNormals<PointInT, PointNT, PointOutT>,
                       public AdaptiveRadius,
                       public SweepIndexUser {
public:
  using Ptr = shared_ptr<INADEstimation<PointInT, PointNT, PointOutT>>;
  using ConstPtr = shared_ptr<const INADEstimation<PointInT, PointNT, PointOutT>>;
  using PointCloudOut = typename Feature<PointInT, PointOutT>::PointCloudOut;

  /** \param[in] threads 0 for all cores */
  explicit INADEstimation(unsigned threads = 0) : threads_(threads)
  {
    this->feature_name_ = "INADEstimation";
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

  /** \brief c: angles further than c sigma from mu are rejected, once.
   * \param[in] rate 2 by default, 0 for no rejection, not negative
   */
  void
  setOutlierRate(double rate)
  {
    outlier_rate_ = rate;
  }

  double
  getOutlierRate() const
  {
    return outlier_rate_;
  }

protected:
  bool initCompute() override;

private:
  void computeFeature(PointCloudOut& output) override;

  double outlier_rate_ = 2.0;
  unsigned threads_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/features/impl/inad.hpp>
#endif
