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
#include <pcl/segmentation/adaptive_detection.h>

#include <vector>

namespace pcl::segmentation {

/** \brief Where crease points are. Nothing is copied. */
inline XYZView
positionsOf(const std::vector<CreasePoint>& creases)
{
  return {creases.empty() ? nullptr : creases[0].position.data(),
          sizeof(CreasePoint) / sizeof(float),
          creases.size()};
}

} // namespace pcl::segmentation
