// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// ShapeGroundSegmentation for the point types of the library.

#include "common/point_types.h"

#include <pcl/impl/instantiate.hpp>
#include <pcl/segmentation/impl/shape_ground_segmentation.hpp>

PCL_INSTANTIATE(ShapeGroundSegmentation, PCL_SHAPE_POINT_TYPES)
