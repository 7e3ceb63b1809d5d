// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "common/point_types.h"

#include <pcl/impl/instantiate.hpp>
#include <pcl/segmentation/impl/shape_instance_segmentation.hpp>

PCL_INSTANTIATE(ShapeInstanceSegmentation, PCL_SHAPE_POINT_TYPES)
