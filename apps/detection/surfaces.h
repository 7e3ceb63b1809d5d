// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The results of back-projection, as fields.

#pragma once

#include "cli/report.h"
#include "detection/detection.h"
#include "io/cloud_file.h"

#include <pcl/segmentation/shape_back_projection.h>

namespace pcl::app {

using SurfaceDetector = pcl::ShapeBackProjection<pcl::PointXYZ, pcl::Normal>;

/** \brief Add the fields likelihood and surface, and with a model of several classes
 * the likelihood of each. \param[in] detector ready for compute(), with a field for the
 * default method */
void addSurfaces(CloudFile& file,
                 SurfaceDetector& detector,
                 const DetectionSettings& settings,
                 Report& report);

} // namespace pcl::app
