// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The estimations that other files compile: each use would compile them again.

#pragma once

#include "common/point_types.h"

#include <pcl/features/inad.h>
#include <pcl/features/normal_3d_sweep.h>
#include <pcl/impl/instantiate.hpp>
#include <pcl/segmentation/shape_field_estimation.h>

#define PCL_INSTANTIATE_CompiledNormals(T, NT)                                         \
  extern template class pcl::NormalEstimationSweep<T, NT>;
#define PCL_INSTANTIATE_CompiledINAD(T, NT)                                            \
  extern template class pcl::INADEstimation<T, NT, pcl::INAD>;
#define PCL_INSTANTIATE_CompiledField(T)                                               \
  extern template class pcl::ShapeFieldEstimation<T>;                                  \
  extern template class pcl::ShapeFieldUser<T>;

PCL_INSTANTIATE_PRODUCT(CompiledNormals,
                        (PCL_SHAPE_POINT_TYPES)(PCL_SHAPE_NORMAL_TYPES))
PCL_INSTANTIATE_PRODUCT(CompiledINAD, (PCL_SHAPE_POINT_TYPES)(PCL_SHAPE_NORMAL_TYPES))
PCL_INSTANTIATE(CompiledField, PCL_SHAPE_POINT_TYPES)
