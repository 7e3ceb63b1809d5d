/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/segmentation/shape_primitive.h>

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

} // namespace pcl::segmentation
