// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Computes normals and INAD of a cloud, stage by stage.

#pragma once

#include "cli/arguments.h"
#include "cli/report.h"
#include "io/cloud_file.h"

#include <pcl/features/inad_point.h>
#include <pcl/features/shape_model.h>

namespace pcl::app {

/** \brief A cloud with what the classes of pcl_shape need of it. */
struct InadCloud {
  pcl::PointCloud<pcl::PointXYZ>::ConstPtr points;
  pcl::PointCloud<pcl::Normal>::ConstPtr normals;
  pcl::PointCloud<pcl::INAD>::ConstPtr inad;
};

/** \brief From a file to INAD at all its points: with its own normals if -use_normals
 * is given, else with estimated ones, which are set as fields if -normals is given. The
 * sizes of the cloud, the parameters and the times of the stages are reported. */
InadCloud estimateInad(CloudFile& file,
                       const Arguments& arguments,
                       const INADParameters& parameters,
                       Report& report);

/** \brief Set normals of the cloud, over the radius for its noise, and their curvature.
 * Equal points count once. */
void addNormals(CloudFile& file,
                const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& points,
                const INADParameters& parameters,
                unsigned threads);

} // namespace pcl::app
