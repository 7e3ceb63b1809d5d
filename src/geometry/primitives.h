// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include "instances/smooth_pieces.h"

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/features/neighborhood_sweep.h>

#include <Eigen/Core>

namespace pcl::segmentation {

/** \brief The coefficients of the same primitive with normal or axis of length 1, the
 * point of a cylinder's axis nearest to the origin, and a positive radius. */
void normalize(ShapePrimitive& primitive);

/** \brief The primitive in a unit that is so many times smaller. */
void enlarge(float times, ShapePrimitive& primitive);

/** \brief The nearest point of a primitive. */
Eigen::Vector3f footOn(const ShapePrimitive& primitive, const Eigen::Vector3f& point);

/** \brief The normal of a primitive at the foot of a point; the sign is any. */
Eigen::Vector3f normalOf(const ShapePrimitive& primitive, const Eigen::Vector3f& point);

/** \brief Some points of a surface, to fit an equation to: about one of them, in units
 * of the distance between them, as PCL's fits have limits of their own. */
struct PrimitiveSample {
  using Points = pcl::PointCloud<pcl::PointXYZ>;
  using Normals = pcl::PointCloud<pcl::Normal>;

  Points::Ptr points = pcl::make_shared<Points>();
  Normals::Ptr normals = pcl::make_shared<Normals>();
  double tolerance = 0.0;       ///< how far a point may be off the surface
  double first_tolerance = 0.0; ///< and off one through few points, but for a plane
};

/** \brief The plane, cylinder or sphere that most points are on (RANSAC with a fixed
 * seed), refined by least squares. Its type is None if there is none; the residual is
 * that of all points. */
ShapePrimitive fitTo(const PrimitiveSample& sample, PrimitiveType type);

/** \brief Fit a primitive to the points anew by least squares. */
void refine(const PrimitiveSample& sample, ShapePrimitive& primitive);

/** \brief Root mean square distance of the points from the cone nearest to them;
 * infinite if there is none. */
double coneResidual(const PrimitiveSample& sample);

} // namespace pcl::segmentation
