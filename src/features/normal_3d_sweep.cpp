// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// NormalEstimationSweep for the point types of the library.

#include "common/point_types.h"

#include <pcl/impl/instantiate.hpp>
#include <pcl/features/impl/normal_3d_sweep.hpp>

PCL_INSTANTIATE_PRODUCT(NormalEstimationSweep,
                        (PCL_SHAPE_POINT_TYPES)(PCL_SHAPE_NORMAL_TYPES))
