// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// INAD as a user of PCL writes it.

#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/types.h>

using Normals = pcl::PointCloud<pcl::Normal>;

constexpr double outlier_rate = 2.0;

struct MeanAndDeviation {
  float mean, deviation;
};

/** \brief INAD of a point from a list of its neighbors, as a user of PCL writes it.
 * \param[in] found the point itself may be among them */
MeanAndDeviation
inadAt(const Normals& normals, const pcl::Indices& found, pcl::index_t point);
