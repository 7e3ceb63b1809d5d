// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The point types that the classes are compiled for.

#pragma once

#include <pcl/point_types.h>

#ifdef PCL_SHAPE_ONLY_CORE_POINT_TYPES // PCL_SHAPE_ONLY_DETECTION of CMake
#define PCL_SHAPE_POINT_TYPES (pcl::PointXYZ)
#define PCL_SHAPE_NORMAL_TYPES (pcl::Normal)
#else
// Others need PCL_NO_PRECOMPILE.
// clang-format off
#define PCL_SHAPE_POINT_TYPES \
  (pcl::PointXYZ)(pcl::PointXYZI)(pcl::PointXYZRGB)(pcl::PointXYZRGBA)(pcl::PointXYZL) \
  (pcl::PointXYZRGBL)(pcl::PointNormal)(pcl::PointXYZINormal)(pcl::PointXYZRGBNormal) \
  (pcl::PointXYZLNormal)
#define PCL_SHAPE_NORMAL_TYPES \
  (pcl::Normal)(pcl::PointNormal)(pcl::PointXYZRGBNormal)
// clang-format on
#endif
