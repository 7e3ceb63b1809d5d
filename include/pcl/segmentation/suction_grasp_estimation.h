/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/pcl_base.h>
#include <pcl/segmentation/shape_back_projection.h>
#include <pcl/segmentation/suction_grasp.h>

#include <optional>
#include <string>
#include <vector>

namespace pcl {

/** \brief Find places for a suction cup on a target.
 *
 * A planar or curved surface is back-projected; an adaptive mean shift on the
 * likelihood leads to its modes, which are moved to where the cup fits, tested for
 * whether it seals there, and ranked.
 *
 * The target is the input, or the points of setIndices() in it; the other points are
 * what else is there: they hide, bound and obstruct the target. Surfaces are taken to
 * face the viewpoint. The radii of the back-projection follow the cloud's density; the
 * radius of the cup is the only length.
 *
 * Errors (those of ShapeBackProjection; a cup radius that is not positive and finite,
 * or for which the points are too sparse: below half the median spacing; a compliance
 * out of [0, 1]; surfaces of another number than the input's points) are reported by
 * PCL_ERROR and give no grasps.
 *
 * A. Kumar, L. Behera, K. S. Venkatesh: Shape Back-Projection In 3D Scenes.
 * \ingroup segmentation
 */
template <typename PointT>
class SuctionGraspEstimation : public PCLBase<PointT> {
public:
  using Ptr = shared_ptr<SuctionGraspEstimation<PointT>>;
  using ConstPtr = shared_ptr<const SuctionGraspEstimation<PointT>>;
  using SearchPtr = typename pcl::search::Search<PointT>::Ptr;

  /** \brief The surface to look for. ANY: both, each on its own, ranked together. */
  enum Surface { ANY, PLANAR, CURVED };

  void
  setSurface(Surface surface)
  {
    surface_ = surface;
  }

  Surface
  getSurface() const
  {
    return surface_;
  }

  /** \param[in] radius of the lip, metres; 0.01 by default */
  void
  setCupRadius(double radius)
  {
    cup_.radius = radius;
  }

  double
  getCupRadius() const
  {
    return cup_.radius;
  }

  /** \brief How far the lip may bend out of its plane, in cup radii; 0.2 by default,
   * with which a cup seals on a cylinder of 2.5 times its radius. */
  void
  setCompliance(double compliance)
  {
    cup_.compliance = compliance;
  }

  double
  getCompliance() const
  {
    return cup_.compliance;
  }

  /** \brief How many grasps to give at most; 0 (default) for all. */
  void
  setMaximumGrasps(std::size_t count)
  {
    most_grasps_ = count;
  }

  /** \brief From where the cloud was seen, metres: the side of surfaces that a cup can
   * reach. Without, it is the sensor_origin_ of the cloud. */
  void
  setViewPoint(float x, float y, float z)
  {
    view_point_ = Eigen::Vector3f(x, y, z);
  }

  /** \brief What ShapeBackProjection::classify() gave for all points of the input, in
   * default mode with the default model: to look at several targets in one scene
   * without doing it again. Optional. */
  void
  setInputSurfaces(const shared_ptr<const Surfaces>& surfaces)
  {
    given_surfaces_ = surfaces;
  }

  /** \brief Find neighbors with this instead of pcl::NeighborhoodSweep. It is asked by
   * several threads at once: one that does not allow that needs setNumberOfThreads(1).
   */
  void
  setSearchMethod(const SearchPtr& search)
  {
    search_ = search;
  }

  /** \brief Find the surfaces on means of points, see ShapeDetection::setResolution().
   * \param[in] metres between points; 0 (default) for the cloud's own */
  void
  setResolution(double metres)
  {
    resolution_ = metres;
  }

  /** \param[in] threads 0 for all cores */
  void
  setNumberOfThreads(unsigned threads = 0)
  {
    threads_ = threads;
  }

  /** \brief Grasps, the best first: those that seal come first. Places nearer than a
   * cup radius are given once.
   * \return false after an error, which was reported */
  bool compute(std::vector<SuctionGrasp>& grasps);

private:
  std::string findProblem() const;

  /** \brief Surfaces of all points of the input; null after an error, which was
   * reported. */
  shared_ptr<const Surfaces> classified() const;

  detail::GraspTarget targetOf(const Surfaces& surfaces) const;

  std::vector<detail::GraspSurface> lookedFor(const Surfaces& surfaces) const;

  void reportProblem(const std::string& problem) const;

  SuctionCup cup_;
  Surface surface_ = ANY;
  std::size_t most_grasps_ = 0;
  std::optional<Eigen::Vector3f> view_point_;
  shared_ptr<const Surfaces> given_surfaces_;
  double resolution_ = 0.0;
  SearchPtr search_;
  unsigned threads_ = 0;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/segmentation/impl/suction_grasp_estimation.hpp>
#endif
