/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include "primitive_geometry.h"
#include "surface_graph.h"

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

namespace pcl::segmentation {

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
