// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Says why points got no answer, when they are many.

#pragma once

#include "cli/report.h"

#include <pcl/features/inad_point.h>
#include <pcl/features/shape_model.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/shape_field.h>

#include <string>

namespace pcl::app {

/** \brief If more than 5 % of the finite points are unknown, a line on standard error
 * that says why, and the counts by reason in the section "unknown". */
void reportUnknown(const std::string& path,
                   const pcl::ShapeField& field,
                   unsigned threads,
                   Report& report);

/** \brief The same for INAD of a cloud. */
void reportUnknown(const std::string& path,
                   const pcl::PointCloud<pcl::PointXYZ>& points,
                   const pcl::PointCloud<pcl::INAD>& inad,
                   const pcl::INADParameters& parameters,
                   unsigned threads,
                   Report& report);

} // namespace pcl::app
