/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/segmentation/shape_back_projection.h>
#include <pcl/segmentation/shape_primitive.h>

#include <optional>
#include <string>
#include <vector>

namespace pcl {

/** \brief One instance, and what it is like. \ingroup segmentation */
struct ShapeInstance {
  pcl::Indices indices;                       ///< of its points, ascending
  Eigen::Vector3f centroid{0.0f, 0.0f, 0.0f}; ///< metres
  /** \brief The share of its points that are of each class, in the order of
   * ShapeInstanceSegmentation::getClasses(); points on edges count only if there are no
   * others. */
  std::vector<float> shares;
  ShapePrimitive primitive; ///< if one was asked for
};

/** \brief All instances of a kind of surface in one go, without saying how many there
 * are: all planar or curved parts, those of a class of an own model, or whole objects.
 *
 * A class: connected components of its likelihood (hysteresis: components of points
 * above a low threshold in which enough are above a high one), bounded by edges, steps
 * and turns. Objects: the faces of everything but the planes that carry others, joined
 * across convex creases and not across concave ones. See doc/instances.md.
 *
 * Instances are sorted by their number of points, the largest first. Radii follow the
 * density of the points: it works as ShapeBackProjection does by default.
 *
 * Errors (those of ShapeBackProjection; a class that the model does not have;
 * thresholds that are not 0 <= low <= high <= 1; no points wanted) are reported by
 * PCL_ERROR and give empty outputs.
 *
 * While RANSAC runs in segment(), PCL's console is silent in the whole process, for
 * samples that it rejects are errors to PCL. Several may run at the same time; but what
 * other threads report meanwhile is not printed, and a verbosity level that they set is
 * lost.
 * \ingroup segmentation
 */
template <typename PointT>
class ShapeInstanceSegmentation : public PCLBase<PointT> {
public:
  using Ptr = shared_ptr<ShapeInstanceSegmentation<PointT>>;
  using ConstPtr = shared_ptr<const ShapeInstanceSegmentation<PointT>>;

  /** \brief What to look for: "curved" (default), "planar", a class of the model that
   * was set, or "object" for whole objects. */
  void
  setClass(const std::string& name)
  {
    class_ = name;
  }

  std::string
  getClass() const
  {
    return class_;
  }

  /** \brief A model made in DENSITY mode, with several classes. Objects need one of
   * them to be "planar". */
  void
  setModel(const ShapeModel& model)
  {
    back_projection_.setModel(model);
  }

  /** \brief The names of the classes, in the order of ShapeInstance::shares. */
  std::vector<std::string>
  getClasses() const
  {
    return back_projection_.getClasses();
  }

  /** \brief The likelihoods of hysteresis, not used for objects. \param[in] high of
   * some points of an instance (0.6) \param[in] low of every point (0.5) */
  void
  setThresholds(double high, double low)
  {
    limits_.high = high;
    limits_.low = low;
  }

  /** \brief Instances with fewer points are left out; 100 by default: a disc of three
   * local spacings in radius. */
  void
  setMinPoints(std::size_t points)
  {
    limits_.min_points = points;
  }

  /** \brief A primitive to fit to each instance; none by default. */
  void
  setPrimitive(PrimitiveType type)
  {
    primitive_ = type;
  }

  /** \brief Where the points were seen from, which tells convex from concave: the
   * cloud's sensor_origin_ unless it is set. Metres. */
  void
  setViewPoint(float x, float y, float z)
  {
    view_point_ = Eigen::Vector3f(x, y, z);
  }

  /** \brief Work on means of points, see ShapeDetection::setResolution(): each point is
   * in the instance of the nearest mean. setMinPoints() and the shares then count
   * means. \param[in] metres between points; 0 (default) for the cloud's own */
  void
  setResolution(double metres)
  {
    back_projection_.setResolution(metres);
  }

  /** \param[in] threads 0 for all cores */
  void
  setNumberOfThreads(unsigned threads = 0)
  {
    threads_ = threads;
  }

  /** \brief The points of each instance; there may be none.
   * \return false after an error message, for bad input or a bad setting */
  bool segment(std::vector<pcl::PointIndices>& instances);

  /** \brief The instances with their properties; likewise. */
  bool segment(std::vector<ShapeInstance>& instances);

private:
  /** \brief What is wrong with the settings; empty if nothing is. */
  std::string findProblem() const;

  /** \brief The position of a class in getClasses(), or their number. */
  std::size_t positionOfClass(const std::string& name) const;

  /** \brief The points that instances are made of, three coordinates each: those of the
   * indices, thinned out to the resolution. */
  std::vector<float> workedOn() const;

  void setUpBackProjection(const std::vector<float>& positions);

  detail::InstanceInput inputOf(Surfaces& surfaces,
                                const std::vector<float>& positions) const;

  /** \brief For each index which of the points worked on it stands for, -1 none. */
  std::vector<std::int32_t> representatives(const detail::InstanceInput& input) const;

  /** \brief All but the points. \param[in] members of the points worked on */
  ShapeInstance describe(const std::vector<std::uint32_t>& members,
                         const detail::InstanceInput& input,
                         const Surfaces& surfaces) const;

  void setPoints(const std::vector<std::int32_t>& labels,
                 std::vector<ShapeInstance>& instances) const;

  ShapeBackProjection<PointT> back_projection_;
  std::string class_ = "curved";
  detail::InstanceLimits limits_;
  PrimitiveType primitive_ = PrimitiveType::None;
  std::optional<Eigen::Vector3f> view_point_;
  unsigned threads_ = 0;

  using PCLBase<PointT>::input_;
  using PCLBase<PointT>::indices_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/segmentation/impl/shape_instance_segmentation.hpp>
#endif
