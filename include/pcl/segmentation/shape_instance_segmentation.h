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
#include <pcl/features/shape_model.h>
#include <pcl/segmentation/shape_field_estimation.h>

#include <optional>
#include <string>
#include <vector>

namespace pcl {

/** \brief What an instance may be fitted with. Auto: the one that fits best. */
enum class PrimitiveType { None, Auto, Plane, Cylinder, Sphere };

/** \brief A plane, cylinder or sphere that was fitted to points. \ingroup segmentation
 */
struct ShapePrimitive {
  PrimitiveType type = PrimitiveType::None; ///< None if nothing could be fitted
  /** As PCL's models order them. Plane: a, b, c, d of ax + by + cz + d = 0. Cylinder: a
   * point of the axis, its direction (unit), the radius. Sphere: center, radius.
   * Meters. */
  std::vector<float> coefficients;
  float residual = 0.0f; ///< root mean square distance of the points, meters
};

/** \brief One instance, and what it is like. \ingroup segmentation */
struct ShapeInstance {
  pcl::Indices indices;                       ///< of its points, ascending
  Eigen::Vector3f centroid{0.0f, 0.0f, 0.0f}; ///< meters
  /** \brief The share of its points that are of each class, in the order of
   * ShapeInstanceSegmentation::getClasses(); points on edges count only if there are no
   * others. */
  std::vector<float> shares;
  ShapePrimitive primitive; ///< if one was asked for
};

/** \brief What counts as an instance. */
struct InstanceLimits {
  double high = 0.6;            ///< likelihood of a quarter of an instance's points
  double low = 0.5;             ///< likelihood of each of them
  std::size_t min_points = 100; ///< fewer are no instance
};

/** \brief All instances of a kind of surface in one go, without saying how many there
 * are: all planar or curved parts, those of a class of your own model, or whole
 * objects.
 *
 * A class: connected components of its likelihood (hysteresis: components of points
 * above a low threshold in which enough are above a high one), bounded by edges, steps
 * and turns. Objects: the faces of everything but the planes that carry others, joined
 * across convex creases and not across concave ones. See doc/instances.md.
 *
 * Instances are sorted by their number of points, the largest first. Radii follow the
 * density of the points (see ShapeFieldEstimation).
 *
 * Errors (those of ShapeFieldEstimation; a field of another cloud or without classes; a
 * class that the model does not have; thresholds that are not 0 <= low <= high <= 1; no
 * points wanted) are reported by PCL_ERROR and give empty outputs.
 *
 * While RANSAC runs in segment(), PCL's console is silent in the whole process, because
 * PCL logs rejected RANSAC samples as errors. Several may run at the same time; but
 * what other threads report meanwhile is not printed, and a verbosity level that they
 * set is lost. \ingroup segmentation
 */
template <typename PointT>
class ShapeInstanceSegmentation : public ShapeFieldUser<PointT> {
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
    this->estimation_.setSurfaceModel(model);
  }

  const ShapeModel&
  getModel() const
  {
    return this->estimation_.getSurfaceModel();
  }

  /** \brief The names of the classes, in the order of ShapeInstance::shares. */
  std::vector<std::string> getClasses() const;

  /** \brief The likelihoods of hysteresis, not used for objects. \param[in] high of
   * some points of an instance (0.6) \param[in] low of every point (0.5) */
  void
  setThresholds(double high, double low)
  {
    limits_.high = high;
    limits_.low = low;
  }

  /** \brief Instances with fewer points are left out; 100 by default: a disc of three
   * local spacings in radius. With a resolution voxel means count, also with one that
   * is chosen automatically: see ShapeField::resolution. */
  void
  setMinPoints(std::size_t points)
  {
    limits_.min_points = points;
  }

  const InstanceLimits&
  getLimits() const
  {
    return limits_;
  }

  /** \brief A primitive to fit to each instance; none by default. */
  void
  setPrimitive(PrimitiveType type)
  {
    primitive_ = type;
  }

  PrimitiveType
  getPrimitive() const
  {
    return primitive_;
  }

  /** \brief Where the points were seen from, which tells convex from concave: the
   * cloud's sensor_origin_ unless it is set. Meters. */
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

  /** \brief The points of each instance; there may be none.
   * \return false after an error message, for bad input or a bad setting */
  bool segment(std::vector<pcl::PointIndices>& instances);

  /** \brief The instances with their properties; false after an error. */
  bool segment(std::vector<ShapeInstance>& instances);

private:
  std::string class_ = "curved";
  InstanceLimits limits_;
  PrimitiveType primitive_ = PrimitiveType::None;
  std::optional<Eigen::Vector3f> view_point_;

  using PCLBase<PointT>::input_;
  using PCLBase<PointT>::indices_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/segmentation/impl/shape_instance_segmentation.hpp>
#endif
