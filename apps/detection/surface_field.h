// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The field of a cloud with its surfaces, for the apps that have one method only.

#pragma once

#include "cli/report.h"
#include "io/cloud_file.h"

#include <pcl/features/shape_model.h>
#include <pcl/segmentation/shape_field.h>

#include <optional>

namespace pcl::app {

/** \brief What the default method finds in a cloud. If many points are unknown, or
 * means stand for them that were not asked for, it is said why. \throws InputError with
 * the reason if the cloud is refused */
pcl::ShapeField::ConstPtr
surfaceFieldOf(const CloudFile& file,
               const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& points,
               const std::optional<pcl::ShapeModel>& model,
               double resolution,
               unsigned threads,
               Report& report);

} // namespace pcl::app
