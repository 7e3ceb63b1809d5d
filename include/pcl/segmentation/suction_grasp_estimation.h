/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/segmentation/shape_field_estimation.h>

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pcl {

/** \brief A round suction cup with a soft lip. */
struct SuctionCup {
  double radius = 0.01;    ///< of the lip, meters
  double compliance = 0.2; ///< how far the lip may bend out of its plane, in radii
};

/** \brief Why a cup leaks. */
enum class SealProblem : std::uint8_t {
  Border,   ///< the surface ends, or has a hole, under the cup
  Edge,     ///< an edge is under the cup
  Obstacle, ///< something stands on the surface, or before it, in the cup's way
  Bent,     ///< the lip would have to bend further than it can
  Rough     ///< the surface is neither flat nor of one curvature
};

/** \brief A lower-case English word, e.g. "border". */
PCL_SHAPE_EXPORTS const char* nameOf(SealProblem problem);

/** \brief A place for a suction cup. Lengths in meters. \ingroup segmentation */
struct SuctionGrasp {
  Eigen::Vector3f position = Eigen::Vector3f::Zero(); ///< on the surface
  Eigen::Vector3f approach = Eigen::Vector3f::Zero(); ///< unit, into the surface
  float score = 0.0f;                ///< 0 to 1; above 0.5 if and only if it seals
  std::vector<SealProblem> problems; ///< none if it seals

  std::uint32_t surface = 0; ///< the class looked for: 1 planar, 2 curved
  float likelihood = 0.0f;   ///< of this class, mean under the cup
  float covered = 0.0f;      ///< share of the area under the cup, with its margin
  float border_distance =
      0.0f; ///< to where the surface ends; at most 2 cup radii + margin
  float edge_distance = 0.0f;     ///< to the nearest edge point, likewise
  float obstacle_distance = 0.0f; ///< across the approach, likewise
  float sag = 0.0f;               ///< by which the lip has to bend
  float sag_allowed = 0.0f;       ///< the cup's compliance, and what noise may add
  float residual = 0.0f;          ///< r.m.s. distance of the points from the surface
  float residual_allowed = 0.0f;  ///< what the noise explains
  float margin = 0.0f;            ///< how far around the cup must be free as well

  std::uint32_t starts = 0;     ///< of the mean shift that ended here
  std::uint32_t iterations = 0; ///< of it
  bool converged = false;       ///< the mean shift, before it had no iterations left
  float bandwidth = 0.0f;       ///< of the mean shift
  float moved = 0.0f;           ///< from the mode to where the cup fits

  /** \brief Whether the cup seals there: nothing speaks against it. */
  bool
  seals() const
  {
    return problems.empty();
  }
};

/** \brief Find places for a suction cup on a target.
 *
 * A planar or curved surface is back-projected; an adaptive mean shift on the
 * likelihood leads to its modes, which are moved to where the cup fits, tested for
 * whether it seals there, and ranked.
 *
 * The target is the input, or the points of setIndices() in it; the other points are
 * its surroundings: they hide, bound and obstruct the target. Surfaces are taken to
 * face the viewpoint. The radii of the back-projection follow the cloud's density; the
 * radius of the cup is the only length.
 *
 * Errors (those of ShapeFieldEstimation; a field of another cloud, or with other
 * classes; a cup radius that is not positive and finite, or for which the points are
 * too sparse: below half the median spacing; a compliance out of [0, 1]) are reported
 * by PCL_ERROR and give no grasps.
 *
 * A. Kumar, L. Behera, K. S. Venkatesh: Shape Back-Projection In 3D Scenes.
 * \ingroup segmentation
 */
template <typename PointT>
class SuctionGraspEstimation : public ShapeFieldUser<PointT> {
public:
  using Ptr = shared_ptr<SuctionGraspEstimation<PointT>>;
  using ConstPtr = shared_ptr<const SuctionGraspEstimation<PointT>>;

  /** \brief The surface to look for. ANY: both, each on its own, ranked together. */
  enum Surface { ANY, PLANAR, CURVED };

  /** \brief Choose the surface; ANY unless it is called. */
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

  /** \param[in] radius of the lip, meters; 0.01 by default */
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
    max_grasps_ = count;
  }

  std::size_t
  getMaximumGrasps() const
  {
    return max_grasps_;
  }

  /** \brief From where the cloud was seen, meters: the side of surfaces that a cup can
   * reach. Without, it is the sensor_origin_ of the cloud. */
  void
  setViewPoint(float x, float y, float z)
  {
    view_point_ = Eigen::Vector3f(x, y, z);
  }

  /** \brief The viewpoint in use, meters. */
  Eigen::Vector3f
  getViewPoint() const
  {
    if (view_point_ || !this->input_)
      return view_point_.value_or(Eigen::Vector3f::Zero());
    return this->input_->sensor_origin_.template head<3>();
  }

  /** \brief Grasps, the best first: those that seal come first. Places nearer than a
   * cup radius are given once.
   * \return false after an error, which was reported */
  bool compute(std::vector<SuctionGrasp>& grasps);

private:
  SuctionCup cup_;
  Surface surface_ = ANY;
  std::size_t max_grasps_ = 0;
  std::optional<Eigen::Vector3f> view_point_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/segmentation/impl/suction_grasp_estimation.hpp>
#endif
