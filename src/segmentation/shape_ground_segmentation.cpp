/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "../features/point_types.h"

#include <pcl/impl/instantiate.hpp>
#include <pcl/segmentation/impl/shape_ground_segmentation.hpp>

PCL_INSTANTIATE(ShapeGroundSegmentation, PCL_SHAPE_POINT_TYPES)
