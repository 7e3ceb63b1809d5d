/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/features/neighborhood_sweep.h>
#include <pcl/pcl_shape_exports.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::detail {

/** \brief What is known about points that instances are made of; one entry a point. */
struct InstanceInput {
  XYZView points;
  std::vector<float> normals;    ///< three each, towards the viewpoint; NaN unknown
  std::vector<float> spacings;   ///< metres
  std::vector<float> edge;       ///< likelihood of an edge
  std::vector<float> likelihood; ///< of the class, of planar for objects; NaN unknown
  double noise = 0.0;            ///< in spacings
  unsigned threads = 0;
};

/** \brief What counts as an instance. */
struct InstanceLimits {
  double high = 0.6; ///< likelihood of a quarter of an instance's points
  double low = 0.5;  ///< likelihood of each of them
  std::size_t min_points = 100;
};

/** \brief The instance of each point, 0 and up, -1 for none; the largest is first. */
using InstanceLabels = std::vector<std::int32_t>;

/** \brief Connected components of a class over its likelihood. See doc/instances.md for
 * the steps. */
PCL_SHAPE_EXPORTS InstanceLabels findComponents(const InstanceInput& input,
                                                const InstanceLimits& limits);

/** \brief Whole objects on a support, likewise. */
PCL_SHAPE_EXPORTS InstanceLabels findObjects(const InstanceInput& input,
                                             const InstanceLimits& limits);

} // namespace pcl::detail
