// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// INADEstimation for the point types of the library.

#include "common/point_types.h"

#include <pcl/impl/instantiate.hpp>
#include <pcl/features/impl/inad.hpp>

PCL_INSTANTIATE_PRODUCT(INADEstimation,
                        (PCL_SHAPE_POINT_TYPES)(PCL_SHAPE_NORMAL_TYPES)((pcl::INAD)))
