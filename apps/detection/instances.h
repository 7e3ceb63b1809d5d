// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Instances that were found, as a field and counts.

#pragma once

#include "cli/report.h"
#include "io/cloud_file.h"

#include <pcl/segmentation/shape_instance_segmentation.h>

namespace pcl::app {

using InstanceSegmentation = pcl::ShapeInstanceSegmentation<pcl::PointXYZ>;

/** \brief Add the field instance. \param[in] segmentation ready for segment()
 * \throws InputError with the reason if the cloud is refused */
void addInstances(CloudFile& file, InstanceSegmentation& segmentation, Report& report);

} // namespace pcl::app
