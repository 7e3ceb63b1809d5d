// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Planes, cylinders, spheres and cones: their geometry, and fits to points by RANSAC.

#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/shape_instance_segmentation.h>

#include <Eigen/Core>

namespace pcl::segmentation {

/** \brief Change the unit of a primitive to one that is so many times smaller. */
void enlarge(float times, ShapePrimitive& primitive);

/** \brief The nearest point of a primitive. */
Eigen::Vector3f footOn(const ShapePrimitive& primitive, const Eigen::Vector3f& point);

/** \brief The normal of a primitive at the foot of a point, of either sign. */
Eigen::Vector3f normalOf(const ShapePrimitive& primitive, const Eigen::Vector3f& point);

/** \brief Some points of a surface, to fit a primitive to. They are near the origin, in
 * units of the distance between them, because PCL's fits have limits of their own. */
struct PrimitiveSample {
  void
  add(const Eigen::Vector3f& point, const Eigen::Vector3f& normal)
  {
    points->push_back({point.x(), point.y(), point.z()});
    normals->push_back({normal.x(), normal.y(), normal.z()});
  }

  pcl::PointCloud<pcl::PointXYZ>::Ptr points =
      pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  pcl::PointCloud<pcl::Normal>::Ptr normals =
      pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  double tolerance = 0.0;       ///< how far a point may be off the surface
  double first_tolerance = 0.0; ///< likewise while few points determine a curved one
  float min_cosine = -1.0f;     ///< of the points' normals and a plane's; -1 any
};

/** \brief The plane, cylinder or sphere that most points are on (RANSAC with a fixed
 * seed), refined by least squares. Normals and axes have length 1, radii are positive,
 * and the point of a cylinder's axis is the one nearest to the origin. The residual is
 * that of all points. \return type None if nothing fits */
ShapePrimitive fitTo(const PrimitiveSample& sample, PrimitiveType type);

/** \brief Fit a primitive to the points anew by least squares. */
void refine(const PrimitiveSample& sample, ShapePrimitive& primitive);

/** \brief Root mean square distance of the points from the cone nearest to them;
 * infinite if there is none. */
double coneResidual(const PrimitiveSample& sample);

} // namespace pcl::segmentation
