/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/segmentation/instance_detection.h>

#include <cstdint>
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
   * Metres.
   */
  std::vector<float> coefficients;
  float residual = 0.0f; ///< root mean square distance of the points, metres
};

namespace detail {

/** \brief Fit a primitive to some points of a cloud by RANSAC with a fixed seed
 * (pcl::SampleConsensus), and refine it by least squares.
 * \param[in] members the points; those on edges are left out if others are enough
 * \param[in] type Plane, Cylinder, Sphere, or Auto */
PCL_SHAPE_EXPORTS ShapePrimitive fitPrimitive(const InstanceInput& input,
                                              std::vector<std::uint32_t> members,
                                              PrimitiveType type);

} // namespace detail
} // namespace pcl
